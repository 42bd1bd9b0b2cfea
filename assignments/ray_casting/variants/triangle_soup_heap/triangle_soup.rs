use std::cmp::Ordering;
use std::collections::BinaryHeap;

use pinhole::{Intersection, Ray, TriangleSoup};

use crate::intersect_ray::IntersectRay;

impl<T: IntersectRay> IntersectRay for TriangleSoup<T> {
    fn intersect_ray(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        let mut heap = BinaryHeap::new();
        for triangle in &self.triangles {
            heap.extend(triangle.intersect_ray(ray, min_t).map(Nearest));
        }
        heap.pop().map(|nearest| nearest.0)
    }
}

/// A hit is greater if it is nearer, so that the heap's top is the nearest.
struct Nearest(Intersection);

impl Ord for Nearest {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.t.total_cmp(&self.0.t)
    }
}

impl PartialOrd for Nearest {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Nearest {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Nearest {}
