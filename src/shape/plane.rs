use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::Ray;
use crate::words::vector;

/// All points p with (p − `point`) · `normal` = 0; it has no edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plane {
    /// Any point of the plane; world space, scene units.
    pub point: DVec3,
    /// Perpendicular to the plane, as in the scene file. It may have any length but zero.
    pub normal: DVec3,
}

impl Notation for Plane {
    const KEYS: &'static [&'static str] = &["point", "normal"];

    fn read_table(table: &ObjectTable<'_>) -> Result<Plane, Error> {
        Ok(Plane {
            point: table.point("point")?,
            normal: table.direction("normal")?,
        })
    }

    fn read_samples(samples: Samples<'_>) -> Result<Plane, String> {
        Ok(Plane {
            point: samples.vector("point")?,
            normal: samples.vector("normal")?,
        })
    }

    fn words(&self, digits: usize) -> String {
        let (point, normal) = (vector(self.point, digits), vector(self.normal, digits));
        format!("through {point}, n = {normal}")
    }

    fn quantities(&self, ray: &Ray) -> Vec<Quantity> {
        let along = ray.direction.dot(self.normal).abs();
        let length = self.normal.length();
        vec![
            Quantity::new("|n|", length),
            Quantity::new("|d · n|", along),
            Quantity::new("|d · n| / |n|", along / length),
            Quantity::new(
                "|d · n| / (|d| |n|)",
                along / ray.direction.length() / length,
            ),
        ]
    }

    fn conditions(&self, ray: &Ray, _: DVec3) -> Vec<Condition> {
        let [along, height] = [ray.direction, ray.origin - self.point].map(|v| v.dot(self.normal));
        vec![
            Condition::new(
                "the ray is parallel to the plane",
                "the ray is not parallel to the plane",
                along == 0.0,
            ),
            Condition::new(
                "the plane lies behind the ray's origin",
                "the plane lies in front of the ray's origin",
                along * height > 0.0,
            ),
            Condition::new(
                "the ray comes from the side that n points to",
                "the ray comes from the side that n points away from",
                height > 0.0,
            ),
        ]
    }
}
