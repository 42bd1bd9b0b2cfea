//! Questions on small whole numbers and quarters, and whether each is a tie.
//!
//! In quarters all products stay far below 2⁵³, where 64-bit floats compute without
//! rounding: what is called a tie here is exactly one.

use glam::DVec3;
use pinhole::kind::{ObjectsQuestion, ShapeQuestion, SoupQuestion};
use pinhole::{Disk, Plane, Ray, Shape, Sphere, Triangle};

use super::random::{Random, as_soup};

/// Coordinates lie between −4 and 4, and for half the vectors between −1 and 1, where
/// products are 0 and 1 more often than not.
fn vector(random: &mut Random) -> DVec3 {
    let most = if random.count(1) == 0 { 1 } else { 4 };
    DVec3::from_array([0; 3].map(|_| random.whole(-most, most)))
}

fn not_zero(random: &mut Random) -> DVec3 {
    loop {
        let vector = vector(random);
        if vector != DVec3::ZERO {
            return vector;
        }
    }
}

/// A ray from a point in quarters, and its `min_t`.
struct WholeRay {
    e: DVec3,
    d: DVec3,
    min_t: f64,
}

impl WholeRay {
    fn new(random: &mut Random) -> WholeRay {
        WholeRay {
            e: vector(random) / 4.0,
            d: not_zero(random),
            min_t: random.whole(0, 3),
        }
    }

    fn ask(&self, shape: Shape) -> ShapeQuestion {
        let ray = Ray {
            origin: self.e,
            direction: self.d,
        };
        let min_t = self.min_t;
        ShapeQuestion { shape, ray, min_t }
    }
}

/// Ties: tangent, or a root exactly at `min_t`.
pub fn sphere(random: &mut Random) -> (ShapeQuestion, bool) {
    let (center, radius) = (vector(random), random.whole(1, 5));
    let ray = WholeRay::new(random);
    let from_center = ray.e - center;
    // As in the reference: a t² + 2 h t + c = 0.
    let (a, h) = (ray.d.length_squared(), ray.d.dot(from_center));
    let c = from_center.length_squared() - radius * radius;
    let at_min_t = a * ray.min_t * ray.min_t + 2.0 * h * ray.min_t + c;
    let is_tie = h * h - a * c == 0.0 || at_min_t == 0.0;
    let sphere = Sphere { center, radius };
    (ray.ask(Shape::Sphere(sphere)), is_tie)
}

/// Ties: t exactly `min_t`. A parallel ray is none: it misses, wherever it runs.
pub fn plane(random: &mut Random) -> (ShapeQuestion, bool) {
    let (point, normal) = (vector(random), not_zero(random));
    let ray = WholeRay::new(random);
    let along = ray.d.dot(normal);
    let is_tie = along != 0.0 && (point - ray.e).dot(normal) == ray.min_t * along;
    let plane = Plane { point, normal };
    (ray.ask(Shape::Plane(plane)), is_tie)
}

/// Ties: exactly on the line of an edge, or t exactly `min_t`. A parallel ray is none:
/// it misses, even in the triangle's own plane.
pub fn triangle(random: &mut Random) -> (ShapeQuestion, bool) {
    let (a, t1, t2) = loop {
        let [a, b, c] = [0; 3].map(|_| vector(random));
        if (b - a).cross(c - a) != DVec3::ZERO {
            break (a, b - a, c - a);
        }
    };
    let ray = WholeRay::new(random);
    // e − a = α t₁ + β t₂ − t d by Cramer's rule, every quotient times the determinant.
    let to_eye = ray.e - a;
    let determinant = t1.dot(ray.d.cross(t2));
    let alpha = to_eye.dot(ray.d.cross(t2));
    let beta = ray.d.dot(to_eye.cross(t1));
    let t = t2.dot(to_eye.cross(t1));
    let on_edge = alpha == 0.0 || beta == 0.0 || alpha + beta == determinant;
    let is_tie = determinant != 0.0 && (on_edge || t == ray.min_t * determinant);
    let corners = [a, a + t1, a + t2];
    (ray.ask(Shape::Triangle(Triangle { corners })), is_tie)
}

/// Ties: exactly on the edge, or t exactly `min_t`. A parallel ray is none: it misses,
/// even in the disk's own plane.
pub fn disk(random: &mut Random) -> (ShapeQuestion, bool) {
    let (center, normal, radius) = (vector(random), not_zero(random), random.whole(1, 5));
    let ray = WholeRay::new(random);
    // As for a plane, t = above / along; every length is times `along`.
    let along = ray.d.dot(normal);
    let above = (center - ray.e).dot(normal);
    let from_center = along * (ray.e - center) + above * ray.d;
    let on_edge = from_center.length_squared() == along * along * radius * radius;
    let is_tie = along != 0.0 && (on_edge || above == ray.min_t * along);
    let disk = Disk {
        center,
        normal,
        radius,
    };
    (ray.ask(Shape::Disk(disk)), is_tie)
}

/// Ties: two objects are first met at the same t.
pub fn objects(random: &mut Random) -> (ObjectsQuestion, bool) {
    let ray = WholeRay::new(random);
    let count = random.count(6);
    let ts = (0..count).map(|_| {
        let mut ts: Vec<f64> = (0..random.count(2)).map(|_| random.whole(-2, 8)).collect();
        ts.sort_by(f64::total_cmp);
        ts.dedup();
        ts
    });
    let ts: Vec<Vec<f64>> = ts.collect();
    let first = |ts: &Vec<f64>| ts.iter().copied().find(|t| *t >= ray.min_t);
    let firsts: Vec<f64> = ts.iter().filter_map(first).collect();
    let nearest = firsts.iter().copied().reduce(f64::min);
    let is_tie = firsts.iter().filter(|t| Some(**t) == nearest).count() > 1;
    let objects = ts.into_iter().map(|ts| random.canned(ts));
    let question = ObjectsQuestion {
        objects: objects.collect(),
        ray: Ray {
            origin: ray.e,
            direction: ray.d,
        },
        min_t: ray.min_t,
    };
    (question, is_tie)
}

/// The same objects as a soup.
pub fn soup(random: &mut Random) -> (SoupQuestion, bool) {
    let (question, is_tie) = objects(random);
    (as_soup(question), is_tie)
}

#[cfg(test)]
mod tests;
