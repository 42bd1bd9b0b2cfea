use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let last = self.triangles.len() - 1;
        let mut nearest_t = f64::INFINITY;
        let mut nearest = None;
        let mut k = 0;
        while k < last {
            let hit = self.triangles[k].intersect_ray(ray, min_t);
            if let Some(Intersection { t, .. }) = hit
                && t < nearest_t
            {
                nearest_t = t;
                nearest = hit;
            }
            k += 1;
        }
        nearest
    }
}
