use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let edges = [b - a, c - a];
        let normal = edges[0].cross(edges[1]);
        let [from, to] = [0.0, 1.0].map(|t| (ray.at(t) - a).dot(normal));
        let t = from / (from - to);
        if !t.is_finite() || t < min_t {
            return None;
        }
        let q = ray.at(t) - a;
        let mut rest = 1.0;
        for edge in edges {
            let weight = q.dot(edge) / edge.length_squared();
            if weight < 0.0 {
                return None;
            }
            rest -= weight;
        }
        if rest < 0.0 {
            return None;
        }
        Some(Intersection {
            t,
            normal: normal.normalize(),
        })
    }
}
