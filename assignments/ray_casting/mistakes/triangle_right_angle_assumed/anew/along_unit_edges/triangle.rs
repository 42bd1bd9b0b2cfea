use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (length1, length2) = (a.distance(b), a.distance(c));
        let along1 = (b - a) / length1;
        let along2 = (c - a) / length2;
        let n = along1.cross(along2);
        let steepness = n.dot(ray.direction);
        if steepness == 0.0 {
            return None;
        }
        let t = n.dot(b - ray.origin) / steepness;
        if t < min_t {
            return None;
        }
        let p = ray.origin + t * ray.direction - a;
        let (x, y) = (p.dot(along1), p.dot(along2));
        if x >= 0.0 && y >= 0.0 && x / length1 + y / length2 <= 1.0 {
            return Some(Intersection {
                t,
                normal: n.normalize(),
            });
        }
        None
    }
}
