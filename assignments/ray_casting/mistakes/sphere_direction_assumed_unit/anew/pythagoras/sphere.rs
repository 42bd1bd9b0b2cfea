use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let to_center = self.center - ray.origin;
        let along = to_center.dot(ray.direction);
        let miss_squared = to_center.length_squared() - along * along;
        let half_chord_squared = self.radius * self.radius - miss_squared;
        if half_chord_squared < 0.0 {
            return None;
        }
        let half_chord = half_chord_squared.sqrt();
        let t = if along - half_chord >= min_t {
            along - half_chord
        } else {
            along + half_chord
        };
        if t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
