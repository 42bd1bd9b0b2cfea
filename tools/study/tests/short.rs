//! Tests that exact decisions about numbers with few bits, which `f64` arithmetic makes without
//! rounding, are the same as those with long integers.

use pinhole_study::kernel::Filtered;
use pinhole_study::kernel::short::{are_short, compare};
use pinhole_study::random::Random;
use pinhole_study::root::rounded;
use pinhole_study::shape::{Plane, Ray, Triangle};
use pinhole_study::vector::Vector;

/// A vector of integers with at most this many bits, the largest and the smallest of which are
/// likely.
fn integers(random: &mut Random, bits: usize) -> Vector<f64> {
    let most = 2f64.powi(bits as i32) - 1.0;
    let mut number = || match random.below(8) {
        0 => 0.0,
        1 => 1.0,
        2 => -most,
        3 => most,
        _ => random.within(-most, most).round(),
    };
    Vector::new(number(), number(), number())
}

/// Makes all lengths this many times as long, which changes no decision and no t.
fn times(vector: Vector<f64>, power: i32) -> Vector<f64> {
    vector * 2f64.powi(power)
}

/// Compares the answer in `f64`, if it is exact, with the one in long integers. `min_t` is 0, that t,
/// or one of its neighbours. Returns whether the ray hits, and whether there was an answer in `f64`.
#[track_caller]
fn check(shape: &impl Filtered, ray: &Ray<f64>) -> [bool; 2] {
    let hit = rounded(shape.exact(ray, 0.0));
    let t = hit.unwrap_or(1.0);
    for min_t in [0.0, t, t.next_up(), t.next_down().max(0.0)] {
        if let Some(answer) = shape.short(ray, min_t) {
            let expected = rounded(shape.exact(ray, min_t));
            assert_eq!(answer, expected, "{ray:?} from {min_t:e} on");
        }
    }
    [hit.is_some(), shape.short(ray, 0.0).is_some()]
}

#[test]
fn decisions_on_short_numbers_are_those_of_long_integers() {
    let mut random = Random::new(4, "short");
    let [mut hits, mut short] = [0; 2];
    for round in 0..40_000 {
        // Numbers with 16 bits or more are not short, so both sides of the limit are tested.
        let (bits, own) = (1 + round % 18, 1 + random.below(18));
        let unit = [random.below(200) as i32 - 100, 0][random.below(2)];
        let [a, b, c, e] = [0; 4].map(|_| times(integers(&mut random, bits), unit));
        let n = integers(&mut random, own);
        // Aim at a corner, at the middle of an edge, inside the triangle, or anywhere.
        let direction = match random.below(5) {
            0 => a - e,
            1 => a + b - e * 2.0,
            2 => a + b + c - e * 3.0,
            3 => a * 2.0 + b - e * 3.0,
            _ => integers(&mut random, own),
        };
        let ray = Ray {
            origin: e,
            direction,
        };
        let corners = [a, b, c];
        let plane = Plane {
            point: a,
            normal: n,
        };
        for [is_hit, is_short] in [check(&Triangle { corners }, &ray), check(&plane, &ray)] {
            hits += usize::from(is_hit);
            short += usize::from(is_short);
        }
    }
    assert!(hits > 20_000 && short > 20_000, "{hits} {short}");
}

#[test]
fn order_of_short_fractions_is_that_of_long_ones() {
    let mut random = Random::new(4, "order");
    let mut nearly_equal = 0;
    for _ in 0..20_000 {
        let bits = 1 + random.below(14);
        let [e, direction] = [0; 2].map(|_| integers(&mut random, bits));
        // The second plane is close to the first, or the same.
        let [n, p] = [0; 2].map(|_| integers(&mut random, bits));
        let near = Vector::new(random.below(2) as f64, 0.0, 0.0);
        let planes = [(n, p), ((n + near) * -1.0, p)];
        let planes = planes.map(|(normal, point)| Plane { point, normal });
        let ray = Ray {
            origin: e,
            direction,
        };
        let fractions = planes.map(|plane| plane.short_fraction(&ray));
        let [Some(one), Some(other)] = fractions else {
            continue;
        };
        if one[1] == 0.0 || other[1] == 0.0 {
            continue;
        }
        let [first, second] = planes.map(|plane| plane.exact_hit(&ray, 0.0));
        assert_eq!(
            compare(one, other),
            first.compare(&second),
            "{one:?} {other:?}"
        );
        let [t, u] = [one, other].map(|[p, q]| p / q);
        nearly_equal += usize::from(t != u && (t - u).abs() < 1e-3 * t.abs());
    }
    assert!(nearly_equal > 1_000, "{nearly_equal}");
}

#[test]
fn numbers_are_short_if_they_have_fifteen_bits() {
    let unit = 2f64.powi(-150);
    let is_short = |x: f64, y: f64| are_short([Vector::new(x, 0.0, -y)]);
    for unit in [1.0, unit * 64.0, 1.0 / unit / 131072.0] {
        assert!(is_short(32767.0 * unit, unit));
        assert!(!is_short(32768.0 * unit, unit));
        assert!(!is_short(32767.5 * unit, 0.0));
    }
    assert!(are_short([Vector::default()]));
    for x in [f64::NAN, f64::INFINITY, 1e-300, 1e300, 5e-324, 0.1] {
        assert!(
            !is_short(x, 1.0) && !is_short(1.0, x) && !is_short(x, 0.0),
            "{x:e}"
        );
    }
}
