use glam::DMat3;
use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // Work in a frame in which the plane is z = 0, with z in multiples of the stored
        // normal.
        let (right, forward) = self.normal.normalize().any_orthonormal_pair();
        let to_plane = DMat3::from_cols(right, forward, self.normal).transpose();
        let origin = to_plane * (ray.origin - self.point);
        let direction = to_plane * ray.direction;
        if direction.z == 0.0 {
            return None;
        }
        let t = -origin.z / direction.z;
        (t >= min_t).then(|| Intersection {
            t,
            normal: right.cross(forward),
        })
    }
}
