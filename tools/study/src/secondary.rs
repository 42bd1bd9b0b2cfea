//! Secondary rays in `f32`, such as shadow rays and reflections, which begin at the hit of
//! another ray. The computed hit does not lie exactly on the surface, so a secondary ray may
//! hit the surface that it leaves (a self-hit). An origin moved too far may pass through a
//! nearby surface (a lost hit).

use rayon::prelude::*;

use crate::family::HasFamilies;
use crate::kernel::{Kernel, sphere};
use crate::number::Real;
use crate::random::Random;
use crate::result::Secondary;
use crate::shape::{Ray, Shape, Sphere};
use crate::vector::Vector;

/// Distance of the nearby surface, in radii.
const NEAR: f64 = 1e-3;

/// Intersects with a careful kernel in `f32`.
fn meet(sphere: &Sphere<f32>, ray: &Ray<f32>, min_t: f32) -> Option<f32> {
    sphere::Haines::intersect(sphere, &sphere::Haines::prepare(ray), min_t)
}

/// Given a computed hit: the point as nearly on the surface as `f32` allows, a bound on its error
/// in each component, and a unit normal. pbrt-v4, §6.8.5: γ₅ for the refined point relative to the
/// centre, plus the rounding of the sum.
fn refined(sphere: &Sphere<f32>, point: Vector<f32>) -> [Vector<f32>; 3] {
    let normal = (point - sphere.center).unit();
    let out = normal * sphere.radius;
    let error = out.map(|x| gamma(5.0) * x.abs());
    let sum = sphere.center.map(f32::abs) + out.map(f32::abs);
    [sphere.center + out, error + sum * gamma(1.0), normal]
}

/// γₙ = n u / (1 − n u) (Higham, §3.1).
fn gamma(n: f32) -> f32 {
    let bound = n * f32::EPSILON / 2.0;
    bound / (1.0 - bound)
}

/// A method to offset a secondary ray: its origin and `min_t`.
type Method = fn(met: Vector<f32>, on: [Vector<f32>; 3]) -> (Vector<f32>, f32);

/// The methods, in the order of the tables.
const METHODS: [(&str, Method); 4] = [
    ("as computed", |met, _| (met, 0.0)),
    ("min_t = 10⁻⁴", |met, _| (met, 1e-4)),
    ("pbrt-v4", |_, on| (pbrt(on), 0.0)),
    ("Wächter–Binder", |met, on| (integers(met, on[2]), 0.0)),
];

/// Moves the point along the normal to the far side of its error box, and rounds each component
/// away from the surface (pbrt-v4, §6.8.6, `OffsetRayOrigin`).
fn pbrt([point, error, normal]: [Vector<f32>; 3]) -> Vector<f32> {
    let offset = normal * normal.map(f32::abs).dot(error);
    let away = |x: f32, by: f32| match by {
        by if by > 0.0 => (x + by).next_up(),
        by if by < 0.0 => (x + by).next_down(),
        _ => x,
    };
    point.zip(offset, away)
}

/// Moves each component by a number of ulps (Wächter & Binder, *Ray Tracing Gems*, ch. 6).
fn integers(point: Vector<f32>, normal: Vector<f32>) -> Vector<f32> {
    let away = |x: f32, n: f32| {
        let steps = (256.0 * n) as i32;
        let steps = if x < 0.0 { -steps } else { steps };
        match x.abs() < 1.0 / 32.0 {
            true => x + n / 65536.0,
            false => f32::from_bits(x.to_bits().wrapping_add_signed(steps)),
        }
    };
    point.zip(normal, away)
}

/// Casts `count` rays of each kind from spheres, with every method.
pub fn studied(count: usize, seed: u64) -> Vec<Secondary> {
    let places = [0.0, 10.0, 1000.0].into_iter();
    let all = places.flat_map(|offset| METHODS.map(|method| (offset, method)));
    let all: Vec<_> = all.collect();
    let of_method = |(offset, method)| of_method(method, offset, count, seed);
    all.into_par_iter().map(of_method).collect()
}

fn of_method(
    (name, method): (&'static str, Method),
    offset: f64,
    count: usize,
    seed: u64,
) -> Secondary {
    let mut random = Random::new(seed, &format!("secondary sphere {offset}"));
    let mut tally = Secondary {
        shape: "sphere",
        method: name,
        offset,
        leaving: 0,
        self_hits: 0,
        lost: 0,
    };
    while tally.leaving < count as u64 {
        let (question, place) = (Sphere::plain(&mut random), random.unit() * offset);
        let sphere = question.shape.moved(place);
        let narrow = sphere.map(f32::of, f32::of);
        let mut ray = question.ray;
        ray.origin = ray.origin + place;
        let ray = ray.map(f32::of, f32::of);
        let Some(t) = meet(&narrow, &ray, 0.0) else {
            continue;
        };
        let met = ray.origin + ray.direction * t;
        let mut on = refined(&narrow, met);
        // Turn the normal towards the first ray's origin.
        if on[2].dot(ray.direction) > 0.0 {
            on[2] = on[2] * -1.0;
        }
        let (origin, min_t) = method(met, on);
        let normal = on[2].map(f32::wide);
        let across = random.unit_across(normal);
        let rise = random.within(0.05, 1.0);
        let direction = (across + normal * rise).map(f32::of);
        tally.leaving += 1;
        let leaving = Ray { origin, direction };
        tally.self_hits += u64::from(meet(&narrow, &leaving, min_t).is_some());
        let near = Sphere {
            radius: sphere.radius * (1.0 + NEAR),
            ..sphere
        };
        let towards = Ray {
            origin,
            direction: on[2],
        };
        let near = near.map(f32::of, f32::of);
        tally.lost += u64::from(meet(&near, &towards, min_t).is_none());
    }
    tally
}
