use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal.to_array();
        let e = ray.origin.to_array();
        let d = ray.direction.to_array();
        let sum = |v: [f64; 3]| n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
        let slope = sum(d);
        if slope == 0.0 {
            return None;
        }
        let t = -sum(e) / slope;
        (t >= min_t).then(|| Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
