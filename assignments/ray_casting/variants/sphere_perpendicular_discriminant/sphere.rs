use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let f = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let h = -f.dot(ray.direction);
        let perpendicular = f + (h / a) * ray.direction;
        let slack = self.radius * self.radius - perpendicular.length_squared();
        if slack < 0.0 {
            return None;
        }
        let c = f.length_squared() - self.radius * self.radius;
        let q = h + (a * slack).sqrt().copysign(h);
        let (near, far) = if h > 0.0 {
            (c / q, q / a)
        } else {
            (q / a, c / q)
        };
        let t = if near >= min_t { near } else { far };
        (t >= min_t).then(|| Intersection {
            t,
            normal: (f + t * ray.direction) / self.radius,
        })
    }
}
