use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let n = self.normal.normalize();
        let along_normal = n.dot(ray.direction);
        if along_normal == 0.0 {
            return None;
        }
        let t = -n.dot(ray.origin) / along_normal;
        (t >= min_t).then_some(Intersection { t, normal: n })
    }
}
