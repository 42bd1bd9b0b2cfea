//! Tests that t is as accurate as requested even if almost all digits cancel.

use pinhole_study::cast::refined::refined;
use pinhole_study::cast::world::Primitive;
use pinhole_study::random::Random;
use pinhole_study::shape::{Ray, Triangle};
use pinhole_study::vector::Vector;

type Whole = [i128; 3];

fn dot(a: Whole, b: Whole) -> i128 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: Whole, b: Whole) -> Whole {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// The step of at most `reach` along x and y that leads least far away from a plane through 0.
fn least_step(normal: Whole, reach: i128) -> Whole {
    let along_z = |x: i128, y: i128| -(normal[0] * x + normal[1] * y) / normal[2];
    let steps = (0..reach).flat_map(|x| (0..reach).map(move |y| [x, y, along_z(x, y)]));
    let steps = steps.filter(|step| dot(normal, *step) != 0);
    steps
        .min_by_key(|step| dot(normal, *step).abs())
        .expect("there are steps")
}

/// The eye is at 0, and a triangle is moved out of a plane through 0 by whole numbers, so little that
/// the distance is 2⁻⁶⁰ of its size or less. The ray aims at the sum of the corners, so t is 1/3.
#[test]
fn t_is_accurate_if_the_eye_is_nearly_in_the_plane() {
    let mut random = Random::new(1, "nearly in the plane");
    let mut whole = || [0; 3].map(|_| random.within(-(2f64.powi(48)), 2f64.powi(48)) as i128);
    for reach in [8, 32, 128, 512].repeat(10) {
        let [p, q] = [whole(), whole()];
        let step = least_step(cross(p, q), reach);
        let sum = |all: &[Whole]| -> Whole { [0, 1, 2].map(|k| all.iter().map(|it| it[k]).sum()) };
        let corners = [sum(&[p, step]), sum(&[q, step]), sum(&[p, q, step])];
        let vector = |[x, y, z]: Whole| Vector::new(x as f64, y as f64, z as f64);
        let ray = Ray {
            origin: vector([0; 3]),
            direction: vector(sum(&corners)),
        };
        let triangle = Primitive::Triangle(Triangle {
            corners: corners.map(vector),
        });
        let (t, ..) = refined(&triangle, &ray, 0.0, 1.0 / 3.0, 1e-14);
        assert!(
            (3.0 * t - 1.0).abs() <= 1e-14,
            "{t:e} for a reach of {reach}"
        );
    }
}
