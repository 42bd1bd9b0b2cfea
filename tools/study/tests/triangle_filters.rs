//! Tests that the filters of triangles agree with exact arithmetic, for rays ever closer to an edge
//! and for triangles so large that volumes overflow.

use pinhole_study::kernel::sphere::ScaledRay;
use pinhole_study::kernel::{Adaptive, Filtered, Kernel, ScaledQuery};
use pinhole_study::random::Random;
use pinhole_study::root::rounded;
use pinhole_study::shape::{Ray, Triangle};
use pinhole_study::vector::Vector;

/// The double-double filter's answer, if it is certain.
fn twice_decided(triangle: &Triangle<f64>, ray: &Ray<f64>, min_t: f64) -> Option<Option<f64>> {
    let scaled = ScaledRay::new(ray);
    triangle.double_double_filter(&ScaledQuery::new(scaled, scaled.scale(min_t)))
}

/// A ray at distance `hair` from the world's origin, aimed from there at the middle of an edge.
/// With `hair` = 0 it hits the edge exactly, because corners are multiples of 2^−50 and their sum
/// is not rounded. `back` tells how far behind the world's origin the ray begins.
fn beside_an_edge(random: &mut Random, hair: f64, back: f64) -> (Triangle<f64>, Ray<f64>) {
    let fine = 2f64.powi(50);
    let [a, b, c] = [0; 3].map(|_| random.unit().map(|x| (x * fine).round() / fine));
    let direction = a + b;
    let origin = random.unit() * hair - direction * back;
    let corners = [a, b, c];
    (Triangle { corners }, Ray { origin, direction })
}

/// From a distance of 10^11, corners minus the origin are ten thousand million times as long as
/// the triangle, and volumes lose twice as many digits.
#[test]
fn double_double_decisions_are_true() {
    let mut random = Random::new(1, "twice");
    let [mut decided, mut distant, mut open] = [0; 3];
    for exponent in 0..=60 {
        for _ in 0..1_000 {
            let back = [0.0, 10f64.powi(random.below(12) as i32)][random.below(2)];
            let (triangle, ray) = beside_an_edge(&mut random, 10f64.powi(-exponent), back);
            let Some(answer) = twice_decided(&triangle, &ray, 0.0) else {
                open += 1;
                continue;
            };
            decided += 1;
            distant += usize::from(back > 1e5 && answer.is_some());
            let truth = triangle.exact(&ray, 0.0).map(|root| root.rounded());
            let is_near = match (answer, truth) {
                (Some(t), Some(true_t)) => (t - true_t).abs() <= 1e-15 * true_t,
                (answer, truth) => answer == truth,
            };
            assert!(
                is_near,
                "{answer:?} instead of {truth:?}: {triangle:?} {ray:?}"
            );
        }
    }
    let are_many = decided > 20_000 && distant > 500 && open > 10_000;
    assert!(are_many, "{decided}, {distant}, {open}");
}

/// Small integers times `unit`, of which two are often equal. Many answers then depend on a
/// last digit, which underflows in products of small units.
fn in_units_of(random: &mut Random, unit: f64) -> (Triangle<f64>, Ray<f64>) {
    let mut point = || {
        let mut number = || random.within(-4.0, 4.0).round() * unit;
        Vector::new(number(), number(), number())
    };
    let corners = [point(), point(), point()];
    let (origin, target) = (point(), point());
    let direction = (target - origin) * (1.0 / unit);
    (Triangle { corners }, Ray { origin, direction })
}

#[test]
fn no_decision_is_wrong_with_underflow_or_t_near_min_t() {
    let mut random = Random::new(2, "twice");
    let (mut decided, mut met) = (0, 0);
    for power in [0, -300, -340, -360, -500, -530, -1000] {
        for _ in 0..5_000 {
            let (triangle, ray) = in_units_of(&mut random, 2f64.powi(power));
            let Some(root) = triangle.exact(&ray, 0.0) else {
                continue;
            };
            met += 1;
            let t = root.rounded();
            for min_t in [0.0, t.next_down().max(0.0), t, t.next_up()] {
                let Some(answer) = twice_decided(&triangle, &ray, min_t) else {
                    continue;
                };
                decided += 1;
                let truth = triangle.exact(&ray, min_t);
                let alike = answer.is_some() == truth.is_some();
                assert!(alike, "{answer:?} from {min_t:e} on: {triangle:?} {ray:?}");
            }
        }
    }
    assert!(met > 1_000 && decided > 100, "{met}, {decided}");
}

/// The ray hits an edge exactly, and digits of the products underflow.
#[test]
fn products_that_underflow_are_left_to_exact_arithmetic() {
    let mut random = Random::new(3, "twice");
    for power in -530..-470 {
        for _ in 0..20 {
            let (triangle, ray) = beside_an_edge(&mut random, 0.0, 0.0);
            let corners = triangle.corners.map(|corner| corner * 2f64.powi(power));
            let answer = twice_decided(&Triangle { corners }, &ray, 0.0);
            assert_eq!(answer, None, "{corners:?} {ray:?}");
        }
    }
}

/// Counts rays for which the filtered kernel and exact arithmetic disagree about a hit.
fn disagreements(size: f64) -> usize {
    let mut random = Random::new(1, "overflow");
    let mut point = || {
        let mut number = || random.within(-2.0, 2.0) * size;
        Vector::new(number(), number(), number())
    };
    let mut disagreements = 0;
    for _ in 0..5_000 {
        let (corners, origin) = ([0; 3].map(|_| point()), point());
        let [a, b, c] = corners.map(|corner| corner * (1.0 / 3.0));
        let target = a + b + c;
        let ray = Ray {
            origin,
            direction: (target - origin) * (1.0 / size),
        };
        let triangle = Triangle { corners };
        let seen = Adaptive::intersect(&triangle, &(ScaledRay::new(&ray), ray), 0.0);
        let truth = rounded(triangle.exact(&ray, 0.0));
        disagreements += usize::from(seen.is_some() != truth.is_some());
    }
    disagreements
}

#[test]
fn overflowing_volumes_are_left_to_exact_arithmetic() {
    // The first size overflows determinants, the second t times the determinant.
    assert_eq!(disagreements(5e153) + disagreements(4e102), 0);
}
