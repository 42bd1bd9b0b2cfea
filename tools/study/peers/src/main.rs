//! Benchmark of our caster against Embree, on the same rays and meshes:
//! `cargo run --release --manifest-path tools/study/peers/Cargo.toml`.
//!
//! The casters take turns. Each round casts all rays, and the median round is reported, in CPU
//! time of this thread. Answers that differ from the exact caster's are counted. The times
//! depend on the build: `RUSTFLAGS="-C target-cpu=native"` makes our casters faster, whereas
//! Embree selects its instruction set at run time.

#[cfg(embree)]
mod embree;
mod mesh;

use std::hint::black_box;

use mesh::{Mesh, ball, of_assignment};
use pinhole_study::cast::model::{Exact, Model, Plain};
use pinhole_study::cast::world::{Primitive, View, World};
use pinhole_study::cast::{Caster, Tally};
use pinhole_study::kernel::Camera;
use pinhole_study::shape::{self, Triangle};
use pinhole_study::speed::{Workload, race};
use pinhole_study::vector::Vector;

/// A ray in `f32`; the direction need not be unit length.
type Ray = shape::Ray<f32>;

/// Casts all rays and returns the first t of each; infinite for a miss.
type Cast = Box<dyn Fn() -> Vec<f64>>;

/// Target: our time divided by Embree's should be at most this.
const OVER_EMBREE: f64 = 1.5;

/// Largest difference of two t that agree: a hundred unit roundoffs of `f32`. The rounded
/// origin and corners alone move t by a few of them.
const FAR: f64 = 6e-6;

fn main() {
    let seconds = std::env::args().nth(1).map_or(1.0, |seconds| {
        seconds.parse().expect("the argument is a time in seconds")
    });
    if cfg!(not(embree)) {
        println!("skipped Embree: its headers are not installed (Debian: libembree-dev)");
    }
    for mesh in [
        of_assignment("teapot"),
        of_assignment("bunny"),
        ball(94),
        ball(354),
    ] {
        compare(&mesh, &primary(), seconds);
    }
}

/// 256 × 256 rays of a camera at distance 3 from the centre of a mesh of radius 1, which fills the
/// image.
fn primary() -> Vec<Ray> {
    let at = |pixel: u32| (f64::from(pixel) + 0.5) / 256.0 * 0.8 - 0.4;
    let ray = |index: u32| {
        let (x, y) = (at(index % 256), at(index / 256));
        let to = Vector::new(-2.0 / 3.0 + 0.6 * x, -1.0 / 3.0 + y, -2.0 / 3.0 - 0.6 * x);
        Ray {
            origin: Vector::new(2.0, 1.0, 2.0),
            direction: to.map(|number| number as f32),
        }
    };
    (0..256 * 256).map(ray).collect()
}

/// The study's caster, with its bounding volume hierarchy.
fn ours<M: Model>(mesh: &Mesh, rays: &[Ray]) -> Cast {
    let wide = |[x, y, z]: [f32; 3]| Vector::new(x, y, z).map(f64::from);
    let mut world = World::default();
    for corners in &mesh.triangles {
        let corners = corners.map(wide);
        world.add(0, Primitive::Triangle(Triangle { corners }));
    }
    let eye = rays[0].origin.map(f64::from);
    let view = M::FILTERS.then_some(View {
        camera: Camera::Perspective { eye },
        accuracy: f64::INFINITY,
    });
    let caster = Caster::new(world, view, true);
    let rays = rays.iter().map(|ray| ray.map(f64::from, f64::from));
    let rays: Vec<_> = rays.collect();
    Box::new(move || {
        let mut tally = Tally::default();
        let mut first = |ray| caster.first::<M>(ray, 0.0, &mut tally);
        let t = |ray| first(ray).map_or(f64::INFINITY, |found| found.t);
        rays.iter().map(t).collect()
    })
}

/// Times all casters on these rays and prints a table, with times relative to the last caster's.
fn compare(mesh: &Mesh, rays: &[Ray], seconds: f64) {
    let casters = [
        ("ours, exact", ours::<Exact<true>>(mesh, rays)),
        ("ours, plain f64", ours::<Plain>(mesh, rays)),
        #[cfg(embree)]
        ("Embree robust, f32", embree::robust(mesh, rays)),
    ];
    let mut films: Vec<Workload> = Vec::new();
    for (_, cast) in &casters {
        films.push(Box::new(|| _ = black_box(cast())));
    }
    let times = race(films, rays.len(), seconds);
    let exact = casters[0].1();
    let last = times[casters.len() - 1].nanoseconds;
    println!("\n{}, {} rays", mesh.name, rays.len());
    for ((name, cast), time) in casters.iter().zip(&times) {
        let both = exact.iter().zip(cast());
        let differ = both.filter(|(one, other)| !agree(**one, *other)).count();
        let (time, percent) = (time.nanoseconds, 100.0 * time.spread);
        let over = time / last;
        println!("{name:<20} {time:>7.1} ns/ray ± {percent:.0} %, × {over:.2}, {differ} differ");
    }
    let over = times[0].nanoseconds / last;
    if cfg!(embree) {
        let verdict = if over <= OVER_EMBREE {
            "pass"
        } else {
            "falls short"
        };
        println!("our exact time divided by Embree's, at most {OVER_EMBREE}: {over:.2}, {verdict}");
    }
}

/// Whether both miss, or both hit and their t differ by no more than rounding to `f32`
/// explains.
fn agree(one: f64, other: f64) -> bool {
    match one.is_finite() && other.is_finite() {
        true => (one - other).abs() <= FAR * (1.0 + one.abs()),
        false => one == other,
    }
}
