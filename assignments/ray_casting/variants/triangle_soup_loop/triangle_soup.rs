use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut nearest: Option<Intersection> = None;
        for triangle in &self.triangles {
            let Some(hit) = triangle.intersect_ray(ray, min_t) else {
                continue;
            };
            match nearest {
                Some(best) if best.t <= hit.t => {}
                _ => nearest = Some(hit),
            }
        }
        nearest
    }
}
