use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let squared = ray.direction.length_squared();
        let t_middle = (self.center - ray.origin).dot(ray.direction) / squared;
        let sideways = ray.at(t_middle) - self.center;
        let left_over = self.radius * self.radius - sideways.length_squared();
        if left_over < 0.0 {
            return None;
        }
        let half_chord = (left_over / squared).sqrt();
        let t = match t_middle - half_chord {
            enter if enter >= min_t => enter,
            _ => t_middle + half_chord,
        };
        if t < min_t {
            return None;
        }
        let outward = sideways + (t - t_middle) * ray.direction;
        Some(Intersection {
            t,
            normal: outward.normalize(),
        })
    }
}
