use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let length = self.normal.length();
        let normal = self.normal / length;
        let mut height = 0.0;
        let mut climb = 0.0;
        for k in 0..3 {
            height += (ray.origin[k] - self.point[k]) * normal[k];
            climb += ray.direction[k] * normal[k];
        }
        if climb == 0.0 {
            return None;
        }
        let t = -height / climb;
        if t < min_t {
            return None;
        }
        Some(Intersection { t, normal })
    }
}
