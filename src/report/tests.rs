use super::*;
use crate::judge::{Golden, judge};
use crate::testing::{Random, grid, row};

#[test]
fn a_number_has_no_more_than_its_digits() {
    for (value, digits, text) in [
        (1.23456789, 6, "1.23457"),
        (1.23456789, 2, "1.2"),
        (123.456, 6, "123.456"),
        (123.456, 4, "123.5"),
        (0.00123456, 3, "0.00123"),
        (2.0 / 3.0, 9, "0.666666667"),
        (9.99999999, 6, "10"),
    ] {
        assert_eq!(number(value, digits), text);
    }
}

#[test]
fn a_number_has_no_zeros_behind() {
    for (value, text) in [
        (1.0, "1"),
        (2.5, "2.5"),
        (100.0, "100"),
        (0.1, "0.1"),
        (1e6, "1000000"),
        (1.5e9, "1.5e9"),
        (2e-7, "2e−7"),
    ] {
        assert_eq!(number(value, 6), text);
    }
}

#[test]
fn nothing_is_0_and_has_no_sign() {
    assert_eq!(number(0.0, 6), "0");
    assert_eq!(number(-0.0, 6), "0");
}

#[test]
fn minus_is_a_minus_sign_in_number_and_exponent() {
    assert_eq!(number(-1.5, 6), "−1.5");
    assert_eq!(number(-1.5e-9, 6), "−1.5e−9");
    assert_eq!(number(f64::NEG_INFINITY, 6), "−inf");
}

#[test]
fn what_is_no_number_is_said_to_be_none() {
    assert_eq!(number(f64::NAN, 6), "NaN");
    assert_eq!(number(f64::INFINITY, 6), "inf");
}

#[test]
fn a_number_read_back_is_right_to_its_digits() {
    let mut random = Random(1);
    for _ in 0..5000 {
        let value = random.coordinate() * 10f64.powf(20.0 * random.coordinate());
        for digits in 1..10 {
            let text = number(value, digits).replace('−', "-");
            let back: f64 = text.parse().unwrap();
            let off = (back - value).abs() / value.abs();
            assert!(
                off <= 0.500001 * 10f64.powi(1 - digits as i32),
                "{value}: {text}"
            );
        }
    }
}

#[test]
fn two_floats_that_differ_are_shown_to_differ() {
    let mut random = Random(2);
    for _ in 0..5000 {
        let got = (random.coordinate() * 10f64.powf(9.0 * random.coordinate())) as f32;
        let mismatch = Mismatch {
            pixel: crate::camera::Pixel { i: 0, j: 0 },
            got,
            expected: got.next_up(),
            allowed: 0.0,
        };
        let digits = digits_to_tell(&mismatch);
        let shown = |value: f32| number(f64::from(value), digits);
        assert!((6..=9).contains(&digits));
        assert_ne!(shown(mismatch.got), shown(mismatch.expected));
    }
}

#[test]
fn six_digits_are_enough_where_they_differ() {
    let mismatch = Mismatch {
        pixel: crate::camera::Pixel { i: 0, j: 0 },
        got: 1.0,
        expected: 2.0,
        allowed: 0.0,
    };
    assert_eq!(digits_to_tell(&mismatch), 6);
}

fn verdict(ids: &[f32; 6], ts: &[f32; 6]) -> String {
    let golden = grid(3, &[("id", &[0.0; 6]), ("t", &[1.25; 6])]);
    let tolerance = grid(3, &[("id", &[0.0; 6]), ("t", &[1e-6; 6])]);
    let golden = Golden::new(golden, tolerance).unwrap();
    let film = grid(3, &[("id", ids), ("t", ts)]);
    judge(&golden, &film).unwrap().to_string()
}

#[test]
fn a_film_that_passes_says_how_many_pixels_agree() {
    assert_eq!(verdict(&[0.0; 6], &[1.25; 6]), "passes: all 6 pixels agree");
}

#[test]
fn a_film_that_fails_says_where_and_how_badly_channel_by_channel() {
    let ts = [1.25, 1.5, 1.25, 1.25, 1.25, 1.375];
    assert_eq!(
        verdict(&[0.0, 0.0, 0.0, 2.0, 0.0, 0.0], &ts),
        "fails: 3 of 6 pixels are wrong\n  \
         id   1 pixel; worst at (0, 0): got object 2, expected object 0\n  \
         t    2 pixels, (1, 0) to (2, 1); worst at (1, 1): got 1.5, expected 1.25 ± 1e−6"
    );
}

#[test]
fn an_object_that_is_not_hit_is_called_so() {
    let text = verdict(&[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0], &[1.25; 6]);
    assert!(text.contains("got no hit, expected object 0"), "{text}");
}

#[test]
fn a_channel_that_agrees_says_so_when_asked() {
    let film = row(&[("t", &[1.0])]);
    let golden = Golden::new(film.clone(), film.clone()).unwrap();
    let verdict = judge(&golden, &film).unwrap();
    assert_eq!(verdict.channels[0].to_string(), "t    agrees everywhere");
}
