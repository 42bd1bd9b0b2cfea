use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let [to_a, to_b, to_c] = [a, b, c].map(|corner| corner - ray.origin);
        let volume_a = ray.direction.dot(to_b.cross(to_c));
        let volume_b = ray.direction.dot(to_c.cross(to_a));
        let volume_c = ray.direction.dot(to_a.cross(to_b));
        let whole = volume_a + volume_b + volume_c;
        if whole >= 0.0 {
            return None;
        }
        let (beta, gamma) = (volume_b / whole, volume_c / whole);
        let t = to_a.dot(to_b.cross(to_c)) / whole;
        (beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0 && t >= min_t).then(|| Intersection {
            t,
            normal: (b - a).cross(c - a).normalize(),
        })
    }
}
