//! A camera's rays, in fractions, and rounded only when they are known.

use dashu_ratio::Relaxed;
use pinhole::{Projection, Scene};

use super::{Exact, fraction};
use crate::cast::world::vector;
use crate::shape::Ray;
use crate::vector::Vector;

/// Through the centre of every pixel, as [`crate::cast::rays::rays`], each number rounded
/// once.
pub fn rays(scene: &Scene) -> Vec<Ray<f64>> {
    let (camera, resolution) = (&scene.camera, scene.resolution);
    let [eye, u, v, w] = [camera.eye, camera.u, camera.v, camera.w].map(|v| Exact::of(vector(v)));
    let along = |size: f64, at: usize, count: usize| {
        let halves = fraction((2 * at + 1) as f64) / fraction((2 * count) as f64);
        fraction(size) * (halves - fraction(0.5))
    };
    let through = |index| {
        let pixel = resolution.pixel(index);
        let across = along(camera.width, pixel.i, resolution.n_x);
        let upward = along(camera.height, pixel.j, resolution.n_y);
        let on_plane = |axis: usize| &across * &u.0[axis] + &upward * &v.0[axis];
        let rounded = |of: &dyn Fn(usize) -> Relaxed| {
            let [x, y, z] = [0, 1, 2].map(|axis| of(axis).to_f64().value());
            Vector::new(x, y, z)
        };
        match camera.projection {
            Projection::Perspective { focal_length } => Ray {
                origin: vector(camera.eye),
                direction: rounded(&|axis| on_plane(axis) - fraction(focal_length) * &w.0[axis]),
            },
            Projection::Orthographic => Ray {
                origin: rounded(&|axis| on_plane(axis) + &eye.0[axis]),
                direction: vector(-camera.w),
            },
        }
    };
    (0..resolution.pixels()).map(through).collect()
}
