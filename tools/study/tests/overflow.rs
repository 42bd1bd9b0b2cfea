//! Tests rays at triangles so large that volumes overflow, some of them with the wrong sign.

use pinhole_study::kernel::sphere::ScaledRay;
use pinhole_study::kernel::{Adaptive, Filtered, Kernel};
use pinhole_study::random::Random;
use pinhole_study::root::rounded;
use pinhole_study::shape::{Ray, Triangle};
use pinhole_study::vector::Vector;

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
