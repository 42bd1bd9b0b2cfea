use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let v = ray.origin - self.center;
        let dd = ray.direction.dot(ray.direction);
        let p = 2.0 * v.dot(ray.direction) / dd;
        let q = (v.dot(v) - self.radius.powi(2)) / dd;
        let inner = (p / 2.0).powi(2) - q;
        if inner < 0.0 {
            return None;
        }

        let (t1, t2) = (-p / 2.0 - inner.sqrt(), -p / 2.0 + inner.sqrt());
        if t1 >= min_t {
            Some(Intersection {
                t: t1,
                normal: (ray.at(t1) - self.center).normalize(),
            })
        } else if t2 >= min_t {
            Some(Intersection {
                t: t2,
                normal: (ray.at(t2) - self.center).normalize(),
            })
        } else {
            None
        }
    }
}
