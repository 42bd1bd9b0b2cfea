use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
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
}
