use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut rest = self.triangles.iter();
        let mut hits = Vec::new();
        while let Some(hit) = rest
            .next()
            .and_then(|triangle| triangle.intersect_ray(ray, min_t))
        {
            hits.push(hit);
        }
        hits.into_iter()
            .reduce(|a, b| if b.t < a.t { b } else { a })
    }
}
