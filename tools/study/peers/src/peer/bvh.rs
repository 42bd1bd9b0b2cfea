//! The bvh crate's own search in `f32`, with Möller–Trumbore: its own test takes a
//! triangle from behind for a miss.

use ::bvh::aabb::{Aabb, Bounded};
use ::bvh::bounding_hierarchy::BHShape;
use ::bvh::bvh::Bvh;
use ::bvh::ray::Ray as Asked;
use nalgebra::{Point3, Vector3};
use pinhole_study::kernel::Kernel;
use pinhole_study::kernel::triangle::MollerTrumbore;
use pinhole_study::shape;
use pinhole_study::vector::Vector;

use super::Peer;
use crate::mesh::Mesh;
use crate::rays::Ray;

struct Listed {
    triangle: shape::Triangle<f32>,
    node: usize,
}

impl Bounded<f32, 3> for Listed {
    fn aabb(&self) -> Aabb<f32, 3> {
        let points = self
            .triangle
            .corners
            .map(|corner| Point3::from(corner.array()));
        points[1..]
            .iter()
            .fold(points[0].aabb(), |all, point| all.grow(point))
    }
}

impl BHShape<f32, 3> for Listed {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

pub fn peer(mesh: &Mesh, rays: &[Ray]) -> Peer {
    let vector = |[x, y, z]: [f32; 3]| Vector::new(x, y, z);
    let listed = |corners: &[u32; 3]| Listed {
        triangle: shape::Triangle {
            corners: corners.map(|at| vector(mesh.corners[at as usize])),
        },
        node: 0,
    };
    let mut all: Vec<_> = mesh.triangles.iter().map(listed).collect();
    let tree = Bvh::build(&mut all);
    let rays = rays.to_vec();
    Peer::new("bvh, f32", move || {
        let cast = |ray: &Ray| {
            let asked = Asked::new(Point3::from(ray.origin), Vector3::from(ray.direction));
            let given = shape::Ray {
                origin: vector(ray.origin),
                direction: vector(ray.direction),
            };
            let met = tree
                .traverse_iterator(&asked, &all)
                .filter_map(|listed| MollerTrumbore::intersect(&listed.triangle, &given, 0.0));
            f64::from(met.fold(f32::INFINITY, f32::min))
        };
        rays.iter().map(cast).collect()
    })
}
