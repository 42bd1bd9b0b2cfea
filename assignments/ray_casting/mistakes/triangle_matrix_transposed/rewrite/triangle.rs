use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let ab = b - a;
        let ac = c - a;
        let right = ray.origin - a;
        let mut rows = [(ab, right.x), (ac, right.y), (-ray.direction, right.z)]
            .map(|(row, rhs)| [row.x, row.y, row.z, rhs]);
        for k in 0..3 {
            let pivot = (k..3).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
            rows.swap(k, pivot);
            if rows[k][k] == 0.0 {
                return None;
            }
            for i in (0..3).filter(|i| *i != k) {
                let factor = rows[i][k] / rows[k][k];
                for j in k..4 {
                    rows[i][j] -= factor * rows[k][j];
                }
            }
        }
        let [x, y, t] = [0, 1, 2].map(|k| rows[k][3] / rows[k][k]);
        if x < 0.0 || y < 0.0 || x + y > 1.0 || t < min_t {
            return None;
        }
        Some(Intersection {
            t,
            normal: ab.cross(ac).normalize(),
        })
    }
}
