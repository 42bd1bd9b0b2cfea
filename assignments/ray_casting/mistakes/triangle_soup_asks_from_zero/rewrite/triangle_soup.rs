use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        self.triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, 0.0))
            .min_by(|a, b| a.t.total_cmp(&b.t))
    }
}
