use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        leading(&self.triangles, ray, min_t)
    }
}

fn leading<T: IntersectRay>(triangles: &[T], ray: &Ray, min_t: f64) -> Option<Intersection> {
    let (first, rest) = triangles.split_first()?;
    let hit = first.intersect_ray(ray, min_t)?;
    let later = leading(rest, ray, min_t);
    later.filter(|other| other.t < hit.t).or(Some(hit))
}
