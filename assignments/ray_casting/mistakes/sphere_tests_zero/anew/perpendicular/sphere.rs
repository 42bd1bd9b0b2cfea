use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let f = ray.origin - self.center;
        let s = -f.dot(ray.direction) / ray.direction.length_squared();
        let perpendicular = f + s * ray.direction;
        let slack = self.radius * self.radius - perpendicular.length_squared();
        if slack < 0.0 {
            return None;
        }
        let w = slack.sqrt() / ray.direction.length();

        let t = if s - w > 0.0 { s - w } else { s + w };
        (t > 0.0).then(|| Intersection {
            t,
            normal: (f + t * ray.direction) / self.radius,
        })
    }
}
