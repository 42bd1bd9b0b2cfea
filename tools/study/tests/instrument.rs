//! The instrument itself: does it notice what is broken, and is nothing else noticed?

use pinhole_study::contestant::Contestant;
use pinhole_study::contestants::Contested;
use pinhole_study::family::mesh::Aim;
use pinhole_study::family::spoilt::SPOILERS;
use pinhole_study::family::{Studied, questions};
use pinhole_study::judge::{Tally, judge};
use pinhole_study::kernel::{Kernel, sphere, triangle};
use pinhole_study::leaks;
use pinhole_study::question::{Data, Question};
use pinhole_study::run::{Extent, on_spoilt, run};
use pinhole_study::shape::{Plane, Ray, Sphere, Triangle};
use pinhole_study::targets::targets;
use pinhole_study::theirs::Theirs;
use pinhole_study::vector::Vector;

const SEED: u64 = 7;

/// Tallies of one `f64` or `f32` contestant over every family and exponent.
fn over_all<S: Studied>(kernel: &Contestant<S>, count: usize) -> Vec<(String, Tally)> {
    let mut tallies = Vec::new();
    for family in S::families() {
        for exponent in (family.exponents)(kernel.data) {
            let asked = questions(&family, exponent, kernel.data, count, SEED);
            let truths: Vec<_> = asked.iter().map(S::truth).collect();
            let place = format!("{} {} {exponent}", S::NAME, family.name);
            tallies.push((place, judge(kernel, &asked, &truths)));
        }
    }
    tallies
}

fn wrong<S: Studied>(kernel: &Contestant<S>) -> u64 {
    over_all(kernel, 50)
        .iter()
        .map(|(_, tally)| tally.wrong())
        .sum()
}

/// Only the far side of a sphere is looked for.
struct FarSide;

impl Kernel<Sphere<f64>, f64> for FarSide {
    const NAME: &'static str = "far side";
    type Prepared = Ray<f64>;
    fn prepare(ray: &Ray<f64>) -> Ray<f64> {
        *ray
    }
    fn intersect(sphere: &Sphere<f64>, ray: &Ray<f64>, min_t: f64) -> Option<f64> {
        let near = sphere::Haines::intersect(sphere, ray, min_t)?;
        sphere::Haines::intersect(sphere, ray, near.next_up() + near.abs() * 1e-9).or(Some(near))
    }
}

/// The last bit of a direction's component is dropped: one ulp of an input.
struct OneUlpOff;

impl Kernel<Triangle<f64>, f64> for OneUlpOff {
    const NAME: &'static str = "one ulp off";
    type Prepared = <triangle::Adaptive as Kernel<Triangle<f64>, f64>>::Prepared;
    fn prepare(ray: &Ray<f64>) -> Self::Prepared {
        let mut ray = *ray;
        ray.direction.x = ray.direction.x.next_up();
        triangle::Adaptive::prepare(&ray)
    }
    fn intersect(shape: &Triangle<f64>, ray: &Self::Prepared, min_t: f64) -> Option<f64> {
        triangle::Adaptive::intersect(shape, ray, min_t)
    }
}

/// A triangle without its edges: strict comparisons.
struct Strict;

impl Kernel<Triangle<f64>, f64> for Strict {
    const NAME: &'static str = "strict";
    type Prepared = Ray<f64>;
    fn prepare(ray: &Ray<f64>) -> Ray<f64> {
        *ray
    }
    fn intersect(shape: &Triangle<f64>, ray: &Ray<f64>, min_t: f64) -> Option<f64> {
        let [a, b, c] = shape.corners.map(|corner| corner - ray.origin);
        let volumes = [b.cross(c), c.cross(a), a.cross(b)].map(|area| area.dot(ray.direction));
        let is_inside = volumes.iter().all(|v| *v > 0.0) || volumes.iter().all(|v| *v < 0.0);
        triangle::EdgeFunctions::intersect(shape, ray, min_t).filter(|_| is_inside)
    }
}

#[test]
fn a_kernel_that_takes_the_far_root_is_noticed() {
    let broken = Contestant::<Sphere<f64>>::new::<FarSide, f64>(Data::F64, "f64");
    let roots: u64 = over_all(&broken, 50)
        .iter()
        .map(|(_, tally)| tally.wrong_roots)
        .sum();
    assert!(roots > 1000, "{roots}");
}

