use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let all_t: Vec<f64> = self
            .triangles
            .iter()
            .map(|triangle| {
                triangle
                    .intersect_ray(ray, min_t)
                    .map_or(f64::INFINITY, |hit| hit.t)
            })
            .collect();
        let (place, _) = all_t.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        self.triangles[place].intersect_ray(ray, min_t)
    }
}
