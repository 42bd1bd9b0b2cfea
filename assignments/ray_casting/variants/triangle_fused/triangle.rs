use glam::DVec3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let h = cross(ray.direction, t2);
        let mut det = dot(t1, h);
        let s = ray.origin - a;
        let q = cross(s, t1);
        let mut numerators = [dot(s, h), dot(ray.direction, q), dot(t2, q)];
        if det < 0.0 {
            det = -det;
            numerators = numerators.map(|numerator| -numerator);
        }
        let [alpha, beta, t] = numerators;
        if det == 0.0 || alpha < 0.0 || beta < 0.0 || alpha + beta > det {
            return None;
        }
        let t = t / det;
        (t >= min_t).then(|| Intersection {
            t,
            normal: cross(t1, t2).normalize(),
        })
    }
}

fn dot(a: DVec3, b: DVec3) -> f64 {
    a.x.mul_add(b.x, a.y.mul_add(b.y, a.z * b.z))
}

fn cross(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(
        a.y.mul_add(b.z, -(a.z * b.y)),
        a.z.mul_add(b.x, -(a.x * b.z)),
        a.x.mul_add(b.y, -(a.y * b.x)),
    )
}
