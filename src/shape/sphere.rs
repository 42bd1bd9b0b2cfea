use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::{Intersection, Ray};
use crate::words::{number, vector};

/// All points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sphere {
    /// World space, scene units.
    pub center: DVec3,
    /// Scene units, positive.
    pub radius: f64,
}

impl Notation for Sphere {
    const KEYS: &'static [&'static str] = &["center", "radius"];

    fn read_table(table: &ObjectTable<'_>) -> Result<Sphere, Error> {
        Ok(Sphere {
            center: table.point("center")?,
            radius: table.length("radius")?,
        })
    }

    fn read_samples(samples: Samples<'_>) -> Result<Sphere, String> {
        Ok(Sphere {
            center: samples.vector("center")?,
            radius: samples.number("radius")?,
        })
    }

    fn words(&self, digits: usize) -> String {
        let (center, radius) = (vector(self.center, digits), number(self.radius, digits));
        format!("c = {center}, r = {radius}")
    }

    /// The discriminant is computed from the distance of the ray's line to the centre, because the
    /// subtraction in b² − 4ac loses digits.
    fn quantities(&self, ray: &Ray) -> Vec<Quantity> {
        let Ray { origin, direction } = *ray;
        let apart = (self.center - origin).reject_from(direction).length();
        let quarter = (self.radius - apart) * (self.radius + apart) * direction.length_squared();
        vec![
            Quantity::new("the radius", self.radius),
            Quantity::new("the discriminant b² − 4ac", 4.0 * quarter),
        ]
    }

    fn conditions(&self, ray: &Ray, _: DVec3) -> Vec<Condition> {
        let to_center = self.center - ray.origin;
        let starts_inside = to_center.length() < self.radius;
        let is_behind = to_center.dot(ray.direction) < 0.0;
        vec![
            Condition::new(
                "the ray starts inside the sphere",
                "the ray starts outside the sphere",
                starts_inside,
            ),
            Condition::new(
                "the centre lies behind the ray's origin",
                "the centre lies in front of the ray's origin",
                is_behind,
            ),
        ]
    }

    /// Both points lie equally far from the point of the ray that is nearest to the centre.
    fn other(&self, ray: &Ray, there: Intersection) -> Option<(&'static str, Intersection)> {
        let to_center = self.center - ray.at(there.t);
        let step = 2.0 * to_center.dot(ray.direction) / ray.direction.dot(ray.direction);
        let normal = there.normal + step / self.radius * ray.direction;
        let t = there.t + step;
        Some((
            "that of the other point where the ray meets the sphere",
            Intersection { t, normal },
        ))
    }
}
