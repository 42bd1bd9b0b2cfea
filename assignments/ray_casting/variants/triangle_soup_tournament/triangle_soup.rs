use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut round: Vec<Option<Intersection>> = self
            .triangles
            .iter()
            .map(|triangle| triangle.intersect_ray(ray, min_t))
            .collect();
        while round.len() > 1 {
            round = round
                .chunks(2)
                .map(|pair| {
                    pair.iter()
                        .flatten()
                        .copied()
                        .reduce(|a, b| if a.t <= b.t { a } else { b })
                })
                .collect();
        }
        round.pop().flatten()
    }
}
