use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // In the triangle's own frame its corners are 0, x and y (Woop 2004).
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a).normalize();
        let to_world = DMat3::from_cols(b - a, c - a, normal);
        let to_own = to_world.inverse();
        let origin = to_own * (ray.origin - a);
        let direction = to_own * ray.direction;
        if direction.z == 0.0 {
            return None;
        }
        let t = -origin.z / direction.z;
        let p = (origin + t * direction).truncate();
        let inside = p.min_element() >= 0.0 && p.element_sum() <= 1.0;
        (inside && t >= min_t).then_some(Intersection { t, normal })
    }
}
