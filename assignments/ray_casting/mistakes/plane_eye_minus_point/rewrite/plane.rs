use glam::DMat3;
use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let z = self.normal.normalize();
        let (x, y) = z.any_orthonormal_pair();
        let to_plane = DMat3::from_cols(x, y, z).transpose();
        let e = to_plane * (ray.origin - self.point);
        let d = to_plane * ray.direction;

        if d.z == 0.0 {
            return None;
        }
        let t = e.z / d.z;
        (t >= min_t).then_some(Intersection { t, normal: z })
    }
}
