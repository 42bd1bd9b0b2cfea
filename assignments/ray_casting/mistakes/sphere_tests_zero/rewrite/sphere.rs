use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let f = ray.origin - self.center;
        let (dd, df, ff) = (
            ray.direction.dot(ray.direction),
            ray.direction.dot(f),
            f.dot(f),
        );
        let root = Some(df * df - dd * (ff - self.radius.powi(2)))
            .filter(|discriminant| *discriminant >= 0.0)?
            .sqrt();

        [root, -root]
            .into_iter()
            .map(|signed| (signed - df) / dd)
            .filter(|t| *t > 0.0)
            .min_by(f64::total_cmp)
            .map(|t| Intersection {
                t,
                normal: (ray.at(t) - self.center).normalize(),
            })
    }
}
