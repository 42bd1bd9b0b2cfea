use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits = self
            .triangles
            .iter()
            .flat_map(|triangle| triangle.intersect_ray(ray, min_t));
        let enter = hits.next()?;
        match hits.next() {
            Some(leave) if leave.t < enter.t => Some(leave),
            _ => Some(enter),
        }
    }
}
