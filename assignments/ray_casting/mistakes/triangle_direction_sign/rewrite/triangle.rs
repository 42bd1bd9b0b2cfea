use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let columns = [b - a, c - a, ray.direction];
        let rhs = ray.origin - a;
        let q0 = columns[0].normalize();
        let second = columns[1] - columns[1].dot(q0) * q0;
        let q1 = second.normalize();
        let q2 = q0.cross(q1);
        let r22 = columns[2].dot(q2);
        if r22 == 0.0 {
            return None;
        }
        let t = rhs.dot(q2) / r22;
        let beta = (rhs.dot(q1) - t * columns[2].dot(q1)) / columns[1].dot(q1);
        let alpha = (rhs.dot(q0) - t * columns[2].dot(q0) - beta * columns[1].dot(q0))
            / columns[0].length();
        if t < min_t
            || [alpha, beta, 1.0 - alpha - beta]
                .iter()
                .any(|weight| *weight < 0.0)
        {
            return None;
        }
        Some(Intersection { t, normal: q2 })
    }
}
