use pinhole::{Intersection, Plane, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let plane = Plane {
            point: a,
            normal: (b - a).cross(c - a),
        };
        plane.intersect_ray(ray, min_t)
    }
}
