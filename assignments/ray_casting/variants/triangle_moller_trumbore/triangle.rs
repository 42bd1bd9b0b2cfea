use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [v0, v1, v2] = self.corners;
        let edge1 = v1 - v0;
        let edge2 = v2 - v0;
        let pvec = ray.direction.cross(edge2);
        let inv_det = edge1.dot(pvec).recip();
        if !inv_det.is_finite() {
            return None;
        }

        let tvec = ray.origin - v0;
        let u = tvec.dot(pvec) * inv_det;
        if u < 0.0 || u > 1.0 {
            return None;
        }
        let qvec = tvec.cross(edge1);
        let v = ray.direction.dot(qvec) * inv_det;
        if v < 0.0 || u + v > 1.0 {
            return None;
        }
        let t = edge2.dot(qvec) * inv_det;
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: edge1.cross(edge2).normalize(),
        })
    }
}
