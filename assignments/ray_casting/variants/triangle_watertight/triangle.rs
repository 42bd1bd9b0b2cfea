use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction;
        let kz = d.abs().max_position();
        let (kx, ky) = ((kz + 1) % 3, (kz + 2) % 3);
        let (sx, sy) = (d[kx] / d[kz], d[ky] / d[kz]);
        let [a, b, c] = self.corners.map(|corner| {
            let from_eye = corner - ray.origin;
            let depth = from_eye[kz];
            (from_eye[kx] - sx * depth, from_eye[ky] - sy * depth, depth)
        });
        let u = c.0 * b.1 - c.1 * b.0;
        let v = a.0 * c.1 - a.1 * c.0;
        let w = b.0 * a.1 - b.1 * a.0;
        let some_negative = u < 0.0 || v < 0.0 || w < 0.0;
        let some_positive = u > 0.0 || v > 0.0 || w > 0.0;
        if some_negative && some_positive {
            return None;
        }
        let determinant = u + v + w;
        if determinant == 0.0 {
            return None;
        }
        let t = (u * a.2 + v * b.2 + w * c.2) / (determinant * d[kz]);
        if t < min_t {
            return None;
        }
        let [a, b, c] = self.corners;
        Some(Intersection {
            t,
            normal: (b - a).cross(c - a).normalize(),
        })
    }
}
