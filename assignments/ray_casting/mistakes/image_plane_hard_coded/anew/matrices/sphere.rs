use glam::{DAffine3, DVec3};
use pinhole::{Intersection, Ray, Sphere};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Sphere {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let world = DAffine3::from_translation(self.center)
            * DAffine3::from_scale(DVec3::splat(self.radius));
        let local = world.inverse();
        let e = local.transform_point3(ray.origin);
        let d = local.transform_vector3(ray.direction);
        let (dd, de) = (d.length_squared(), d.dot(e));
        let under_root = de * de - dd * (e.length_squared() - 1.0);
        if under_root < 0.0 {
            return None;
        }
        let t = [-under_root.sqrt(), under_root.sqrt()]
            .map(|side| (side - de) / dd)
            .into_iter()
            .find(|t| *t > 1.0)?;
        Some(Intersection {
            t,
            normal: e + t * d,
        })
    }
}
