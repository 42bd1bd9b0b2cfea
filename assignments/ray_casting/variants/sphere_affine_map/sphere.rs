use glam::{DAffine3, DQuat, DVec3};
use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let from_unit = DAffine3::from_scale_rotation_translation(
            DVec3::splat(self.radius),
            DQuat::IDENTITY,
            self.center,
        );
        let to_unit = from_unit.inverse();
        let local = Ray {
            origin: to_unit.transform_point3(ray.origin),
            direction: to_unit.transform_vector3(ray.direction),
        };
        let a = local.direction.length_squared();
        let h = local.direction.dot(local.origin);
        let quarter = h * h - a * (local.origin.length_squared() - 1.0);
        if quarter < 0.0 {
            return None;
        }
        let t = [-quarter.sqrt(), quarter.sqrt()]
            .map(|root| (root - h) / a)
            .into_iter()
            .find(|t| *t >= min_t)?;
        Some(Intersection {
            t,
            normal: local.at(t).normalize(),
        })
    }
}
