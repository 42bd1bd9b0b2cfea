use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [v0, v1, v2] = self.corners;
        let (edge1, edge2) = (v1 - v0, v2 - v0);
        let p = ray.direction.cross(edge2);
        let det = edge1.dot(p);
        if det == 0.0 {
            return None;
        }
        let scale = det.recip();
        let to_start = ray.origin - v0;
        let u = scale * to_start.dot(p);
        let q = to_start.cross(edge1);
        let v = scale * ray.direction.dot(q);
        if u < 0.0 || v < 0.0 || u + v > 1.0 {
            return None;
        }
        let t = scale * edge2.dot(q);
        if t < min_t {
            None
        } else {
            Some(Intersection {
                t,
                normal: edge1.cross(edge2) / (edge1.length() * edge2.length()),
            })
        }
    }
}
