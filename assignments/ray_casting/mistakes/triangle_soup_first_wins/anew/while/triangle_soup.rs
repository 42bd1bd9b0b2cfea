use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut k = 0;
        let mut found = None;
        while found.is_none() && k < self.triangles.len() {
            found = self.triangles[k].intersect_ray(ray, min_t);
            k += 1;
        }
        found
    }
}
