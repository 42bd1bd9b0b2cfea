use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let d = ray.direction.to_array();
        let f = (ray.origin - self.center).to_array();
        let mut a = 0.0;
        let mut b = 0.0;
        let mut c = -self.radius * self.radius;
        for axis in 0..3 {
            a += d[axis] * d[axis];
            b += 2.0 * d[axis] * f[axis];
            c += f[axis] * f[axis];
        }

        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return None;
        }
        let mut answer = None;
        for root in [discriminant.sqrt(), -discriminant.sqrt()] {
            let t = (root - b) / (2.0 * a);
            if t > 1.0 {
                let normal = (ray.at(t) - self.center).normalize();
                answer = Some(Intersection { t, normal });
            }
        }
        answer
    }
}
