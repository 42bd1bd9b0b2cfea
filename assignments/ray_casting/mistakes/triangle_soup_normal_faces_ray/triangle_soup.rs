use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let nearest = self
            .triangles
            .iter()
            .filter_map(|triangle| triangle.intersect_ray(ray, min_t))
            .min_by(|a, b| a.t.total_cmp(&b.t))?;
        if nearest.normal.dot(ray.direction) > 0.0 {
            return Some(Intersection {
                t: nearest.t,
                normal: -nearest.normal,
            });
        }
        Some(nearest)
    }
}
