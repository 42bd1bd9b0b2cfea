//! The worst that rounding can do to a part, whatever pixel's ray meets it: known before
//! any ray is cast.
//!
//! A camera's rays fill the pyramid (or box) between the four through its corners. What
//! depends linearly on a ray, such as n·d, is smallest at a corner, unless it changes its
//! sign in between and is 0 somewhere; what is convex, such as |e − c|, is largest there.

use pinhole::{Projection, Scene};

use super::bounds::{Bound, OfPlane, OfSphere, OfTriangle, Rounding};
use super::watch::{length, terms};
use crate::cast::world::{Part, Primitive, vector};
use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};

/// What is known of all of a scene's rays.
pub struct Extent {
    /// Through the corners of the image plane.
    corners: [Ray<f64>; 4],
    min_t: f64,
}

impl Extent {
    /// Of a scene's camera.
    pub fn of(scene: &Scene) -> Extent {
        let camera = &scene.camera;
        let corner = |(across, upward): (f64, f64)| {
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
        Extent {
            corners: [(-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)].map(corner),
            min_t: scene.min_t,
        }
    }

    /// The largest of something convex.
    fn most(&self, of: impl Fn(&Ray<f64>) -> f64) -> f64 {
        self.corners.iter().map(of).fold(0.0, f64::max)
    }

    /// The smallest magnitude of something linear, and its sign; 0 if it has none.
    fn least(&self, of: impl Fn(&Ray<f64>) -> f64) -> (f64, f64) {
        let [low, high] = self
            .corners
            .iter()
            .map(of)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                [low.min(value), high.max(value)]
            });
        match low > 0.0 || high < 0.0 {
            true => (low.abs().min(high.abs()), low.signum()),
            false => (0.0, 0.0),
        }
    }

    /// For any ray that meets the part; all is well if none can. Whether a triangle has
    /// neighbours decides whether an edge matters.
    pub fn bound(&self, part: &Part, rounding: Rounding, has_neighbours: bool) -> Bound {
        match &part.shape {
            Primitive::Sphere(shape) => self.of_sphere(shape, rounding),
            Primitive::Plane(shape) => self.of_plane(shape, rounding),
            Primitive::Triangle(shape) => self.of_triangle(shape, rounding, has_neighbours),
        }
    }

    /// How far a normal may turn that is worked out exactly from a t that is rounded to
    /// `f64`, and is then rounded itself.
    pub fn floor(&self, part: &Part) -> f64 {
        let u = f64::UNIT_ROUNDOFF;
        let turned = match &part.shape {
            Primitive::Sphere(Sphere { center, radius }) => {
                let furthest = self.most(|ray| length(ray.origin - *center)) + radius;
                1.1 * u * furthest / radius
            }
            _ => 0.0,
        };
        turned + 5.0 * u
    }

    fn of_sphere(&self, sphere: &Sphere<f64>, rounding: Rounding) -> Bound {
        let away = |ray: &Ray<f64>| length(ray.origin - sphere.center);
        let (furthest, radius) = (self.most(away), sphere.radius);
        let [first, .., last] = &self.corners;
        let is_perspective = first.origin == last.origin;
        let nearest = match is_perspective {
            true => furthest,
            // From the plane that contains all origins.
            false => {
                self.least(|ray| (ray.origin - sphere.center).dot(ray.direction))
                    .0
            }
        };
        let nearest = nearest.min(furthest);
        // A near root about min_t may be taken or not, and another is then seen: about, by
        // more than any rounding.
        let plane = 1.001 * self.min_t * self.most(|ray| length(ray.direction)) + 1e-6 * nearest;
        if nearest <= radius && furthest >= radius || self.min_t > 0.0 && nearest - radius <= plane
        {
            return Bound::NONE;
        }
        let constant = match nearest > radius {
            true => nearest * nearest - radius * radius,
            false => radius * radius - furthest * furthest,
        };
        let known = OfSphere {
            origin: self.most(|ray| length(ray.origin)),
            center: length(sphere.center),
            away: furthest,
            radius,
            depth_square: 0.0,
            along: 0.0,
            constant: Some(constant),
            length: furthest + radius,
        };
        known.bound(rounding)
    }

    fn of_plane(&self, plane: &Plane<f64>, rounding: Rounding) -> Bound {
        let n = plane.normal;
        let (down, falls) = self.least(|ray| n.dot(ray.direction));
        let (height, is_above) = self.least(|ray| n.dot(plane.point - ray.origin));
        if falls * is_above < 0.0 {
            return Bound {
                t: 0.0,
                normal: 0.0,
            };
        }
        let known = OfPlane {
            down,
            down_terms: self.most(|ray| terms(n, ray.direction)),
            height,
            height_terms: self.most(|ray| terms(n, plane.point - ray.origin)),
            far_terms: terms(n, plane.point) + self.most(|ray| terms(n, ray.origin)),
        };
        known.bound(rounding)
    }

    fn of_triangle(
        &self,
        triangle: &Triangle<f64>,
        rounding: Rounding,
        has_neighbours: bool,
    ) -> Bound {
        let [a, b, c] = triangle.corners;
        let normal = triangle.outward();
        let (determinant, falls) = self.least(|ray| normal.dot(ray.direction));
        let (volume, is_above) = self.least(|ray| normal.dot(a - ray.origin));
        if falls * is_above < 0.0 {
            return Bound {
                t: 0.0,
                normal: 0.0,
            };
        }
        let known = OfTriangle {
            size: (b - a).largest().max((c - a).largest()),
            area: length(normal),
            corner: a.largest().max(b.largest()).max(c.largest()),
            away: self.most(|ray| (ray.origin - a).largest()),
            origin: self.most(|ray| ray.origin.largest()),
            direction: self.most(|ray| ray.direction.largest()),
            direction_length: self.least_length(),
            determinant,
            volume,
            length: [a, b, c]
                .map(|corner| self.most(|ray| length(ray.origin - corner)))
                .into_iter()
                .fold(0.0, f64::max),
            margin: has_neighbours.then_some(0.0),
        };
        known.bound(rounding)
    }

    /// Of all directions: none is shorter than the one along the view.
    fn least_length(&self) -> f64 {
        let sum = self
            .corners
            .iter()
            .fold(self.corners[0].direction * 0.0, |sum, ray| {
                sum + ray.direction
            });
        length(sum) / 4.0
    }
}
