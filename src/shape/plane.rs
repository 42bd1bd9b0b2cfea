use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::words::vector;

/// All points p with (p − `point`) · `normal` = 0; it has no edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plane {
    /// Any point of the plane; world space, scene units.
    pub point: DVec3,
    /// Perpendicular to the plane, as the scene file has it: **not** unit length in
    /// general, never zero.
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
}
