use glam::DVec3;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::words::vector;

/// A flat triangle, edges included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Triangle {
    /// The corners a, b, c, counter-clockwise when seen from outside; world space.
    pub corners: [DVec3; 3],
}

/// Below this sine of the angle at its first corner a triangle is flat: decimals such
/// as 0.3 are rounded, which lifts corners off a line by about 1e-16 of their size.
const ON_ONE_LINE: f64 = 1e-14;

impl Notation for Triangle {
    const KEYS: &'static [&'static str] = &["corners"];

    fn read_table(table: &ObjectTable<'_>) -> Result<Triangle, Error> {
        let corners: Spanned<[DVec3; 3]> = table.get("corners")?;
        let [a, b, c] = *corners.get_ref();
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Err(table.source.not_finite("corners", corners.span()));
        }
        let (t_1, t_2) = ((b - a).normalize_or_zero(), (c - a).normalize_or_zero());
        if t_1.cross(t_2).length() < ON_ONE_LINE {
            return Err(table.source.error(
                corners.span(),
                "these corners lie on one line, so the triangle has no area and no normal",
                "move one corner off the line",
            ));
        }
        Ok(Triangle { corners: [a, b, c] })
    }

    fn read_samples(samples: Samples<'_>) -> Result<Triangle, String> {
        let corner = |name| samples.vector(name);
        Ok(Triangle {
            corners: [corner("a")?, corner("b")?, corner("c")?],
        })
    }

    fn words(&self, digits: usize) -> String {
        let [a, b, c] = self.corners.map(|corner| vector(corner, digits));
        format!("a = {a}, b = {b}, c = {c}")
    }
}
