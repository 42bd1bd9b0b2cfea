//! Is what twice the digits decide what exact numbers decide, ever nearer to an edge?

use pinhole_study::kernel::sphere::Scaled;
use pinhole_study::kernel::triangle::{exact, twice};
use pinhole_study::random::Random;
use pinhole_study::shape::{Ray, Triangle};

/// A ray from a hair beside the world's origin at the middle of an edge. Without the hair
/// that is met exactly: corners are multiples of 2^−50, and their sum is not rounded.
fn beside_an_edge(random: &mut Random, hair: f64) -> (Triangle<f64>, Ray<f64>) {
    let fine = 2f64.powi(50);
    let [a, b, c] = [0; 3].map(|_| random.unit().map(|x| (x * fine).round() / fine));
    let ray = Ray {
        origin: random.unit() * hair,
        direction: a + b,
    };
    (Triangle { corners: [a, b, c] }, ray)
}

#[test]
fn what_twice_the_digits_decide_is_true() {
    let mut random = Random::new(1, "twice");
    let [mut decided, mut open] = [0; 2];
    for exponent in 0..=60 {
        for _ in 0..1_000 {
            let (triangle, ray) = beside_an_edge(&mut random, 10f64.powi(-exponent));
            let Some(answer) = twice(&triangle, &Scaled::new(&ray), 0.0) else {
                open += 1;
                continue;
            };
            decided += 1;
            let truth = exact(&triangle, &ray, 0.0).map(|root| root.rounded::<f64>());
            let is_near = match (answer, truth) {
                (Some(t), Some(true_t)) => (t - true_t).abs() <= 1e-8 * true_t,
                (answer, truth) => answer == truth,
            };
            assert!(
                is_near,
                "{answer:?} instead of {truth:?}: {triangle:?} {ray:?}"
            );
        }
    }
    assert!(decided > 20_000 && open > 10_000, "{decided}, {open}");
}