#[test]
fn a_kernel_that_is_one_ulp_off_is_noticed() {
    let broken = Contestant::<Triangle<f64>>::new::<OneUlpOff, f64>(Data::F64, "f64");
    assert!(wrong(&broken) > 0);
}

#[test]
fn a_kernel_that_leaves_out_edges_leaks() {
    let broken = Contestant::<Triangle<f64>>::new::<Strict, f64>(Data::F64, "f64");
    let tally = leaks::of_kernel(&broken, Aim::Vertex, 500, SEED);
    assert!(tally.leaks > 50, "{tally:?}");
}

#[test]
fn an_eye_at_the_centre_sees_the_sphere_at_its_radius() {
    let zero = Vector::new(0.0, 0.0, 0.0);
    let direction = Vector::new(0.0, -0.5, 0.0);
    let ray = Ray {
        origin: zero,
        direction,
    };
    let shape = Sphere {
        center: zero,
        radius: 1.0,
    };
    let question = Question {
        shape,
        ray,
        min_t: 0.0,
    };
    for kernel in Sphere::contestants() {
        assert_eq!(
            (kernel.answer)(&question),
            Some(2.0),
            "{} {}",
            kernel.name,
            kernel.numbers
        );
    }
}

#[track_caller]
fn exact_kernels_are_never_wrong<S: Studied>() {
    for kernel in S::contestants()
        .iter()
        .filter(|kernel| kernel.name == "adaptive exact")
    {
        // t is promised to √u of itself.
        let promise = 2f64.powf(f64::from(kernel.data.digits()) / 2.0 + 0.5);
        for (place, tally) in over_all(kernel, 100) {
            let worst = tally.worst_ulp.unwrap_or(0.0);
            let is_right = tally.wrong() + tally.not_finite == 0 && worst <= promise;
            assert!(is_right, "{place} {}: {tally:?}", kernel.numbers);
        }
        for (name, value) in SPOILERS {
            let tally = on_spoilt(kernel, name, value, 20, SEED);
            let faults = tally.hits_of_nothing + tally.wrong + tally.not_finite;
            assert_eq!(faults, 0, "{tally:?}");
        }
    }
}

#[test]
fn the_exact_sphere_is_never_wrong() {
    exact_kernels_are_never_wrong::<Sphere<f64>>();
}

#[test]
fn the_exact_plane_is_never_wrong() {
    exact_kernels_are_never_wrong::<Plane<f64>>();
}

#[test]
fn the_exact_triangle_is_never_wrong() {
    exact_kernels_are_never_wrong::<Triangle<f64>>();
}

#[test]
fn closed_meshes_of_exact_triangles_are_left_exactly_once() {
    for kernel in Triangle::contestants()
        .iter()
        .filter(|kernel| kernel.name == "adaptive exact")
    {
        for aim in [Aim::Edge, Aim::Vertex] {
            let tally = leaks::of_kernel(kernel, aim, 3000, SEED);
            assert_eq!((tally.leaks, tally.double_hits), (0, 0), "{tally:?}");
        }
    }
}

#[test]
fn what_was_measured_before_comes_again() {
    let extent = Extent {
        questions: 400,
        mesh_rays: 4000,
        ..Extent::QUICK
    };
    for part in [
        "distance",
        "direction",
        "offset",
        "parallel",
        "small",
        "mesh",
    ] {
        let findings = run(&extent, SEED, Some(part), &Theirs::default(), &|_| ());
        let targets = targets(&findings);
        assert!(!targets.is_empty(), "{part} has no target");
        let missed: Vec<_> = targets.iter().filter(|target| !target.met).collect();
        assert!(missed.is_empty(), "{missed:#?}");
    }
}

#[test]
fn a_study_is_the_same_again() {
    let extent = Extent {
        questions: 20,
        ..Extent::QUICK
    };
    let sweeps = || run(&extent, SEED, Some("sliver"), &Theirs::default(), &|_| ()).families;
    let [first, second] = [sweeps(), sweeps()].map(|s| serde_json::to_string(&s).expect("JSON"));
    assert!(first.len() > 1000 && first == second);
}
