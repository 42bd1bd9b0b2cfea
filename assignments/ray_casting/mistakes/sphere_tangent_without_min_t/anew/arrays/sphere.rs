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
        let touches = discriminant.abs() < 1e-5;
        let t = if touches {
            Some(-0.5 * b / a)
        } else if discriminant > 0.0 {
            let root = discriminant.sqrt();
            [-b - root, -b + root]
                .into_iter()
                .map(|top| 0.5 * top / a)
                .find(|t| *t >= min_t)
        } else {
            None
        };
        t.map(|t| Intersection {
            t,
            normal: (ray.at(t) - self.center).normalize(),
        })
    }
}
