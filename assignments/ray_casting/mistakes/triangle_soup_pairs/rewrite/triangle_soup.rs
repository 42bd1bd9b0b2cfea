use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut rest = self.triangles.as_slice();
        let mut hits = Vec::new();
        while let [one, other, others @ ..] = rest {
            hits.extend(one.intersect_ray(ray, min_t));
            hits.extend(other.intersect_ray(ray, min_t));
            rest = others;
        }
        hits.into_iter()
            .reduce(|a: Intersection, b| if b.t < a.t { b } else { a })
    }
}
