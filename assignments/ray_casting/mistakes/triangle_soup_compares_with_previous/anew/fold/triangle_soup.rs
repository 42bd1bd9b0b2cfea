use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let start: (Option<Intersection>, Option<Intersection>) = (None, None);
        let hits = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t));
        let (nearest, _) = hits.fold(start, |(nearest, before), hit| match before {
            Some(other) if other.t <= hit.t => (nearest, Some(hit)),
            _ => (Some(hit), Some(hit)),
        });
        nearest
    }
}
