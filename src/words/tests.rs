use super::*;
use crate::ray::Intersection;
use crate::testing::Random;

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
fn number_has_no_trailing_zeros() {
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
fn zero_has_no_sign() {
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
fn nan_and_infinity_are_words() {
    assert_eq!(number(f64::NAN, 6), "NaN");
    assert_eq!(number(f64::INFINITY, 6), "inf");
}

#[test]
fn a_number_read_back_is_right_to_its_digits() {
    let mut random = Random::new(1);
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
fn a_hit_names_its_object_and_an_intersection_does_not() {
    let met = Some(Hit {
        object: 2,
        intersection: Intersection {
            t: 3.25,
            normal: DVec3::NEG_Y,
        },
    });
    assert_eq!(hit(met, 6), "object 2 at t = 3.25, normal (0, −1, 0)");
    assert_eq!(intersection(met, 6), "t = 3.25, normal (0, −1, 0)");
    assert_eq!([hit(None, 6), intersection(None, 6)], ["no hit", "no hit"]);
}
