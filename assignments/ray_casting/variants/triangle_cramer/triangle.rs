use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [p0, p1, p2] = self.corners;
        let [a, b, c] = (p0 - p1).to_array();
        let [d, e, f] = (p0 - p2).to_array();
        let [g, h, i] = ray.direction.to_array();
        let [j, k, l] = (p0 - ray.origin).to_array();

        let det = |m: [[f64; 3]; 3]| {
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
        };
        let m = det([[a, d, g], [b, e, h], [c, f, i]]);
        if m == 0.0 {
            return None;
        }
        let t = det([[a, d, j], [b, e, k], [c, f, l]]) / m;
        if t < min_t {
            return None;
        }
        let gamma = det([[a, j, g], [b, k, h], [c, l, i]]) / m;
        if !(0.0..=1.0).contains(&gamma) {
            return None;
        }
        let beta = det([[j, d, g], [k, e, h], [l, f, i]]) / m;
        if beta < 0.0 || beta > 1.0 - gamma {
            return None;
        }
        let normal = (p1 - p0).cross(p2 - p0).normalize();
        Some(Intersection { t, normal })
    }
}
