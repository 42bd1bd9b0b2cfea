use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let speed = ray.direction.length();
        let forward = ray.direction / speed;
        let to_center = self.center - ray.origin;
        let distance = to_center.dot(forward);
        let closest = ray.origin + distance * forward;
        let miss_squared = closest.distance_squared(self.center);
        let radius_squared = self.radius * self.radius;
        if miss_squared > radius_squared {
            return None;
        }

        let half_chord = (radius_squared - miss_squared).sqrt();
        let enter = (distance - half_chord) / speed;
        let leave = (distance + half_chord) / speed;
        let t = match (enter >= min_t, leave >= min_t) {
            (true, _) => enter,
            (false, true) => leave,
            (false, false) => return None,
        };
        let outward = ray.at(t) - self.center;
        Some(Intersection {
            t,
            normal: outward / outward.length(),
        })
    }
}
