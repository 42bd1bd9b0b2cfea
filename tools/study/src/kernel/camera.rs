//! What the rays of one film have in common. Filters that are made for a camera compute it once.

use super::sphere::{ScaledRay, at_most};
use crate::number::{Real, exponent};
use crate::shape::Ray;
use crate::vector::Vector;

/// A camera, as filters see it. The rest of each ray is one vector q, with components below 2.
#[derive(Clone, Copy, Debug)]
pub enum Camera {
    /// All rays start at the eye. q is the scaled direction.
    Perspective {
        /// The eye.
        eye: Vector<f64>,
    },
    /// All rays have the same direction. q is (e − o) 2^−`exponent`, where o is the
    /// centre of the origins.
    Orthographic {
        /// A ray from the centre, scaled.
        scaled: ScaledRay<f64>,
        /// No origin is 2^`exponent` or more from the centre in any component.
        exponent: i32,
        /// 2^−`exponent`.
        scale: f64,
    },
}

impl Camera {
    /// The camera of rays that all have the same direction.
    ///
    /// # Panics
    /// If there is no ray.
    pub fn orthographic(rays: &[Ray<f64>], center: Vector<f64>) -> Camera {
        let away = rays.iter().map(|ray| (ray.origin - center).largest());
        let away = away.fold(0.0, f64::max);
        // A film of a single pixel has one origin.
        let exponent = match away > 0.0 {
            true => (exponent(away) + 1).max(-1000),
            false => -1000,
        };
        Camera::Orthographic {
            scaled: ScaledRay::new(&Ray {
                origin: center,
                ..rays[0]
            }),
            exponent,
            scale: 1f64.times_power_of_two(-exponent),
        }
    }

    /// The eye of a perspective camera.
    pub fn eye(&self) -> Option<Vector<f64>> {
        match *self {
            Camera::Perspective { eye } => Some(eye),
            Camera::Orthographic { .. } => None,
        }
    }

    /// The centre of the rays' origins, and a bound on their distance from it in each component. It
    /// is four times as large as necessary, because some errors grow with that distance.
    fn origins(&self) -> (Vector<f64>, f64) {
        match *self {
            Camera::Perspective { eye } => (eye, 0.0),
            Camera::Orthographic {
                scaled, exponent, ..
            } => (scaled.ray.origin, 4f64.times_power_of_two(exponent)),
        }
    }

    /// The largest distance, in each component, between `anchor` and the origin of a ray. The
    /// rounding here is covered by the slack in every bound.
    pub fn away(&self, anchor: Vector<f64>) -> f64 {
        let (center, radius) = self.origins();
        (anchor - center).largest() + radius
    }

    /// The largest distance between `anchor` and the origin of a ray.
    pub fn distance(&self, anchor: Vector<f64>) -> f64 {
        let (center, radius) = self.origins();
        let apart = anchor - center;
        let apart = match apart.largest() {
            // The square neither overflows nor vanishes.
            1e-140..1e140 => apart.dot(apart).sqrt(),
            largest => at_most(largest),
        };
        apart + at_most(radius)
    }

    /// One of the rays, scaled, and its q. Without a camera, q is the direction, too.
    #[inline(always)]
    pub fn scaled(camera: Option<&Camera>, ray: &Ray<f64>) -> (ScaledRay<f64>, Vector<f64>) {
        match camera {
            None | Some(Camera::Perspective { .. }) => {
                let scaled = ScaledRay::new(ray);
                (scaled, scaled.ray.direction)
            }
            Some(Camera::Orthographic { scaled, scale, .. }) => {
                let (origin, direction) = (ray.origin, scaled.ray.direction);
                let q = (origin - scaled.ray.origin) * *scale;
                let ray = Ray { origin, direction };
                (ScaledRay { ray, ..*scaled }, q)
            }
        }
    }
}
