//! obvhs's own search and its own test of a triangle, in `f32`.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as Asked, RayHit};
use obvhs::triangle::Triangle;

use super::Peer;
use crate::mesh::Mesh;
use crate::rays::Ray;

fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let triangle = |corners: &[u32; 3]| {
        let [v0, v1, v2] = corners.map(|at| Vec3A::from(mesh.corners[at as usize]));
        Triangle { v0, v1, v2 }
    };
    mesh.triangles.iter().map(triangle).collect()
}

macro_rules! searched {
    ($name:expr, $build:ident, $mesh:expr, $rays:expr) => {{
        let triangles = triangles($mesh);
        let effort = BvhBuildParams::medium_build();
        let tree = $build(&triangles, effort, &mut Duration::default());
        let at = tree.primitive_indices.iter().map(|at| *at as usize);
        let ordered: Vec<_> = at.map(|at| triangles[at]).collect();
        let rays = $rays.to_vec();
        Peer::new($name, move || {
            let cast = |ray: &Ray| {
                let asked = Asked::new_inf(ray.origin.into(), ray.direction.into());
                let mut hit = RayHit::none();
                tree.ray_traverse(asked, &mut hit, |ray, at| ordered[at].intersect(ray));
                if hit.t < f32::MAX {
                    f64::from(hit.t)
                } else {
                    f64::INFINITY
                }
            };
            rays.iter().map(cast).collect()
        })
    }};
}

pub fn two_wide(mesh: &Mesh, rays: &[Ray]) -> Peer {
    searched!("obvhs, 2 wide, f32", build_bvh2_from_tris, mesh, rays)
}

pub fn eight_wide(mesh: &Mesh, rays: &[Ray]) -> Peer {
    searched!("obvhs, 8 wide, f32", build_cwbvh_from_tris, mesh, rays)
}
