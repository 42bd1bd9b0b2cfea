//! Primary rays, and incoherent ones that start at the hits of the primary rays.

use pinhole_study::cast::model::Exact;
use pinhole_study::random::Random;

use crate::mesh::Mesh;
use crate::peer::ours;

/// A ray in `f32`; the direction need not be unit length.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// The point at t = 0.
    pub origin: [f32; 3],
    /// The vector from t = 0 to t = 1.
    pub direction: [f32; 3],
}

/// Pixels in a row and in a column.
const SIDE: u32 = 256;

/// Rays of a camera at distance 3 from the centre of a mesh of radius 1, which fills the image.
pub fn primary() -> Vec<Ray> {
    let at = |pixel: u32| (f64::from(pixel) + 0.5) / f64::from(SIDE) * 0.8 - 0.4;
    let ray = |index: u32| {
        let (x, y) = (at(index % SIDE), at(index / SIDE));
        Ray {
            origin: [2.0, 1.0, 2.0],
            direction: [-2.0 / 3.0 + 0.6 * x, -1.0 / 3.0 + y, -2.0 / 3.0 - 0.6 * x]
                .map(|number| number as f32),
        }
    };
    (0..SIDE * SIDE).map(ray).collect()
}

/// As many rays, which start slightly before the hits of the primary rays, in random
/// directions.
pub fn incoherent(mesh: &Mesh, primary: &[Ray]) -> Vec<Ray> {
    let met: Vec<_> = ours::<Exact>(mesh, primary)()
        .into_iter()
        .zip(primary)
        .collect();
    let mut random = Random::new(1, "incoherent");
    let hits = met.iter().filter(|(t, _)| t.is_finite()).cycle();
    let bounce = |(t, ray): &(f64, &Ray)| Ray {
        origin: [0, 1, 2].map(|axis| {
            let (e, d) = (f64::from(ray.origin[axis]), f64::from(ray.direction[axis]));
            (e + d * t * (1.0 - 1e-4)) as f32
        }),
        direction: random.unit().array().map(|number| number as f32),
    };
    hits.map(bounce).take(primary.len()).collect()
}
