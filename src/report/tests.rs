use super::*;
use crate::judge::{Golden, judge};
use crate::testing::{Random, grid, row};

#[test]
fn two_floats_that_differ_are_shown_to_differ() {
    let mut random = Random::new(2);
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
fn wrong_miss_is_described_as_no_hit() {
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

#[test]
fn an_exit_code_is_not_reported_as_a_signal() {
    let of = |death: Death| death.to_string();
    assert_eq!(
        of(Death::Signal(9)),
        "it was killed before it had answered (SIGKILL)"
    );
    assert_eq!(
        of(Death::Exit(137)),
        "it exited with code 137 before it had answered; that usually means that it was killed \
         (SIGKILL)"
    );
    assert_eq!(
        of(Death::Exit(7)),
        "it exited with code 7 before it had answered"
    );
}
