use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let unit = Ray {
            origin: ray.origin,
            direction: ray.direction / ray.direction.length(),
        };
        let to_center = self.center - unit.origin;
        let offset_squared = to_center.cross(unit.direction).length_squared();
        let depth_squared = self.radius.powi(2) - offset_squared;
        if depth_squared < 0.0 {
            return None;
        }
        let middle = to_center.dot(unit.direction);
        let half = depth_squared.sqrt();
        for t in [middle - half, middle + half] {
            if t >= min_t {
                let normal = (unit.at(t) - self.center) / self.radius;
                return Some(Intersection { t, normal });
            }
        }
        None
    }
}
