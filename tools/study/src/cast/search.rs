//! What is looked at to find what a ray meets first, and which way is cheaper: by a model
//! whose prices are instructions, which repeat, and no stopwatch.

use super::world::{Part, Primitive};

/// What is looked at to find what a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// Every part.
    BruteForce,
    /// The parts in boxes that the ray meets.
    Boxes,
}

/// What the exact caster takes for a ray, in instructions, by callgrind: `render --plan` on
/// scenes of 1 to 16 parts that rays pass by, at two resolutions, and the difference for a
/// pixel.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Prices {
    /// Of asking one sphere.
    pub sphere: u64,
    /// Of asking one triangle.
    pub triangle: u64,
    /// Of searching boxes, where there are few.
    pub boxes: u64,
}

/// As measured for x86-64.
pub const PRICES: Prices = Prices {
    sphere: 112,
    triangle: 156,
    boxes: 390,
};

impl Search {
    /// How tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Search::BruteForce => "brute force",
            Search::Boxes => "boxes",
        }
    }

    /// The cheaper one for these parts: the same parts always have the same. Planes are in no
    /// box, and cost as much either way.
    pub fn cheaper(parts: &[Part]) -> Search {
        match price_of_all(parts) > PRICES.boxes {
            true => Search::Boxes,
            false => Search::BruteForce,
        }
    }
}

/// Instructions to ask every part that can be in a box.
pub fn price_of_all(parts: &[Part]) -> u64 {
    let price = |part: &Part| match part.shape {
        Primitive::Sphere(_) => PRICES.sphere,
        Primitive::Plane(_) => 0,
        Primitive::Triangle(_) => PRICES.triangle,
    };
    parts.iter().map(price).sum()
}
