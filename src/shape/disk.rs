use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::Ray;
use crate::words::{number, vector};

/// A flat disk, edge included: all points p of the plane (p − `center`) · `normal` = 0 that are at
/// most `radius` away from `center`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Disk {
    /// World space, scene units.
    pub center: DVec3,
    /// Perpendicular to the disk, as in the scene file. It may have any length but zero.
    pub normal: DVec3,
    /// Scene units, positive.
    pub radius: f64,
}

impl Notation for Disk {
    const KEYS: &'static [&'static str] = &["center", "normal", "radius"];

    fn read_table(table: &ObjectTable<'_>) -> Result<Disk, Error> {
        Ok(Disk {
            center: table.point("center")?,
            normal: table.direction("normal")?,
            radius: table.length("radius")?,
        })
    }

    fn read_samples(samples: Samples<'_>) -> Result<Disk, String> {
        Ok(Disk {
            center: samples.vector("center")?,
            normal: samples.vector("normal")?,
            radius: samples.number("radius")?,
        })
    }

    fn words(&self, digits: usize) -> String {
        let [center, normal] = [self.center, self.normal].map(|value| vector(value, digits));
        format!(
            "c = {center}, n = {normal}, r = {}",
            number(self.radius, digits)
        )
    }

    fn quantities(&self, _: &Ray) -> Vec<Quantity> {
        vec![
            Quantity::new("the radius", self.radius),
            Quantity::new("|n|", self.normal.length()),
        ]
    }

    fn conditions(&self, _: &Ray, point: DVec3) -> Vec<Condition> {
        let is_beyond = point.distance(self.center) > self.radius;
        vec![Condition::new(
            "the point lies beyond the edge",
            "the point lies inside the edge",
            is_beyond,
        )]
    }
}
