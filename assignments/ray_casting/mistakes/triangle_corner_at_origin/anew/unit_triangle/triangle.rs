use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let t1 = b - a;
        let t2 = c - a;
        let to_unit = DMat3::from_cols(t1, t2, t1.cross(t2)).inverse();
        let start = to_unit * (ray.origin);
        let step = to_unit * ray.direction;
        if step.z == 0.0 {
            return None;
        }
        let t = -start.z / step.z;
        let (x, y) = (start.x + t * step.x, start.y + t * step.y);
        if x >= 0.0 && y >= 0.0 && x + y <= 1.0 && t >= min_t {
            return Some(Intersection {
                t,
                normal: t1.cross(t2).normalize(),
            });
        }
        None
    }
}
