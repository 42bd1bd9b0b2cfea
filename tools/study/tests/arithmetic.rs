//! What exact kernels decide with, by properties.

use std::cmp::Ordering;

use pinhole_study::double_double::DoubleDouble;
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
fn sums_and_products_of_floats_are_exact() {
    let mut random = Random::new(1, "dyadic");
    for _ in 0..20_000 {
        let [a, b, c] = [0; 3].map(|_| any(&mut random)).map(Dyadic::of);
        let left = &(&a + &b) * &(&a - &b);
        let right = &(&a * &a) - &(&b * &b);
        assert_eq!((&left - &right).sign(), 0, "{a:?} {b:?}");
        let apart = &(&(&a * &c) + &(&b * &c)) - &(&(&a + &b) * &c);
        assert_eq!(apart.sign(), 0, "{a:?} {b:?} {c:?}");
    }
}

#[test]
fn signs_follow_small_integers() {
    let mut random = Random::new(2, "dyadic");
    for _ in 0..20_000 {
        let [a, b, c, d] = [0; 4].map(|_| random.within(-1e6, 1e6).round());
        let exact = (a as i128) * (b as i128) - (c as i128) * (d as i128);
        let of = Dyadic::of;
        let ours = &(&of(a) * &of(b)) - &(&of(c) * &of(d));
        assert_eq!(i128::from(ours.sign()), exact.signum(), "{a} {b} {c} {d}");
    }
}

#[test]
fn a_float_comes_back_from_its_dyadic() {
    let mut random = Random::new(3, "leading");
    for value in (0..20_000)
        .map(|_| any(&mut random))
        .chain([0.0, 5e-324, f64::MAX])
    {
        assert_eq!(Dyadic::of(value).rounded(), value);
    }
}

#[test]
fn a_root_and_a_quotient_are_rounded_right() {
    let mut random = Random::new(4, "leading");
    for _ in 0..20_000 {
        let (a, b) = (any(&mut random).abs(), random.within(1.0, 2.0));
        assert_eq!(Dyadic::of(a).sqrt().rounded(), a.sqrt(), "√{a:e}");
        // A subnormal quotient is rounded twice.
        if (a / b).is_normal() {
            assert_eq!(
                Dyadic::of(a).over(&Dyadic::of(b)).rounded(),
                a / b,
                "{a:e} / {b:e}"
            );
        }
    }
}

#[test]
fn double_doubles_lose_nothing_where_they_promise_so() {
    let mut random = Random::new(5, "double-double");
    for _ in 0..20_000 {
        let (a, b) = (random.within(-1e9, 1e9), random.within(-1e-3, 1e3));
        let of = Dyadic::of;
        let product = DoubleDouble::product(a, b);
        let exact = &of(a) * &of(b);
        assert_eq!((&exact - &(&of(product.high) + &of(product.low))).sign(), 0);
        let sum = DoubleDouble::sum(a, b);
        let exact = &of(a) + &of(b);
        assert_eq!((&exact - &(&of(sum.high) + &of(sum.low))).sign(), 0);
    }
}

/// √2 as exactly as an `f64` says it, and things around it: t² − 2 = 0 has ±√2.
#[test]
fn roots_are_compared_beyond_the_digits_of_any_float() {
    let of = Dyadic::of;
    let root =
        |p: f64, sign, radicand: f64, q: f64| Root::quadratic(of(p), sign, of(radicand), of(q));
    let near_root_2 = Root::fraction(of(2f64.sqrt()), of(1.0));
    // 2f64.sqrt() is above √2: its square is.
    assert_eq!(
        near_root_2.compare(&root(0.0, 1, 2.0, 1.0)),
        Ordering::Greater
    );
    assert_eq!(
        root(0.0, -1, 2.0, 1.0).compare(&near_root_2),
        Ordering::Less
    );
    // √8 / 2 = √2, 1 + √2 = (2 + √8) / 2, and √2 + √3 < √10 by a digit of the fourth.
    assert_eq!(
        root(0.0, 1, 8.0, 2.0).compare(&root(0.0, 1, 2.0, 1.0)),
        Ordering::Equal
    );
    assert_eq!(
        root(1.0, 1, 2.0, 1.0).compare(&root(2.0, 1, 8.0, 2.0)),
        Ordering::Equal
    );
    assert_eq!(
        root(1.0, -1, 2.0, 1.0).compare(&root(2.0, -1, 8.0, 2.0)),
        Ordering::Equal
    );
    let hair = 2f64.powi(-200);
    assert_eq!(
        root(hair, 1, 2.0, 1.0).compare(&root(0.0, 1, 8.0, 2.0)),
        Ordering::Greater
    );
    assert_eq!(
        root(-hair, -1, 2.0, 1.0).compare(&root(0.0, -1, 8.0, 2.0)),
        Ordering::Less
    );
}

#[test]
fn a_comparison_of_roots_is_that_of_their_values_and_turns_around() {
    let mut random = Random::new(6, "roots");
    for _ in 0..5_000 {
        let [p, q] = [0; 2].map(|_| {
            let sign = if random.within(0.0, 1.0) < 0.5 { -1 } else { 1 };
            let [rational, radicand, divisor] = [(-9.0, 9.0), (0.0, 9.0), (1.0, 9.0)]
                .map(|(low, high)| random.within(low, high).round());
            let value = (rational + f64::from(sign) * radicand.sqrt()) / divisor;
            let [r, d, q] = [rational, radicand, divisor].map(Dyadic::of);
            (Root::quadratic(r, sign, d, q), value)
        });
        assert!((p.0.rounded() - p.1).abs() <= 1e-14 * (1.0 + p.1.abs()));
        let order = p.0.compare(&q.0);
        assert_eq!(order, q.0.compare(&p.0).reverse());
        if (p.1 - q.1).abs() > 1e-9 {
            assert_eq!(Some(order), p.1.partial_cmp(&q.1));
        }
    }
}
