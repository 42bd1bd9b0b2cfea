use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [p0, p1, p2] = self.corners;
        let first = (p0 - p1).to_array();
        let second = (p0 - p2).to_array();
        let d = ray.direction.to_array();
        let right = (p0 - ray.origin).to_array();
        let m = determinant(first, second, d);
        if m == 0.0 {
            return None;
        }
        let t = determinant(first, second, right) / m;
        let beta = determinant(right, second, d) / m;
        let gamma = determinant(first, right, d) / m;
        if t <= 1.0 || beta < 0.0 || gamma < 0.0 || beta + gamma > 1.0 {
            return None;
        }
        let normal = (p1 - p0).cross(p2 - p0).normalize();
        Some(Intersection { t, normal })
    }
}

fn determinant(x: [f64; 3], y: [f64; 3], z: [f64; 3]) -> f64 {
    x[0] * (y[1] * z[2] - y[2] * z[1])
        + x[1] * (y[2] * z[0] - y[0] * z[2])
        + x[2] * (y[0] * z[1] - y[1] * z[0])
}
