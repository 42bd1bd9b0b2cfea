//! Casts by a plan. Which object a ray hits first is decided exactly. t and the normal are computed
//! in `f64` if that is proven to be accurate enough, and with more digits otherwise.

use std::hint::black_box;

use pinhole::{Film, Hit, Projection, Resolution, Scene};
use rayon::prelude::*;

use super::{FINEST, PRICES, price_of_all};
use crate::cast::model::Exact;
use crate::cast::refined::refined;
use crate::cast::world::{PROVEN_T, Part, Primitive, View, World, vector};
use crate::cast::{Caster, Found, Tally};
use crate::kernel::Camera;
use crate::oracle::scene::{TrueHit, sight};
use crate::shape::Ray;
use crate::vector::Vector;

/// A scene ready to be cast by a plan, and the rays of its camera. It casts no others, because its
/// filters are only right for these.
pub struct PlannedCaster {
    /// The accuracy that is requested for t and normals.
    pub accuracy: f64,
    /// The camera of the scene.
    pub camera: Camera,
    /// Whether boxes are cheaper than testing every part.
    pub has_boxes: bool,
    rays: Vec<Ray<f64>>,
    min_t: f64,
    caster: Caster,
    /// The normals of planes and triangles, by [`Part::place`].
    normals: Vec<Vector<f64>>,
}

/// Whether t is far from subnormal numbers and from overflow.
#[inline(always)]
fn has_digits(t: f64) -> bool {
    (1e-300..1e300).contains(&t)
}

impl PlannedCaster {
    /// Plans a scene for an accuracy of [`FINEST`] or coarser, and prepares its parts for the rays
    /// of its camera. An error if the camera's numbers are so large that a ray overflows.
    pub fn new(scene: &Scene, accuracy: f64) -> Result<PlannedCaster, String> {
        debug_assert!(accuracy >= FINEST, "{accuracy:e}");
        let (world, rays) = (World::of(&scene.objects), rays(scene));
        if let Some(index) = rays.iter().position(|ray| !ray.is_finite()) {
            let pixel = scene.resolution.pixel(index);
            return Err(format!("the ray of pixel {pixel} overflows"));
        }
        let normals = world.parts.iter().map(|part| part.shape.flat_normal());
        let normals = normals.collect();
        let camera = camera(scene, &rays);
        let view = View { camera, accuracy };
        let has_boxes = price_of_all(&world.parts) > PRICES.boxes;
        Ok(PlannedCaster {
            accuracy,
            camera,
            has_boxes,
            min_t: scene.min_t,
            normals,
            caster: Caster::new(world, Some(view), has_boxes),
            rays,
        })
    }

    /// The same caster with only every `step`-th ray.
    pub fn every(mut self, step: usize) -> PlannedCaster {
        self.rays = self.rays.into_iter().step_by(step).collect();
        self
    }

    /// The rays that it casts, in image order.
    pub fn rays(&self) -> &[Ray<f64>] {
        &self.rays
    }

    /// What each ray truly hits.
    pub fn truths(&self) -> Vec<TrueHit<'_>> {
        let truth = |ray| sight(self.parts(), ray, self.min_t);
        self.rays.par_iter().map(truth).collect()
    }

    /// The parts of the scene, in the order of the search.
    pub fn parts(&self) -> &[Part] {
        &self.caster.world.parts
    }

    /// Casts one ray.
    #[inline]
    pub fn see(&self, ray: &Ray<f64>, tally: &mut Tally) -> Option<Hit> {
        let (caster, min_t) = (&self.caster, self.min_t);
        let found = match self.camera {
            Camera::Perspective { .. } => caster.first::<Exact<true>>(ray, min_t, tally),
            Camera::Orthographic { .. } => caster.first::<Exact<false>>(ray, min_t, tally),
        };
        let Found { part, t, .. } = found?;
        let (t, normal) = match found?.is_accurate && has_digits(t) {
            true => (t, self.normal(part, ray, t)),
            false => {
                let accuracy = self.accuracy.min(PROVEN_T);
                let (t, normal, is_exact) = refined(&part.shape, ray, min_t, t, accuracy);
                tally.exact_hits += u64::from(is_exact);
                (t, normal)
            }
        };
        Some(part.hit(t, normal))
    }

    /// The normal at a hit, computed with rounding.
    #[inline(always)]
    fn normal(&self, part: &Part, ray: &Ray<f64>, t: f64) -> Vector<f64> {
        match &part.shape {
            Primitive::Sphere(sphere) => {
                // The hit is at this distance from the centre, so there is no need for a square
                // root.
                (ray.origin - sphere.center + ray.direction * t) * (1.0 / sphere.radius)
            }
            _ => self.normals[part.place as usize],
        }
    }

    /// Casts all rays, on all cores.
    pub fn hits(&self) -> (Vec<Option<Hit>>, Tally) {
        let cast = |rays: &[Ray<f64>]| {
            let mut tally = Tally::default();
            let see = |ray| self.see(ray, &mut tally);
            (rays.iter().map(see).collect::<Vec<_>>(), tally)
        };
        let pieces: Vec<_> = self.rays.par_chunks(512).map(cast).collect();
        let tally = pieces
            .iter()
            .fold(Tally::default(), |sum, (_, tally)| sum.plus(*tally));
        let hits = pieces.into_iter().flat_map(|(hits, _)| hits).collect();
        (hits, tally)
    }

    /// Casts all rays on this thread, for timing.
    pub fn cast(&self) {
        for ray in black_box(&self.rays) {
            black_box(self.see(ray, &mut Tally::default()));
        }
    }
}

/// The camera, as filters see it.
pub fn camera(scene: &Scene, rays: &[Ray<f64>]) -> Camera {
    let eye = vector(scene.camera.eye);
    match scene.camera.projection {
        Projection::Perspective { .. } => Camera::Perspective { eye },
        Projection::Orthographic => Camera::orthographic(rays, eye),
    }
}

/// Rays through the centres of all pixels, in image order (Marschner & Shirley, 4th ed., §4.3).
/// They are rounded to `f64`; exact decisions are exact for the rounded rays.
pub fn rays(scene: &Scene) -> Vec<Ray<f64>> {
    let (camera, resolution) = (&scene.camera, scene.resolution);
    let through = |index| {
        let pixel = resolution.pixel(index);
        let across = (pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5;
        let upward = (pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5;
        let on_plane = camera.width * across * camera.u + camera.height * upward * camera.v;
        let (origin, direction) = match camera.projection {
            Projection::Perspective { focal_length } => {
                (camera.eye, on_plane - focal_length * camera.w)
            }
            Projection::Orthographic => (camera.eye + on_plane, -camera.w),
        };
        Ray {
            origin: vector(origin),
            direction: vector(direction),
        }
    };
    (0..resolution.pixels()).map(through).collect()
}

/// The film of these hits. Its samples must be finite: a t beyond the largest `f32` becomes that
/// number.
pub fn film(resolution: Resolution, mut hits: Vec<Option<Hit>>) -> Film {
    let largest = f64::from(f32::MAX);
    for hit in hits.iter_mut().flatten() {
        hit.intersection.t = hit.intersection.t.clamp(-largest, largest);
    }
    Film::of_hits(resolution, &hits)
}
