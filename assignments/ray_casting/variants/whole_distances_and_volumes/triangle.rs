use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // Seen from the ray's origin, the line passes all three edges on the same side
        // if the tetrahedra of the edges and the direction have volumes of one sign.
        let [a, b, c] = self.corners.map(|corner| corner - ray.origin);
        let volume = |from: DVec3, to: DVec3| ray.direction.dot(to.cross(from));
        let volumes = [volume(b, c), volume(c, a), volume(a, b)];
        let one_side = volumes.iter().all(|volume| *volume >= 0.0);
        let other_side = volumes.iter().all(|volume| *volume <= 0.0);
        let total: f64 = volumes.iter().sum();
        if !(one_side || other_side) || total == 0.0 {
            return None;
        }
        let across = (b - a).cross(c - a);
        let t = a.dot(across) / ray.direction.dot(across);
        (t >= min_t).then(|| Intersection {
            t,
            normal: across.normalize(),
        })
    }
}
