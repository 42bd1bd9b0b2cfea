//! Casts meshes with our caster and with Embree, on the same rays. Embree selects its instruction
//! set at run time, whereas our caster is compiled for one.

#[cfg(embree)]
mod binding;
mod mesh;

use std::hint::black_box;

use self::mesh::{Mesh, ball, of_assignment};
use crate::cast::model::{Exact, Model, Plain};
use crate::cast::world::{Primitive, View, World};
use crate::cast::{Caster, Tally};
use crate::extent::Extent;
use crate::kernel::Camera;
use crate::result::EmbreeTally;
use crate::shape::{Ray, Triangle};
use crate::speed::{Workload, race};
use crate::vector::Vector;

/// Casts all rays and returns the first t of each; infinite for a miss.
type Cast = Box<dyn Fn() -> Vec<f64>>;

/// Largest difference of two t that agree: a hundred unit roundoffs of `f32`. The rounded
/// origin and corners alone move t by a few of them.
const FAR: f64 = 6e-6;

/// A film of a mesh takes so long that its rounds need more time than those of kernels.
const PATIENCE: f64 = 10.0;

/// The name of exact casting in the results.
pub const EXACT: &str = "ours, exact";

/// Whether Embree was installed when this program was built.
pub const IS_INSTALLED: bool = cfg!(embree);

/// What the study says if it was not.
pub const IS_MISSING: &str = "Exact casting was not compared with Embree, because Embree's header \
    is not installed. Install it (Debian: libembree-dev), and run this again.";

/// Casts each mesh in all ways. Calls `say` with the name of each mesh.
pub fn studied(extent: &Extent, say: &dyn Fn(&str)) -> Vec<EmbreeTally> {
    let assignment = ["teapot", "bunny"].into_iter().map(of_assignment);
    let meshes = assignment.chain(extent.balls.iter().map(|n| ball(*n)));
    let compared = |mesh: Mesh| {
        say(&format!("{} beside Embree", mesh.name));
        compare(&mesh, &primary(), PATIENCE * extent.seconds)
    };
    meshes.flat_map(compared).collect()
}

/// 256 × 256 rays of a camera at distance 3 from the centre of a mesh of radius 1, which fills the
/// image.
fn primary() -> Vec<Ray<f32>> {
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
fn ours<M: Model>(mesh: &Mesh, rays: &[Ray<f32>]) -> Cast {
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

/// Times all casters on these rays, in turn, and compares their answers with the exact ones.
fn compare(mesh: &Mesh, rays: &[Ray<f32>], seconds: f64) -> Vec<EmbreeTally> {
    let casters = [
        (EXACT, ours::<Exact<true>>(mesh, rays)),
        ("ours, plain f64", ours::<Plain>(mesh, rays)),
        #[cfg(embree)]
        ("Embree robust, f32", binding::robust(mesh, rays)),
    ];
    let mut films: Vec<Workload> = Vec::new();
    for (_, cast) in &casters {
        films.push(Box::new(|| _ = black_box(cast())));
    }
    let times = race(films, rays.len(), seconds);
    let exact = casters[0].1();
    let embree = times[casters.len() - 1].nanoseconds;
    let mut tallies = Vec::new();
    for ((caster, cast), time) in casters.iter().zip(&times) {
        let both = exact.iter().zip(cast());
        tallies.push(EmbreeTally {
            mesh: mesh.name,
            triangles: mesh.triangles.len(),
            caster,
            rays: rays.len() as u64,
            differ: both.filter(|(one, other)| !agree(**one, *other)).count() as u64,
            nanoseconds: time.nanoseconds,
            spread: time.spread,
            over_embree: time.nanoseconds / embree,
        });
    }
    tallies
}

/// Whether both miss, or both hit and their t differ by no more than rounding to `f32`
/// explains.
fn agree(one: f64, other: f64) -> bool {
    match one.is_finite() && other.is_finite() {
        true => (one - other).abs() <= FAR * (1.0 + one.abs()),
        false => one == other,
    }
}
