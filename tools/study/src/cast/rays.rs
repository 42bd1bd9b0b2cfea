//! The rays of a scene's camera.

use pinhole::{Projection, Scene};

use super::world::vector;
use crate::kernel::Camera;
use crate::shape::Ray;

/// The camera, as filters see it.
pub fn camera(scene: &Scene, rays: &[Ray<f64>]) -> Camera {
    let eye = vector(scene.camera.eye);
    match scene.camera.projection {
        Projection::Perspective { .. } => Camera::Perspective { eye },
        Projection::Orthographic => Camera::orthographic(rays, eye),
    }
}

/// Rays through the centres of all pixels, in image order (Marschner & Shirley, 4th ed., §4.3).
/// They are rounded to `f64`; exact decisions are exact for the rounded rays.
pub fn rays(scene: &Scene) -> Vec<Ray<f64>> {
    let (camera, resolution) = (&scene.camera, scene.resolution);
    let through = |index| {
        let pixel = resolution.pixel(index);
        let across = (pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5;
        let upward = (pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5;
        let on_plane = camera.width * across * camera.u + camera.height * upward * camera.v;
        let (origin, direction) = match camera.projection {
            Projection::Perspective { focal_length } => {
                (camera.eye, on_plane - focal_length * camera.w)
            }
            Projection::Orthographic => (camera.eye + on_plane, -camera.w),
        };
        Ray {
            origin: vector(origin),
            direction: vector(direction),
        }
    };
    (0..resolution.pixels()).map(through).collect()
}
