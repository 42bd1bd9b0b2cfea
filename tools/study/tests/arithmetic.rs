//! Tests of the arithmetic that exact kernels use: rounding, and cases that are rare in casting.
//! The oracle judges the sums and products of exact decisions in all other tests.

use std::cmp::Ordering::{Equal, Greater, Less};

use pinhole_study::dyadic::Dyadic;
use pinhole_study::random::Random;
use pinhole_study::root::Root;

/// Any finite number, of any magnitude.
fn any(random: &mut Random) -> f64 {
    loop {
        let value = f64::from_bits(random.bits());
        if value.is_finite() {
            return value;
        }
    }
}

#[test]
fn dyadic_of_a_float_rounds_back_to_it() {
    let mut random = Random::new(3, "leading");
    for value in (0..20_000)
        .map(|_| any(&mut random))
        .chain([0.0, 5e-324, f64::MAX])
    {
        assert_eq!(Dyadic::of(value).rounded(), value);
    }
}

#[test]
fn dyadic_roots_and_quotients_are_correctly_rounded() {
    let mut random = Random::new(4, "leading");
    for _ in 0..20_000 {
        let (a, b) = (any(&mut random).abs(), random.within(1.0, 2.0));
        assert_eq!(Dyadic::of(a).sqrt().rounded(), a.sqrt(), "√{a:e}");
        // A subnormal quotient is rounded twice, so it may differ.
        if (a / b).is_normal() {
            assert_eq!(
                Dyadic::of(a).over(&Dyadic::of(b)).rounded(),
                a / b,
                "{a:e} / {b:e}"
            );
        }
    }
}

/// Compares the `f64` nearest to √2, and numbers very close to √2, with the root √2 of t² − 2 =
/// 0.
#[test]
fn roots_that_round_to_the_same_float_are_compared_correctly() {
    let of = Dyadic::of;
    let root =
        |p: f64, sign, radicand: f64, q: f64| Root::quadratic(of(p), sign, of(radicand), of(q));
    let near_root_2 = Root::fraction(of(2f64.sqrt()), of(1.0));
    let hair = 2f64.powi(-200);
    for (one, other, order) in [
        // 2f64.sqrt() is above √2, because its square is above 2.
        (near_root_2.clone(), root(0.0, 1, 2.0, 1.0), Greater),
        (root(0.0, -1, 2.0, 1.0), near_root_2, Less),
        // √8 / 2 = √2 and 1 ± √2 = (2 ± √8) / 2.
        (root(0.0, 1, 8.0, 2.0), root(0.0, 1, 2.0, 1.0), Equal),
        (root(1.0, 1, 2.0, 1.0), root(2.0, 1, 8.0, 2.0), Equal),
        (root(1.0, -1, 2.0, 1.0), root(2.0, -1, 8.0, 2.0), Equal),
        (root(hair, 1, 2.0, 1.0), root(0.0, 1, 8.0, 2.0), Greater),
        (root(-hair, -1, 2.0, 1.0), root(0.0, -1, 8.0, 2.0), Less),
    ] {
        assert_eq!(one.compare(&other), order, "{one:?} {other:?}");
    }
}
