use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut closest = None;
        let mut closest_t = f64::MAX;
        let mut number = self.triangles.len().saturating_sub(1);
        while number >= 1 {
            match self.triangles[number].intersect_ray(ray, min_t) {
                Some(found) if found.t <= closest_t => {
                    closest_t = found.t;
                    closest = Some(found);
                }
                _ => {}
            }
            number -= 1;
        }
        closest
    }
}
