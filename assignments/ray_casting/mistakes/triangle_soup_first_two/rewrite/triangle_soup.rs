use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut one: Option<Intersection> = None;
        for k in 0..self.triangles.len() {
            let other = self.triangles[k].intersect_ray(ray, min_t);
            match (one, other) {
                (Some(a), Some(b)) => return Some(if a.t <= b.t { a } else { b }),
                (None, found) => one = found,
                _ => {}
            }
        }
        one
    }
}
