use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

const LANES: usize = 8;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut lanes: [Option<Intersection>; LANES] = [None; LANES];
        for block in self.triangles.chunks(LANES) {
            for (lane, triangle) in lanes.iter_mut().zip(block) {
                let hit = triangle.intersect_ray(ray, min_t);
                if distance(&hit) < distance(lane) {
                    *lane = hit;
                }
            }
        }
        lanes
            .into_iter()
            .flatten()
            .min_by(|a, b| a.t.total_cmp(&b.t))
    }
}

fn distance(hit: &Option<Intersection>) -> f64 {
    hit.map_or(f64::INFINITY, |hit| hit.t)
}
