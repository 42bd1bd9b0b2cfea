use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let speed = ray.direction.length();
        let from_center = ray.origin - self.center;
        let along = from_center.dot(ray.direction / speed);
        let miss_squared = from_center.length_squared() - along * along;
        let radius_squared = self.radius * self.radius;
        if miss_squared > radius_squared {
            return None;
        }
        let half_chord = (radius_squared - miss_squared).sqrt();
        let enter = (along - half_chord) / speed;
        let leave = (along + half_chord) / speed;
        let t = if enter >= min_t { enter } else { leave };
        (t >= min_t).then(|| Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
