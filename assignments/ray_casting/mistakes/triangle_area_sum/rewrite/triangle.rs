use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let corners = self.corners.map(|corner| corner - ray.origin);
        let n = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let approach = ray.direction.dot(n);
        let t = corners[0].dot(n) / approach;
        if approach == 0.0 || t < min_t {
            return None;
        }
        let normal = n.normalize();
        let p = t * ray.direction;
        let mut parts = 0.0;
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let (to_i, to_j) = (corners[i] - p, corners[j] - p);
            parts += to_i.cross(to_j).dot(normal).abs() / 2.0;
        }
        if (parts - n.length() / 2.0).abs() > 1e-3 {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
