use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let det = t1.dot(ray.direction.cross(t2));
        if det == 0.0 {
            return None;
        }
        let to_eye = ray.origin - a;
        let t = t2.dot(to_eye.cross(t1)) / det;
        let way = to_eye + t * ray.direction;
        let share = |edge: DVec3| {
            let foot = way.project_onto(edge);
            foot.length() / edge.length() * foot.dot(edge).signum()
        };
        let shares = [share(t1), share(t2)];
        let inside = shares.iter().all(|share| *share >= 0.0) && shares.iter().sum::<f64>() <= 1.0;
        (inside && t >= min_t).then(|| Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
    }
}
