//! The casters to compare. Each casts the same rays at the same mesh and returns the first t of
//! each.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use pinhole_study::cast::model::{Exact, FromCamera, Model, Plain};
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
    (EXACT, exact),
    ("ours, plain f64", ours::<Plain>),
    #[cfg(embree)]
    (ROBUST, crate::embree::robust),
    #[cfg(embree)]
    ("Embree fast, f32", crate::embree::fast),
    ("parry3d, f32", parry_f32),
    (PARRY, parry_f64),
    ("obvhs, 8 wide, f32", eight_wide),
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

/// The exact caster. If all rays start at the same point, they are cast as those of a camera.
fn exact(mesh: &Mesh, rays: &[Ray]) -> Cast {
    match rays.iter().all(|ray| ray.origin == rays[0].origin) {
        true => ours::<FromCamera<true>>(mesh, rays),
        false => ours::<Exact>(mesh, rays),
    }
}

/// The study's caster, with its bounding volume hierarchy.
pub fn ours<M: Model>(mesh: &Mesh, rays: &[Ray]) -> Cast {
    let wide = |[x, y, z]: [f32; 3]| Vector::new(x, y, z).map(f64::from);
    let mut world = World::default();
    for corners in mesh.each() {
        let corners = corners.map(wide);
        world.add(0, Primitive::Triangle(Triangle { corners }));
    }
    let eye = rays[0].origin.map(f64::from);
    let view = M::HAS_CAMERA.then_some(View {
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

/// obvhs's traversal and triangle test, in `f32`.
fn eight_wide(mesh: &Mesh, rays: &[Ray]) -> Cast {
    let triangle = |corners: [[f32; 3]; 3]| {
        let [v0, v1, v2] = corners.map(Vec3A::from);
        obvhs::triangle::Triangle { v0, v1, v2 }
    };
    let triangles: Vec<_> = mesh.each().map(triangle).collect();
    let effort = BvhBuildParams::medium_build();
    let tree = build_cwbvh_from_tris(&triangles, effort, &mut Duration::default());
    let at = tree.primitive_indices.iter().map(|at| *at as usize);
    let ordered: Vec<_> = at.map(|at| triangles[at]).collect();
    let rays = rays.to_vec();
    Box::new(move || {
        let cast = |ray: &Ray| {
            let asked =
                obvhs::ray::Ray::new_inf(ray.origin.array().into(), ray.direction.array().into());
            let mut hit = RayHit::none();
            tree.ray_traverse(asked, &mut hit, |ray, at| ordered[at].intersect(ray));
            match hit.t < f32::MAX {
                true => f64::from(hit.t),
                false => f64::INFINITY,
            }
        };
        rays.iter().map(cast).collect()
    })
}

/// parry3d, in `f32` or `f64`.
macro_rules! parry {
    ($name:ident, $parry:ident, $number:ty) => {
        fn $name(mesh: &Mesh, rays: &[Ray]) -> Cast {
            use $parry::math::Vector;
            use $parry::query::{Ray as Asked, RayCast};
            let vector = |point: [f32; 3]| {
                let [x, y, z] = point.map(<$number>::from);
                Vector::new(x, y, z)
            };
            let corners = mesh.corners.iter().copied().map(vector).collect();
            let shape = $parry::shape::TriMesh::new(corners, mesh.triangles.clone());
            let shape = shape.expect("a mesh has triangles");
            let ray =
                |ray: &Ray| Asked::new(vector(ray.origin.array()), vector(ray.direction.array()));
            let rays: Vec<_> = rays.iter().map(ray).collect();
            Box::new(move || {
                let t = |ray: &Asked| shape.cast_local_ray(ray, <$number>::MAX, false);
                let all = rays.iter().map(t);
                all.map(|t| t.map_or(f64::INFINITY, f64::from)).collect()
            })
        }
    };
}

parry!(parry_f32, parry3d, f32);
parry!(parry_f64, parry3d_f64, f64);
