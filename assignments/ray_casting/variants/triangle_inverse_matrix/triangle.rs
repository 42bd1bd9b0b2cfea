use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let origin = self.corners[0];
        let sides = [1, 2].map(|corner| self.corners[corner] - origin);
        let system = DMat3::from_cols(sides[0], sides[1], -ray.direction);
        if system.determinant() == 0.0 {
            return None;
        }
        let solution = system.inverse() * (ray.origin - origin);
        let weights = [1.0 - solution.x - solution.y, solution.x, solution.y];
        if weights.iter().any(|weight| *weight < 0.0) || solution.z < min_t {
            return None;
        }
        Some(Intersection {
            t: solution.z,
            normal: sides[0].cross(sides[1]).normalize(),
        })
    }
}
