//! How far a camera's rays are from where they should be: exact casting is exact for the
//! rounded ray, and this is what rounding it does.

use pinhole::Scene;

use crate::cast::model::Exact;
use crate::cast::rays::rays;
use crate::cast::world::World;
use crate::cast::{Caster, Search};
use crate::oracle::camera;
use crate::scenes::{files, read};
use crate::vector::Vector;

/// What rounding its rays does to a scene's film.
#[derive(Clone, Debug)]
pub struct Camera {
    /// The scene.
    pub scene: String,
    /// Its pixels.
    pub pixels: usize,
    /// The largest angle between a ray as it is computed and as it is rounded once, in
    /// radians.
    pub angle: f64,
    /// The largest distance between their origins over the distance to the world's.
    pub origin: f64,
    /// Pixels that show another object for the one than for the other.
    pub changed: usize,
}

/// Of every scene of the assignment. The camera is taken as the scene file gives it once
/// read: eye, axes and width are `f64`, and exact.
pub fn cameras() -> Vec<Camera> {
    files()
        .iter()
        .map(|file| {
            let scene = read(file).expect("the scene is committed");
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            of_scene(&scene, name.into())
        })
        .collect()
}

fn of_scene(scene: &Scene, name: String) -> Camera {
    let computed = rays(scene);
    let rounded = camera::rays(scene);
    let caster = Caster::new(World::of(&scene.objects));
    let ids = |rays| {
        let (found, _) = caster.film::<Exact>(Search::Boxes, rays, scene.min_t);
        let object = |found: &Option<crate::cast::Found>| found.map(|found| found.part.object);
        found.iter().map(object).collect::<Vec<_>>()
    };
    let changed = ids(&computed)
        .into_iter()
        .zip(ids(&rounded))
        .filter(|(one, other)| one != other);
    let length = |v: Vector<f64>| v.dot(v).sqrt();
    let both = || computed.iter().zip(&rounded);
    let angle = |(one, other): (&crate::shape::Ray<f64>, &crate::shape::Ray<f64>)| {
        let (p, q) = (one.direction, other.direction);
        // The difference is exact, so that an angle far below an ulp is seen too.
        length((p - q).cross(q)) / q.dot(q)
    };
    let origin = |(one, other): (&crate::shape::Ray<f64>, &crate::shape::Ray<f64>)| {
        length(one.origin - other.origin) / length(other.origin).max(f64::MIN_POSITIVE)
    };
    Camera {
        scene: name,
        pixels: computed.len(),
        angle: both().map(angle).fold(0.0, f64::max),
        origin: both().map(origin).fold(0.0, f64::max),
        changed: changed.count(),
    }
}
