use glam::DVec3;
use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let f = ray.origin - self.center;
        let a = dot(ray.direction, ray.direction);
        let h = dot(ray.direction, f);
        let c = self.radius.mul_add(-self.radius, dot(f, f));
        let discriminant = difference_of_products(h, h, a, c);
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let t = if -h - root >= min_t * a {
            (-h - root) / a
        } else {
            (-h + root) / a
        };
        if t < min_t {
            return None;
        }
        let outward = DVec3::new(
            ray.direction.x.mul_add(t, f.x),
            ray.direction.y.mul_add(t, f.y),
            ray.direction.z.mul_add(t, f.z),
        );
        Some(Intersection {
            t,
            normal: outward / self.radius,
        })
    }
}

fn dot(v: DVec3, w: DVec3) -> f64 {
    v.x.mul_add(w.x, v.y.mul_add(w.y, v.z * w.z))
}

/// a b − c d, right to 1.5 ulp (Jeannerod, Louvet & Muller 2013).
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let error = (-c).mul_add(d, cd);
    a.mul_add(b, -cd) + error
}
