//! parry3d in both types of numbers.

use super::Peer;
use crate::mesh::Mesh;
use crate::rays::Ray;

macro_rules! parry {
    ($parry:ident, $name:expr, $mesh:expr, $rays:expr, $number:ty) => {{
        use $parry::math::Vector;
        use $parry::query::{Ray, RayCast};
        let vector = |[x, y, z]: [f32; 3]| {
            Vector::new(<$number>::from(x), <$number>::from(y), <$number>::from(z))
        };
        let corners = $mesh.corners.iter().copied().map(vector).collect();
        let shape = $parry::shape::TriMesh::new(corners, $mesh.triangles.clone());
        let shape = shape.expect("a mesh has triangles");
        let ray = |ray: &crate::rays::Ray| Ray::new(vector(ray.origin), vector(ray.direction));
        let rays: Vec<_> = $rays.iter().map(ray).collect();
        Peer::new($name, move || {
            let t = |ray: &Ray| shape.cast_local_ray(ray, <$number>::MAX, false);
            let all = rays.iter().map(t);
            all.map(|t| t.map_or(f64::INFINITY, f64::from)).collect()
        })
    }};
}

pub fn single(mesh: &Mesh, rays: &[Ray]) -> Peer {
    parry!(parry3d, "parry3d, f32", mesh, rays, f32)
}

pub fn double(name: &'static str, mesh: &Mesh, rays: &[Ray]) -> Peer {
    parry!(parry3d_f64, name, mesh, rays, f64)
}
