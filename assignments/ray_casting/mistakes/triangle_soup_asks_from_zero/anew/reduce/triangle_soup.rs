use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let ask = |triangle: &T| triangle.intersect_ray(ray, 0.0);
        let nearer = |a: Intersection, b: Intersection| if b.t < a.t { b } else { a };
        self.triangles.iter().flat_map(ask).reduce(nearer)
    }
}
