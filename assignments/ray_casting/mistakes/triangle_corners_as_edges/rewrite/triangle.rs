use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b, c);
        let n = t1.cross(t2);
        let along = n.dot(ray.direction);
        if along == 0.0 {
            return None;
        }
        let from = ray.origin - a;
        let t = -n.dot(from) / along;
        let at = from + t * ray.direction;
        let drop = n.abs().max_position();
        let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
        let alpha = (at[i] * t2[j] - at[j] * t2[i]) / n[drop];
        let beta = (t1[i] * at[j] - t1[j] * at[i]) / n[drop];
        let on_triangle = alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0;
        if !on_triangle || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: n.normalize(),
        })
    }
}
