//! Primary rays, and incoherent ones that start at the hits of the primary rays.

use pinhole_study::cast::model::Exact;
use pinhole_study::random::Random;
use pinhole_study::shape;
use pinhole_study::vector::Vector;

use crate::mesh::Mesh;
use crate::peer::ours;

/// A ray in `f32`; the direction need not be unit length.
pub type Ray = shape::Ray<f32>;

/// Pixels in a row and in a column.
const SIDE: u32 = 256;

/// Rays of a camera at distance 3 from the centre of a mesh of radius 1, which fills the image.
pub fn primary() -> Vec<Ray> {
    let at = |pixel: u32| (f64::from(pixel) + 0.5) / f64::from(SIDE) * 0.8 - 0.4;
    let ray = |index: u32| {
        let (x, y) = (at(index % SIDE), at(index / SIDE));
        Ray {
            origin: Vector::new(2.0, 1.0, 2.0),
            direction: Vector::new(-2.0 / 3.0 + 0.6 * x, -1.0 / 3.0 + y, -2.0 / 3.0 - 0.6 * x)
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
    let bounce = |(t, ray): &(f64, &Ray)| {
        let wide = ray.map(f64::from, f64::from);
        let origin = wide.origin + wide.direction * (t * (1.0 - 1e-4));
        let direction = random.unit();
        shape::Ray { origin, direction }.map(|x| x as f32, |x| x as f32)
    };
    hits.map(bounce).take(primary.len()).collect()
}
