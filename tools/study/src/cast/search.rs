//! Chooses the cheaper way to find the first hit: brute force or a bounding volume hierarchy.
//! The cost model counts instructions, which repeat exactly, unlike times.

use super::world::{Part, Primitive};

/// How to find the first hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// Test every part.
    BruteForce,
    /// Test the parts in the boxes of the hierarchy that the ray enters.
    Boxes,
}

/// Costs of the exact caster per ray, in instructions. They were measured with callgrind. For
/// spheres and triangles, `render --plan` cast scenes of 1 to 3 parts that all rays miss, at two
/// resolutions, and the difference of the two counts was divided by the difference in pixels.
/// `boxes` is what the hierarchy of the scene `inside_a_box` adds to the tests in its leaves.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Prices {
    /// Testing one sphere.
    pub sphere: u64,
    /// Testing one triangle.
    pub triangle: u64,
    /// Traversing the hierarchy of a small scene that fills the picture.
    pub boxes: u64,
}

/// The costs measured on x86-64.
pub const PRICES: Prices = Prices {
    sphere: 32,
    triangle: 67,
    boxes: 450,
};

impl Search {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Search::BruteForce => "brute force",
            Search::Boxes => "boxes",
        }
    }

    /// The cheaper search for these parts; it depends on nothing else. Planes are ignored,
    /// because they are in no box and cost the same either way.
    pub fn cheaper(parts: &[Part]) -> Search {
        match price_of_all(parts) > PRICES.boxes {
            true => Search::Boxes,
            false => Search::BruteForce,
        }
    }
}

/// Instructions to test every part that can be in a box.
pub fn price_of_all(parts: &[Part]) -> u64 {
    let price = |part: &Part| match part.shape {
        Primitive::Sphere(_) => PRICES.sphere,
        Primitive::Plane(_) => 0,
        Primitive::Triangle(_) => PRICES.triangle,
    };
    parts.iter().map(price).sum()
}
