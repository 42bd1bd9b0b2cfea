use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let row1 = b - a;
        let row2 = c - a;
        let row3 = -ray.direction;
        let normal = row1.cross(row2);
        let det = row3.dot(normal);
        if det == 0.0 {
            return None;
        }
        let rhs = ray.origin - a;
        let solution = (rhs.x * row2.cross(row3) + rhs.y * row3.cross(row1) + rhs.z * normal) / det;
        let [alpha, beta, t] = solution.to_array();
        (alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t >= min_t).then(|| Intersection {
            t,
            normal: normal.normalize(),
        })
    }
}
