//! What exact kernels decide with, by properties.

use pinhole_study::double_double::DoubleDouble;
use pinhole_study::dyadic::Dyadic;
use pinhole_study::leading::Leading;
use pinhole_study::random::Random;

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
fn a_float_comes_back_from_its_leading_bits() {
    let mut random = Random::new(3, "leading");
    for value in (0..20_000)
        .map(|_| any(&mut random))
        .chain([0.0, 5e-324, f64::MAX])
    {
        assert_eq!(Leading::from(&Dyadic::of(value)).rounded::<f64>(), value);
    }
}

#[test]
fn a_root_and_a_quotient_of_leading_bits_are_rounded_right() {
    let mut random = Random::new(4, "leading");
    for _ in 0..20_000 {
        let (a, b) = (any(&mut random).abs(), random.within(1.0, 2.0));
        let number = |value: f64| Leading::from(&Dyadic::of(value));
        assert_eq!(number(a).sqrt().rounded::<f64>(), a.sqrt(), "√{a:e}");
        // A subnormal quotient is rounded twice.
        if (a / b).is_normal() {
            assert_eq!(
                (number(a) / number(b)).rounded::<f64>(),
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
