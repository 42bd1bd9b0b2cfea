use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut hits: Vec<Intersection> = self
            .triangles
            .iter()
            .flat_map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        hits.sort_by(|a, b| b.t.total_cmp(&a.t));
        let Intersection { t, normal } = hits.pop()?;
        let towards_eye = normal.dot(-ray.direction).signum();
        Some(Intersection {
            t,
            normal: towards_eye * normal,
        })
    }
}
