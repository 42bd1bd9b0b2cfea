//! The camera whose middle pixel looks along the worked ray, and its picture of nine pixels.

use glam::dvec3;
use pinhole::{Camera, Hit, Intersection, Pixel, Projection, Resolution, Shape};

use super::shapes::{PLANE, RAY, SPHERE, TRIANGLE};
use super::{Values, shown, vector};
use crate::error::{Error, Result};
use crate::reference::Reference;

/// Columns and rows.
pub const RESOLUTION: Resolution = Resolution { n_x: 3, n_y: 3 };

/// Looks along (1, 2, −2), with f = 3 and an image plane of 3 × 3: u = (2, −2, −1)/3,
/// v = (2, 1, 2)/3, w = (−1, −2, 2)/3, and pixels of one unit.
pub fn camera() -> Result<Camera> {
    let projection = Projection::Perspective { focal_length: 3.0 };
    let up = dvec3(2.0, 1.0, 2.0);
    Camera::new(RAY.origin, RAY.direction, up, (3.0, 3.0), projection)
        .ok_or_else(|| Error::environment("view and up are parallel", "report this"))
}

/// The objects, in the order in which the chapters meet them.
pub fn objects() -> [(&'static str, Shape); 3] {
    [
        ("plane", Shape::Plane(PLANE)),
        ("sphere", Shape::Sphere(SPHERE)),
        ("triangle", Shape::Triangle(TRIANGLE)),
    ]
}

/// Adds the t of each object in each pixel, and what each pixel shows.
pub fn add(values: &mut Values, reference: &Reference) -> Result<()> {
    let camera = camera()?;
    let objects = objects();
    let shapes: Vec<Shape> = objects.iter().map(|(_, shape)| shape.clone()).collect();
    let t = |at: Option<Intersection>| at.map_or("–".into(), |at| shown(at.t));
    for j in 0..RESOLUTION.n_y {
        for i in 0..RESOLUTION.n_x {
            let ray = reference.viewing_ray(camera, Pixel { i, j }, RESOLUTION)?;
            let mut add = |name: &str, text| values.insert(format!("nine_{name}_{i}_{j}"), text);
            add("direction", vector(ray.direction));
            for (name, shape) in &objects {
                add(name, t(reference.intersect(shape, ray, 1.0)?));
            }
            let first = reference.first_hit(&shapes, ray, 1.0)?;
            let words = |hit: Hit| {
                let (name, _) = objects[hit.object];
                format!("{name}, {}", shown(hit.intersection.t))
            };
            add("first", first.map_or("–".into(), words));
        }
    }
    Ok(())
}
