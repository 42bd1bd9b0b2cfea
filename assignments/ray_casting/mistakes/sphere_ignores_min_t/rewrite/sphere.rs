use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let speed = ray.direction.length();
        let forward = ray.direction / speed;
        let along = (self.center - ray.origin).dot(forward);
        let closest = ray.origin + along * forward;
        let miss_squared = closest.distance_squared(self.center);
        let radius_squared = self.radius * self.radius;
        if miss_squared > radius_squared {
            return None;
        }
        let half_chord = (radius_squared - miss_squared).sqrt();
        let enter = (along - half_chord) / speed;
        Some(Intersection {
            t: enter,
            normal: (ray.at(enter) - self.center) / self.radius,
        })
    }
}
