//! Runs the whole study, part by part.

use rayon::prelude::*;

use crate::breaking::breaking;
use crate::classes::{self, Errors};
use crate::conditioning::Conditioning;
use crate::contestants::HasKernels;
use crate::family::{Family, HasFamilies, questions};
use crate::judge::judge;
use crate::leaks::{self, Aim};
use crate::plans;
use crate::question::Data;
use crate::result::{Findings, KernelTally, Point, Sweep};
use crate::scenes::{self, Share};
use crate::secondary;
use crate::shape::{Plane, Sphere, Triangle};

/// How much work a study does.
#[derive(Clone, Debug)]
pub struct Extent {
    /// `quick` or `full`.
    pub name: &'static str,
    /// Questions at each exponent of a family.
    pub questions: usize,
    /// Rays at edges, and as many at vertices.
    pub mesh_rays: usize,
    /// Rays that begin on a surface.
    pub secondary: usize,
    /// How much of every scene is cast, and how costs are measured, of kernels too.
    pub scenes: Share,
    /// The accuracies that plans are made for.
    pub accuracies: &'static [f64],
}

impl Extent {
    /// The quick study, which takes less than a minute.
    pub const QUICK: Extent = Extent {
        name: "quick",
        questions: 600,
        mesh_rays: 10_000,
        secondary: 2_000,
        scenes: Share {
            step: 7,
            seconds: 0.01,
            instructions: false,
        },
        accuracies: &[1e-2, 1e-6, 1e-12],
    };
    /// The full study, as recorded in `tools/study/record`.
    pub const FULL: Extent = Extent {
        name: "full",
        questions: 4_000,
        mesh_rays: 300_000,
        secondary: 200_000,
        scenes: Share {
            step: 1,
            seconds: 0.15,
            instructions: true,
        },
        accuracies: &plans::ACCURACIES,
    };
}

/// Runs everything, or only the named part: a family, `classes` (all families and what each
/// kernel costs), `mesh`, `plans`, `scenes` or `secondary`. Calls `say` with the name of each
/// step.
pub fn run(extent: &Extent, seed: u64, only: Option<&str>, say: &dyn Fn(&str)) -> Findings {
    let mut findings = Findings::default();
    let is_wanted = |part: &str| only.is_none_or(|only| only == part);
    of_shape::<Sphere<f64>>(extent, seed, &is_wanted, say, &mut findings);
    of_shape::<Plane<f64>>(extent, seed, &is_wanted, say, &mut findings);
    of_shape::<Triangle<f64>>(extent, seed, &is_wanted, say, &mut findings);
    if is_wanted("mesh") {
        say("closed meshes");
        let kernels = Triangle::contestants();
        let tallies = kernels.par_iter().flat_map_iter(|kernel| {
            Aim::BOTH.map(|aim| leaks::of_kernel(kernel, aim, extent.mesh_rays, seed))
        });
        findings.meshes = tallies.collect();
    }
    if is_wanted("secondary") {
        say("rays that begin on a surface");
        findings.secondary = secondary::studied(extent.secondary, seed);
    }
    for file in scenes::files() {
        let name = scenes::name_of(&file);
        if is_wanted("plans") {
            say(&format!("plans for {name}"));
            let tallies = plans::studied(&file, extent.scenes, extent.accuracies);
            let tallies = tallies.expect("the scene is committed and can be planned");
            findings.plans.extend(tallies);
        }
        if is_wanted("scenes") {
            say(&format!("scene {name}"));
            let tallies = scenes::studied(&file, extent.scenes).expect("the scene is committed");
            findings.scenes.extend(tallies);
        }
    }
    if is_wanted("scenes") {
        say("scenes of small integers");
        let grids = scenes::GRIDS.flat_map(|seed| scenes::of_grid(seed, extent.scenes));
        findings.grids = grids.collect();
    }
    findings
}

/// The parts that can be named to [`run`].
pub fn parts() -> Vec<&'static str> {
    let mut names = vec!["classes", "mesh", "plans", "scenes", "secondary"];
    names.extend(Sphere::families().iter().map(|family| family.name));
    names.extend(Plane::families().iter().map(|family| family.name));
    names.extend(Triangle::families().iter().map(|family| family.name));
    names.sort_unstable();
    names.dedup();
    names
}

fn of_shape<S: HasFamilies + Conditioning>(
    extent: &Extent,
    seed: u64,
    is_wanted: &dyn Fn(&str) -> bool,
    say: &dyn Fn(&str),
    findings: &mut Findings,
) {
    let (mut sweeps, mut errors) = (Vec::new(), Errors::new());
    let is_whole = is_wanted("classes");
    let families = S::families();
    for family in families.iter().filter(|it| is_whole || is_wanted(it.name)) {
        for data in [Data::F64, Data::F32] {
            say(&format!("{}: {} in {}", S::NAME, family.name, data.name()));
            let sweep = swept(family, data, extent.questions, seed, &mut errors);
            findings.breaking.extend(breaking(&sweep, data));
            sweeps.push(sweep);
        }
    }
    if is_whole {
        say(&format!("{}: costs", S::NAME));
        let trades = classes::trades::<S>(&sweeps, &errors, extent.scenes, seed);
        findings.trades.extend(trades);
        let tiers = classes::tiers::<S>(extent.scenes, seed);
        findings.tiers.extend(tiers);
        let conditioning = classes::conditioning(S::NAME, &errors);
        findings.conditioning.extend(conditioning);
    }
    findings.families.extend(sweeps);
}

/// Sweeps one family in one type of data, with the same questions for every kernel.
pub fn swept<S: HasFamilies + Conditioning>(
    family: &Family<S>,
    data: Data,
    count: usize,
    seed: u64,
    errors: &mut Errors,
) -> Sweep {
    let kernels: Vec<_> = S::contestants()
        .into_iter()
        .filter(|k| k.data == data)
        .collect();
    let mut points = Vec::new();
    for exponent in (family.exponents)(data) {
        let asked = questions(family, exponent, data, count, seed);
        if asked.is_empty() {
            continue;
        }
        let truths: Vec<_> = asked.par_iter().map(S::truth).collect();
        let judged = kernels.par_iter().map(|kernel| {
            let judged = judge(kernel, &asked, &truths);
            (kernel.name, kernel.numbers, judged)
        });
        let judged: Vec<_> = judged.collect();
        let class = family.class(exponent);
        let mut kernels = Vec::new();
        for (kernel, numbers, (tally, of_it)) in judged {
            let condition = |at: usize| S::condition(&asked[at], &truths[at]);
            let with_condition = of_it
                .into_iter()
                .map(|(at, ulp)| (class, ulp, condition(at).unwrap_or(f64::INFINITY)));
            errors
                .entry((kernel, numbers))
                .or_default()
                .extend(with_condition);
            kernels.push(KernelTally {
                kernel,
                numbers,
                tally,
            });
        }
        points.push(Point {
            exponent,
            class,
            kernels,
        });
    }
    Sweep {
        shape: S::NAME,
        family: family.name,
        meaning: family.meaning,
        axis: family.axis,
        data: data.name(),
        points,
    }
}
