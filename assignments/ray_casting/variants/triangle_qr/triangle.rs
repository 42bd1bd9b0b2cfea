use glam::DMat3;
use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let columns = [b - a, c - a, -ray.direction];
        let rhs = ray.origin - a;
        let mut q = columns;
        let mut r = DMat3::ZERO;
        for k in 0..3 {
            r.col_mut(k)[k] = q[k].length();
            q[k] /= q[k].length();
            for j in k + 1..3 {
                let along = q[k].dot(q[j]);
                r.col_mut(j)[k] = along;
                q[j] -= along * q[k];
            }
        }
        let y = q.map(|axis| axis.dot(rhs));
        let t = y[2] / r.col(2)[2];
        let beta = (y[1] - r.col(2)[1] * t) / r.col(1)[1];
        let alpha = (y[0] - r.col(1)[0] * beta - r.col(2)[0] * t) / r.col(0)[0];
        // A parallel ray leaves NaN, which fails every comparison.
        (alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t >= min_t).then(|| Intersection {
            t,
            normal: columns[0].cross(columns[1]).normalize(),
        })
    }
}
