use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal.to_array();
        let e = ray.origin.to_array();
        let d = ray.direction.to_array();
        let p = self.point.to_array();
        let mut above = 0.0;
        let mut below = 0.0;
        for axis in 0..3 {
            above += n[axis] * (p[axis] - e[axis]);
            below += n[axis] * d[axis];
        }

        if below * below < 1e-8 {
            return None;
        }
        let t = above / below;
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: self.normal.normalize(),
        })
    }
}
