use pinhole::{Intersection, Ray, Triangle};

use crate::intersect_ray::IntersectRay;

impl IntersectRay for Triangle {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let [a, b, c] = self.corners;
        let n = (c - b).cross(a - b);
        let normal = n / n.length();
        let height_at = |t: f64| (ray.at(t) - b).dot(normal);
        let (at_eye, at_image_plane) = (height_at(0.0), height_at(1.0));
        if at_eye == at_image_plane {
            return None;
        }
        let t = at_eye / (at_eye - at_image_plane);
        (t >= min_t).then_some(Intersection { t, normal })
    }
}
