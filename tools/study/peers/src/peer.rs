//! The casters to compare. Each casts the same rays at the same mesh and returns the first t of
//! each.

use pinhole_study::cast::model::{Exact, Model, Plain};
use pinhole_study::cast::world::{Primitive, View, World};
use pinhole_study::cast::{Caster, Tally};
use pinhole_study::kernel::Camera;
use pinhole_study::shape::Triangle;
use pinhole_study::speed::now;
use pinhole_study::vector::Vector;

use crate::mesh::Mesh;
use crate::rays::Ray;

/// A caster with its acceleration structure built.
pub struct Peer {
    /// The name in the table.
    pub name: &'static str,
    /// CPU time to build the acceleration structure, in milliseconds.
    pub building: f64,
    /// The first t of each ray; infinite for a miss.
    pub cast: Cast,
}

/// Casts all rays and returns their t.
pub type Cast = Box<dyn Fn() -> Vec<f64>>;

/// The exact caster: the first in the list, and the reference for all others.
pub const EXACT: &str = "ours, exact";
/// The caster that our targets are relative to.
pub const ROBUST: &str = "Embree robust, f32";
/// Parry in `f64`, the type of numbers that our caster uses.
pub const PARRY: &str = "parry3d-f64";

type Maker = fn(&Mesh, &[Ray]) -> Cast;

const ALL: &[(&str, Maker)] = &[
    (EXACT, ours::<Exact<true>>),
    ("ours, plain f64", ours::<Plain>),
    #[cfg(embree)]
    (ROBUST, crate::embree::robust),
    (PARRY, parry),
];

/// Builds every caster that is available.
pub fn all(mesh: &Mesh, rays: &[Ray]) -> Vec<Peer> {
    let timed = |(name, make): &(&'static str, Maker)| {
        let (start, cast) = (now(), make(mesh, rays));
        let building = (now() - start).as_secs_f64() * 1e3;
        Peer {
            name,
            building,
            cast,
        }
    };
    ALL.iter().map(timed).collect()
}

/// The study's caster, with its bounding volume hierarchy.
fn ours<M: Model>(mesh: &Mesh, rays: &[Ray]) -> Cast {
    let wide = |[x, y, z]: [f32; 3]| Vector::new(x, y, z).map(f64::from);
    let mut world = World::default();
    for corners in &mesh.triangles {
        let corners = corners.map(wide);
        world.add(0, Primitive::Triangle(Triangle { corners }));
    }
    let eye = rays[0].origin.map(f64::from);
    let view = M::FILTERS.then_some(View {
        camera: Camera::Perspective { eye },
        accuracy: f64::INFINITY,
    });
    let caster = Caster::new(world, view, true);
    let rays: Vec<_> = rays
        .iter()
        .map(|ray| ray.map(f64::from, f64::from))
        .collect();
    Box::new(move || {
        let mut tally = Tally::default();
        let mut first = |ray| caster.first::<M>(ray, 0.0, &mut tally);
        let t = |ray| first(ray).map_or(f64::INFINITY, |found| found.t);
        rays.iter().map(t).collect()
    })
}

/// parry3d in `f64`.
fn parry(mesh: &Mesh, rays: &[Ray]) -> Cast {
    use parry3d_f64::math::Vector;
    use parry3d_f64::query::{Ray as Asked, RayCast};
    use parry3d_f64::shape::TriMesh;
    let vector = |point: [f32; 3]| {
        let [x, y, z] = point.map(f64::from);
        Vector::new(x, y, z)
    };
    let corners: Vec<_> = mesh
        .triangles
        .as_flattened()
        .iter()
        .copied()
        .map(vector)
        .collect();
    let faces = (0..mesh.triangles.len() as u32).map(|at| [0, 1, 2].map(|corner| 3 * at + corner));
    let shape = TriMesh::new(corners, faces.collect()).expect("a mesh has triangles");
    let ray = |ray: &Ray| Asked::new(vector(ray.origin.array()), vector(ray.direction.array()));
    let rays: Vec<_> = rays.iter().map(ray).collect();
    Box::new(move || {
        let t = |ray: &Asked| shape.cast_local_ray(ray, f64::MAX, false);
        let all = rays.iter().map(t);
        all.map(|t| t.unwrap_or(f64::INFINITY)).collect()
    })
}
