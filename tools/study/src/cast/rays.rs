//! Where rays come from: the rays of a scene's camera, and the region that contains their origins.
//! Error bounds for all rays that start inside it are computed once per part instead of once per
//! ray.

use pinhole::{Projection, Scene};

use super::world::vector;
use crate::kernel::Camera;
use crate::kernel::sphere::at_most;
use crate::number::Real;
use crate::shape::Ray;
use crate::vector::Vector;

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

/// A cube around the origins of a camera's rays.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    center: Vector<f64>,
    /// Half the cube's side.
    radius: f64,
}

impl Reach {
    /// The reach of a camera: four times as large as necessary, because some errors grow with the
    /// distance of the origin from the centre.
    pub fn of(camera: &Camera) -> Reach {
        match *camera {
            Camera::Perspective { eye } => Reach {
                center: eye,
                radius: 0.0,
            },
            Camera::Orthographic { scaled, exponent } => Reach {
                center: scaled.ray.origin,
                radius: 4f64.times_power_of_two(exponent),
            },
        }
    }

    /// The largest distance, in each component, between `anchor` and a ray origin within reach.
    /// The rounding here is covered by the slack in every bound.
    pub fn away(&self, anchor: Vector<f64>) -> f64 {
        (anchor - self.center).largest() + self.radius
    }

    /// The largest distance between `anchor` and a ray origin within reach.
    pub fn distance(&self, anchor: Vector<f64>) -> f64 {
        let apart = anchor - self.center;
        let apart = match apart.largest() {
            // The square neither overflows nor vanishes.
            1e-140..1e140 => apart.dot(apart).sqrt(),
            largest => at_most(largest),
        };
        apart + at_most(self.radius)
    }
}
