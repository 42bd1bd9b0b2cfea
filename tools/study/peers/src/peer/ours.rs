//! The study's caster, in boxes.

use pinhole_study::cast::model::Model;
use pinhole_study::cast::world::{Primitive, World};
use pinhole_study::cast::{Caster, Search, Tally};
use pinhole_study::shape::{self, Triangle};
use pinhole_study::vector::Vector;

use super::Peer;
use crate::mesh::Mesh;
use crate::rays::Ray;

pub fn peer<M: Model>(name: &'static str, mesh: &Mesh, rays: &[Ray]) -> Peer {
    let wide = |[x, y, z]: [f32; 3]| Vector::new(x, y, z).map(f64::from);
    let mut world = World::default();
    for triangle in &mesh.triangles {
        let corners = triangle.map(|at| wide(mesh.corners[at as usize]));
        world.add(0, Primitive::Triangle(Triangle { corners }));
    }
    let caster = Caster::new(world);
    let ray = |ray: &Ray| shape::Ray {
        origin: wide(ray.origin),
        direction: wide(ray.direction),
    };
    let rays: Vec<_> = rays.iter().map(ray).collect();
    Peer::new(name, move || {
        let mut tally = Tally::default();
        let mut first = |ray| caster.first::<M>(Search::Boxes, ray, 0.0, &mut tally);
        let t = |ray| first(ray).map_or(f64::INFINITY, |found| found.t);
        rays.iter().map(t).collect()
    })
}
