use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let e = (ray.origin - self.center) / self.radius;
        let d = ray.direction.normalize();
        let de = d.dot(e);
        let under_root = de * de - e.dot(e) + 1.0;
        if under_root < 0.0 {
            return None;
        }
        let reach = under_root.sqrt();
        let in_radii = [-de - reach, -de + reach]
            .into_iter()
            .find(|s| s * self.radius >= min_t)?;
        Some(Intersection {
            t: in_radii * self.radius,
            normal: e + in_radii * d,
        })
    }
}
