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

        let in_front = [-df - root, -df + root]
            .into_iter()
            .map(|top| top / dd)
            .find(|t| *t > 0.0);
        in_front.filter(|t| *t >= min_t).map(|t| Intersection {
            t,
            normal: (f + t * ray.direction).normalize(),
        })
    }
}
