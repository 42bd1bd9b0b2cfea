//! Random questions: any two programs that differ on more than a hair's breadth of the
//! questions are told apart by them.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use pinhole::kind::{CameraQuestion, ObjectsQuestion, ShapeQuestion, SoupQuestion};
use pinhole::{
    Camera, Canned, Disk, Intersection, Pixel, Plane, Projection, Ray, Resolution, Shape, Sphere,
    Triangle, TriangleSoup,
};
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// A stream of random numbers, the same for every program, so that answers can be
/// compared.
pub struct Random(SplitMix64);

impl Random {
    /// The stream from its beginning.
    pub fn new() -> Random {
        Random(SplitMix64::seed_from_u64(0))
    }

    fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// From 0 to 1, the end excluded.
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Positive, each power of ten as likely as the next.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// A whole number from `low` to `high`, both included.
    pub fn whole(&mut self, low: i32, high: i32) -> f64 {
        f64::from(low) + (self.bits() % (high - low + 1) as u64) as f64
    }

    /// From 0 to `most`, both included.
    pub fn count(&mut self, most: usize) -> usize {
        (self.bits() % (most as u64 + 1)) as usize
    }

    fn direction(&mut self) -> DVec3 {
        let (z, turn) = (self.between(-1.0, 1.0), self.between(0.0, TAU));
        let across = (1.0 - z * z).sqrt();
        DVec3::new(across * turn.cos(), across * turn.sin(), z)
    }

    fn point(&mut self) -> DVec3 {
        self.size(0.1, 10.0) * self.direction()
    }

    /// A ray from `origin` through `target`, which it meets at a t that is not 1, and a
    /// `min_t` at the eye, before that t or beyond it.
    fn through(&mut self, origin: DVec3, target: DVec3) -> (Ray, f64) {
        let t = self.size(0.05, 20.0);
        let side = if self.count(5) == 0 { -1.0 } else { 1.0 };
        let direction = side * (target - origin) / t;
        (
            Ray { origin, direction },
            t * self.between(-0.5, 1.5).max(0.0),
        )
    }

    /// Seen from outside and from inside, hit, grazed and missed.
    pub fn sphere(&mut self) -> ShapeQuestion {
        let (center, radius) = (self.point(), self.size(1e-3, 1e2));
        let away = radius * self.between(0.0, 3.0);
        let origin = center + away * self.direction();
        let target = center + radius * self.between(0.0, 1.3) * self.direction();
        let (ray, min_t) = self.through(origin, target);
        let shape = Shape::Sphere(Sphere { center, radius });
        ShapeQuestion { shape, ray, min_t }
    }

    /// Seen from both sides, its normal of any length.
    pub fn plane(&mut self) -> ShapeQuestion {
        let (point, origin, target) = (self.point(), self.point(), self.point());
        let normal = self.size(1e-3, 1e3) * self.direction();
        let (ray, min_t) = self.through(origin, target);
        let shape = Shape::Plane(Plane { point, normal });
        ShapeQuestion { shape, ray, min_t }
    }

    /// Of any size, hit, and missed on every side.
    pub fn triangle(&mut self) -> ShapeQuestion {
        let (a, size) = (self.point(), self.size(1e-6, 1e2));
        let corners = [a, a + size * self.point(), a + size * self.point()];
        let (alpha, beta) = (self.between(-0.3, 1.3), self.between(-0.3, 1.3));
        let target = a + alpha * (corners[1] - a) + beta * (corners[2] - a);
        let origin = target + size * self.point();
        let (ray, min_t) = self.through(origin, target);
        let shape = Shape::Triangle(Triangle { corners });
        ShapeQuestion { shape, ray, min_t }
    }

    /// Seen from both sides, hit, and missed beside its edge; its normal of any length.
    pub fn disk(&mut self) -> ShapeQuestion {
        let (center, radius) = (self.point(), self.size(1e-3, 1e2));
        let normal = self.size(1e-3, 1e3) * self.direction();
        let across = normal.any_orthogonal_vector().normalize();
        let turn = DQuat::from_axis_angle(normal.normalize(), self.between(0.0, TAU));
        let target = center + radius * self.between(0.0, 1.3) * (turn * across);
        let origin = target + radius * self.point();
        let (ray, min_t) = self.through(origin, target);
        let shape = Shape::Disk(Disk {
            center,
            normal,
            radius,
        });
        ShapeQuestion { shape, ray, min_t }
    }

    /// None to six objects, each met nowhere, once or twice.
    pub fn objects(&mut self) -> ObjectsQuestion {
        let count = self.count(6);
        let objects = (0..count).map(|_| {
            let mut ts: Vec<f64> = (0..self.count(2))
                .map(|_| self.between(-2.0, 8.0))
                .collect();
            ts.sort_by(f64::total_cmp);
            self.canned(ts)
        });
        let objects = objects.collect();
        let (ray, _) = self.through(DVec3::ZERO, DVec3::ONE);
        let min_t = self.between(-1.0, 4.0).max(0.0);
        ObjectsQuestion {
            objects,
            ray,
            min_t,
        }
    }

    /// The same objects as a soup.
    pub fn soup(&mut self) -> SoupQuestion {
        as_soup(self.objects())
    }

    /// An object that is met at these, with normals that tell it from any other.
    pub fn canned(&mut self, ts: Vec<f64>) -> Canned {
        let met = ts.into_iter().map(|t| Intersection {
            t,
            normal: self.direction(),
        });
        Canned {
            intersections: met.collect(),
        }
    }

    /// Any frame, plane and grid of pixels.
    pub fn camera(&mut self) -> CameraQuestion {
        let size = (self.size(0.01, 100.0), self.size(0.01, 100.0));
        let projection = match self.count(2) {
            0 => Projection::Orthographic,
            _ => Projection::Perspective {
                focal_length: self.size(0.01, 100.0),
            },
        };
        let (eye, view, up) = (self.point(), self.direction(), self.direction());
        let camera = Camera::new(eye, view, up, size, projection);
        let count = |random: &mut Random| 1 + random.count(2000);
        let resolution = Resolution {
            n_x: count(self),
            n_y: count(self),
        };
        let pixel = Pixel {
            i: self.count(resolution.n_x - 1),
            j: self.count(resolution.n_y - 1),
        };
        CameraQuestion {
            camera: camera.expect("two random directions are not parallel"),
            pixel,
            resolution,
        }
    }
}

/// The same question about a soup of these objects.
pub fn as_soup(question: ObjectsQuestion) -> SoupQuestion {
    SoupQuestion {
        soup: TriangleSoup {
            triangles: question.objects,
        },
        ray: question.ray,
        min_t: question.min_t,
    }
}
