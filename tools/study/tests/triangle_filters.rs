//! Tests that the filter of triangles agrees with exact arithmetic, for rays ever closer to an edge
//! and for numbers so small or so large that products underflow or overflow.

use pinhole_study::cast::model::Exact;
use pinhole_study::cast::world::{PROVEN_T, View, World};
use pinhole_study::cast::{Caster, Tally};
use pinhole_study::kernel::sphere::ScaledRay;
use pinhole_study::kernel::{Camera, Filtered, decided};
use pinhole_study::number::ROOT_OF_UNIT;
use pinhole_study::random::Random;
use pinhole_study::root::rounded;
use pinhole_study::shape::{Ray, Triangle};
use pinhole_study::vector::Vector;

/// The exact answer, after checking that the filtered kernel agrees with it.
#[track_caller]
fn checked(triangle: &Triangle<f64>, ray: &Ray<f64>, min_t: f64) -> Option<f64> {
    let (seen, _) = decided(triangle, &ScaledRay::new(ray), ray, min_t);
    let truth = rounded(triangle.exact(ray, min_t));
    let is_right = match (seen, truth) {
        (Some(t), Some(truth)) => (t - truth).abs() <= 2.0 * ROOT_OF_UNIT * truth.abs() + 1e-308,
        (seen, truth) => seen == truth,
    };
    let what = format!("{seen:?} instead of {truth:?} from {min_t:e} on");
    assert!(is_right, "{what}: {triangle:?} {ray:?}");
    truth
}

/// Rays pass an edge at ever smaller distances, and at last hit it exactly, because corners are
/// multiples of 2^−50 and their sum is not rounded. From a distance of 10^11, corners minus the
/// origin are ten thousand million times as long as the triangle.
#[test]
fn decisions_beside_an_edge_are_true() {
    let mut random = Random::new(1, "edge");
    let fine = 2f64.powi(50);
    let mut hits = 0;
    for exponent in 0..=60 {
        for _ in 0..200 {
            let corners = [0; 3].map(|_| random.unit().map(|x| (x * fine).round() / fine));
            let direction = corners[0] + corners[1];
            let hair = if exponent == 60 {
                0.0
            } else {
                10f64.powi(-exponent)
            };
            let back = [0.0, 10f64.powi(random.below(12) as i32)][random.below(2)];
            let origin = random.unit() * hair - direction * back;
            let ray = Ray { origin, direction };
            hits += usize::from(checked(&Triangle { corners }, &ray, 0.0).is_some());
        }
    }
    assert!(hits > 2_000, "{hits}");
}

/// Small integers times a power of two, of which two are often equal. Many answers then depend on
/// a last digit, which underflows in products of small units.
#[test]
fn no_decision_is_wrong_with_underflow_or_t_near_min_t() {
    let mut random = Random::new(2, "underflow");
    let mut hits = 0;
    for power in [0, -300, -340, -360, -500, -530, -1000] {
        let unit = 2f64.powi(power);
        for _ in 0..5_000 {
            let [a, b, c, origin, target] = [0; 5].map(|_| {
                let mut number = || random.within(-4.0, 4.0).round() * unit;
                Vector::new(number(), number(), number())
            });
            let (direction, corners) = ((target - origin) * (1.0 / unit), [a, b, c]);
            let (triangle, ray) = (Triangle { corners }, Ray { origin, direction });
            let Some(t) = checked(&triangle, &ray, 0.0) else {
                continue;
            };
            hits += 1;
            for min_t in [t.next_down().max(0.0), t, t.next_up()] {
                checked(&triangle, &ray, min_t);
            }
        }
    }
    assert!(hits > 1_000, "{hits}");
}

/// The first size overflows determinants, the second t times the determinant.
#[test]
fn overflowing_volumes_are_left_to_exact_arithmetic() {
    let mut random = Random::new(1, "overflow");
    for size in [5e153, 4e102] {
        for _ in 0..5_000 {
            let [a, b, c, origin] = [0; 4].map(|_| {
                let mut number = || random.within(-2.0, 2.0) * size;
                Vector::new(number(), number(), number())
            });
            let target = (a + b + c) * (1.0 / 3.0);
            let direction = (target - origin) * (1.0 / size);
            let corners = [a, b, c];
            checked(&Triangle { corners }, &Ray { origin, direction }, 0.0);
        }
    }
}

/// The normal of a needle is a small difference of large products, so most of its digits cancel.
/// Some rays are nearly parallel to it.
#[test]
fn filter_for_a_camera_computes_t_of_needles_as_accurately_as_promised() {
    let mut random = Random::new(1, "needles");
    let mut decided_by_filter = 0;
    for _ in 0..20_000 {
        let [a, along, aside, upward] = [0; 4].map(|_| random.unit());
        let mut tiny = || 10f64.powf(random.within(-11.0, 0.0));
        let (thin, back) = (tiny(), along + aside + upward * tiny());
        let corners = [a, a + along, a + along * 0.5 + aside * thin];
        let target = (corners[0] + corners[1] + corners[2]) * (1.0 / 3.0);
        let (origin, direction) = (target + back * 3.0, back * -1.7);
        let ray = Ray { origin, direction };
        let truth = rounded(Triangle { corners }.exact(&ray, 0.0));
        let beside = Ray {
            origin: origin + along,
            direction,
        };
        let cameras = [
            Camera::Perspective { eye: origin },
            Camera::orthographic(&[ray, beside], origin + along * 0.5),
        ];
        for camera in cameras {
            let mut world = World::default();
            world.add(0, Triangle { corners }.into());
            let accuracy = f64::INFINITY;
            let caster = Caster::new(world, Some(View { camera, accuracy }), false);
            let mut tally = Tally::default();
            let found = match camera.eye() {
                Some(_) => caster.first::<Exact<true>>(&ray, 0.0, &mut tally),
                None => caster.first::<Exact<false>>(&ray, 0.0, &mut tally),
            };
            let t = found.map(|found| found.t);
            let is_right = match (t, truth) {
                (Some(t), Some(truth)) => (t - truth).abs() <= PROVEN_T * truth,
                (t, truth) => t == truth,
            };
            assert!(
                is_right,
                "{t:?} instead of {truth:?}: {corners:?} {ray:?} {camera:?}"
            );
            decided_by_filter += u64::from(truth.is_some() && tally.semi_static == 0);
        }
    }
    assert!(decided_by_filter > 15_000, "{decided_by_filter}");
}
