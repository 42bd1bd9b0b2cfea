use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let m = ray.origin - self.center;
        let squared = ray.direction.length_squared();
        // Divided by a: t² + p t + q = 0.
        let p = m.dot(ray.direction) / squared;
        let q = (m.length_squared() - self.radius.powi(2)) / squared;
        let half = -0.5 * p;
        let under = half * half - q;
        let root = (under >= 0.0).then(|| under.sqrt())?;
        let t = [half - root, half + root]
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
