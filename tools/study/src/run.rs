//! Runs the whole study, part by part.

use rayon::prelude::*;

use crate::classes;
use crate::conditioning::condition;
use crate::contestants::HasKernels;
use crate::embree;
use crate::extent::{Extent, Part};
use crate::family::{Family, HasFamilies, questions};
use crate::judge::judge;
use crate::leaks::{self, Aim};
use crate::plans;
use crate::question::Data;
use crate::record::{Kind, record};
use crate::result::{Findings, KernelTally, Point, RandomPlans, Sweep};
use crate::scenes::{self, Stage};
use crate::secondary;
use crate::shape::{Plane, Sphere, Triangle};

/// Runs everything that the extent has. Calls `say` with the name of each step.
pub fn run(extent: &Extent, say: &dyn Fn(&str)) -> Findings {
    let mut findings = Findings::default();
    if extent.has(Part::Classes) {
        of_shape::<Sphere<f64>>(extent, say, &mut findings);
        of_shape::<Plane<f64>>(extent, say, &mut findings);
        of_shape::<Triangle<f64>>(extent, say, &mut findings);
    }
    if extent.has(Part::Mesh) {
        say("closed meshes");
        let kernels = Triangle::contestants();
        let tallies = kernels.par_iter().flat_map_iter(|kernel| {
            Aim::BOTH.map(|aim| leaks::of_kernel(kernel, aim, extent.mesh_rays, extent.seed))
        });
        findings.meshes = tallies.collect();
    }
    if extent.has(Part::Secondary) {
        say("rays that begin on a surface");
        findings.secondary = secondary::studied(extent.secondary, extent.seed);
    }
    if extent.has(Part::Plans) {
        for name in scenes::names() {
            say(&format!("plans for {name}"));
            let tallies = plans::studied(&Stage::new(&name, extent.step), extent);
            findings.plans.extend(tallies);
        }
        say("plans for random scenes");
        let count = record(Kind::Plans, 0..extent.random_plans, extent.seed);
        findings.random_plans = Some(RandomPlans {
            plans: extent.random_plans,
            pixels: count.asked,
            broken: count.broken,
        });
    }
    if extent.has(Part::Scenes) {
        for name in scenes::names() {
            say(&format!("scene {name}"));
            let tallies = scenes::studied(&Stage::new(&name, extent.step), extent);
            findings.scenes.extend(tallies);
        }
        say("scenes of small integers");
        // A grid has few rays, so cast all of them.
        let grids = scenes::grids().flat_map(|name| scenes::studied(&Stage::new(&name, 1), extent));
        findings.grids = grids.collect();
    }
    if extent.has(Part::Embree) {
        match embree::IS_INSTALLED {
            true => findings.embree = embree::studied(extent, say),
            false => findings.notes.push(embree::IS_MISSING),
        }
    }
    findings
}

fn of_shape<S: HasFamilies>(extent: &Extent, say: &dyn Fn(&str), findings: &mut Findings) {
    let mut sweeps = Vec::new();
    for family in S::families() {
        for data in [Data::F64, Data::F32] {
            say(&format!("{}: {} in {}", S::NAME, family.name, data.name()));
            let sweep = swept(&family, data, extent);
            findings.breaking.extend(classes::breaking(&sweep, data));
            sweeps.push(sweep);
        }
    }
    say(&format!("{}: costs", S::NAME));
    findings
        .trades
        .extend(classes::trades::<S>(&sweeps, extent));
    findings.tiers.extend(classes::tiers::<S>(extent));
    let conditioning = classes::conditioning(S::NAME, &sweeps);
    findings.conditioning.extend(conditioning);
    findings.families.extend(sweeps);
}

/// Sweeps one family in one type of data, with the same questions for every kernel.
fn swept<S: HasFamilies>(family: &Family<S>, data: Data, extent: &Extent) -> Sweep {
    let kernels = S::contestants().into_iter();
    let kernels: Vec<_> = kernels.filter(|kernel| kernel.data == data).collect();
    let mut points = Vec::new();
    for exponent in (family.exponents)(data) {
        let asked = questions(family, exponent, data, extent.questions, extent.seed);
        if asked.is_empty() {
            continue;
        }
        let truths: Vec<_> = asked.par_iter().map(S::truth).collect();
        let judged = kernels.par_iter().map(|kernel| {
            let (tally, errors) = judge(kernel, &asked, &truths);
            let with_condition = |(at, ulp): (usize, f64)| {
                let condition = condition(&asked[at], &truths[at]);
                (ulp, condition.unwrap_or(f64::INFINITY))
            };
            KernelTally {
                kernel: kernel.name,
                numbers: kernel.numbers,
                tally,
                errors: errors.into_iter().map(with_condition).collect(),
            }
        });
        points.push(Point {
            exponent,
            class: family.class(exponent),
            kernels: judged.collect(),
        });
    }
    Sweep {
        shape: S::NAME,
        family: family.name,
        axis: family.axis,
        data: data.name(),
        points,
    }
}
