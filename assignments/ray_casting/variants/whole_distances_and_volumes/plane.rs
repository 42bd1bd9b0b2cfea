use pinhole::{Intersection, Plane, Ray};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Plane {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        // Distances from the plane along the normal, in multiples of the normal's length.
        let at_0 = (ray.origin - self.point).dot(self.normal);
        let change = ray.direction.dot(self.normal);
        if change.abs() == 0.0 {
            return None;
        }
        let t = at_0 / -change;
        if t < min_t {
            None
        } else {
            Some(Intersection {
                t,
                normal: self.normal * self.normal.length_recip(),
            })
        }
    }
}
