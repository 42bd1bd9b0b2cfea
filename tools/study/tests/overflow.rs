//! Are triangles met that are so large that volumes overflow, some with the wrong sign?

use pinhole_study::kernel::Kernel;
use pinhole_study::kernel::triangle::{Adaptive, exact};
use pinhole_study::random::Random;
use pinhole_study::root::rounded;
use pinhole_study::shape::{Ray, Triangle};
use pinhole_study::vector::Vector;

/// How many triangles are missed that a ray at them truly meets.
fn missed(size: f64) -> usize {
    let mut random = Random::new(1, "overflow");
    let mut point = || {
        let mut number = || random.within(-2.0, 2.0) * size;
        Vector::new(number(), number(), number())
    };
    let mut missed = 0;
    for _ in 0..5_000 {
        let (corners, origin) = ([0; 3].map(|_| point()), point());
        let [a, b, c] = corners.map(|corner| corner * (1.0 / 3.0));
        let target = a + b + c;
        let ray = Ray {
            origin,
            direction: (target - origin) * (1.0 / size),
        };
        let triangle = Triangle { corners };
        let seen = Adaptive::intersect(&triangle, &Adaptive::prepare(&ray), 0.0);
        let truth = rounded(exact(&triangle, &ray, 0.0));
        missed += usize::from(seen.is_some() != truth.is_some());
    }
    missed
}

#[test]
fn volumes_that_overflow_decide_nothing() {
    // Where determinants overflow, and where t times the determinant does.
    assert_eq!(missed(5e153) + missed(4e102), 0);
}
