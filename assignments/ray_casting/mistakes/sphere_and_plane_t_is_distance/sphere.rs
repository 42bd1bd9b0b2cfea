use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction.normalize();
        let to_center = self.center - ray.origin;
        let along = to_center.dot(d);
        let half_chord_squared =
            self.radius * self.radius - (to_center - along * d).length_squared();
        if half_chord_squared < 0.0 {
            return None;
        }
        let half_chord = half_chord_squared.sqrt();
        let t = [along - half_chord, along + half_chord]
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.origin + t * d - self.center).normalize(),
        })
    }
}
