use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let (mut t, mut normal): (Option<f64>, _) = (None, None);
        for k in 0..self.triangles.len() {
            let Some(hit) = self.triangles[k].intersect_ray(ray, min_t) else {
                continue;
            };
            if t.is_none_or(|nearest| hit.t < nearest) {
                t = Some(hit.t);
            }
            normal = Some(hit.normal);
        }
        Some(Intersection {
            t: t?,
            normal: normal?,
        })
    }
}
