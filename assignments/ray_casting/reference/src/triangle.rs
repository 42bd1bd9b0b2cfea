use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

// ANCHOR: stub
impl IntersectRay for Triangle {
    /// Where a ray meets a triangle, at `min_t` or beyond.
    ///
    /// With corners a, b, c, edges t₁ = b − a and t₂ = c − a, and the ray e + t d,
    /// solve e − a = α t₁ + β t₂ − t d for α, β, t. The point is on the triangle if
    /// α ≥ 0, β ≥ 0 and α + β ≤ 1. Triangles may be as small as 1e-6 scene units,
    /// and are seen from both sides.
    ///
    /// The normal is t₁ × t₂ made unit: never flipped towards the ray. `None` if
    /// the ray misses the triangle, is parallel to it, or meets it before `min_t`.
    ///
    /// Book: Triangle.
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // ANCHOR: answer
        // Cramer's rule on the 3 × 3 system, each determinant as a triple product
        // (Marschner & Shirley, §4.4.2; Möller & Trumbore 1997).
        let [a, b, c] = self.corners;
        let (t1, t2) = (b - a, c - a);
        let to_eye = ray.origin - a;
        let d_cross_t2 = ray.direction.cross(t2);
        let determinant = t1.dot(d_cross_t2);
        if determinant == 0.0 {
            return None;
        }
        let eye_cross_t1 = to_eye.cross(t1);
        let alpha = to_eye.dot(d_cross_t2) / determinant;
        let beta = ray.direction.dot(eye_cross_t1) / determinant;
        let t = t2.dot(eye_cross_t1) / determinant;
        let inside = alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0;
        (inside && t >= min_t).then(|| Intersection {
            t,
            normal: t1.cross(t2).normalize(),
        })
        // ANCHOR_END: answer
    }
}
// ANCHOR_END: stub
