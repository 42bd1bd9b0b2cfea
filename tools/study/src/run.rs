//! The whole study, one part after another.

use rayon::prelude::*;

use crate::breaking::breaking;
use crate::contestant::Contestant;
use crate::contestants::Contested;
use crate::family::mesh::Aim;
use crate::family::spoilt::{SPOILERS, spoiler, spoilt};
use crate::family::{Family, Studied, questions};
use crate::instructions;
use crate::judge::judge;
use crate::leaks;
use crate::plan::crossover;
use crate::plans;
use crate::question::Data;
use crate::result::{
    Breaking, CrossoverTally, Judged, MeshTally, PlanTally, Point, SceneTally, Speed, SpoiltTally,
    Sweep,
};
use crate::scenes::{self, Share};
use crate::shape::{Plane, Sphere, Triangle};
use crate::speed::race;
use crate::theirs::{self, Theirs};

/// How much of everything.
#[derive(Clone, Debug)]
pub struct Extent {
    /// `quick` or `full`.
    pub name: &'static str,
    /// Questions at each exponent.
    pub questions: usize,
    /// Rays at edges, and as many at vertices.
    pub mesh_rays: usize,
    /// Questions to spoil, for each of their numbers.
    pub spoilt: usize,
    /// Rounds of the race.
    pub rounds: usize,
    /// Whether instructions are counted.
    pub instructions: bool,
    /// How much of every scene.
    pub scenes: Share,
    /// What is wished of plans.
    pub accuracies: &'static [f64],
}

impl Extent {
    /// Less than a minute: for readers, and to keep the rest honest.
    pub const QUICK: Extent = Extent {
        name: "quick",
        questions: 600,
        mesh_rays: 10_000,
        spoilt: 5,
        rounds: 60,
        instructions: false,
        scenes: Share { step: 7, rounds: 3 },
        accuracies: &[1e-2, 1e-6, 1e-12],
    };
    /// For the record.
    pub const FULL: Extent = Extent {
        name: "full",
        questions: 10_000,
        mesh_rays: 500_000,
        spoilt: 50,
        rounds: 400,
        instructions: true,
        scenes: Share {
            step: 1,
            rounds: 15,
        },
        accuracies: &plans::ACCURACIES,
    };
}

/// What a run finds, before it is judged itself.
#[derive(Default)]
pub struct Findings {
    /// The sweeps.
    pub families: Vec<Sweep>,
    /// Closed meshes.
    pub meshes: Vec<MeshTally>,
    /// Spoilt inputs.
    pub spoilt: Vec<SpoiltTally>,
    /// Costs.
    pub speed: Vec<Speed>,
    /// Breaking points.
    pub breaking: Vec<Breaking>,
    /// Whole scenes.
    pub scenes: Vec<SceneTally>,
    /// Plans.
    pub plans: Vec<PlanTally>,
    /// From where on boxes pay.
    pub crossovers: Vec<CrossoverTally>,
}

/// Does it all, or only the family, `crossover`, `mesh`, `plans`, `scenes`, `spoilt` or
/// `speed` that is named; `say` is told what is being done.
pub fn run(
    extent: &Extent,
    seed: u64,
    only: Option<&str>,
    theirs: &Theirs,
    say: &dyn Fn(&str),
) -> Findings {
    let mut findings = Findings::default();
    let is_wanted = |part: &str| only.is_none_or(|only| only == part);
    if is_wanted("crossover") {
        say("from where on boxes pay");
        findings.crossovers = crossover::measured(extent.scenes.rounds);
    }
    of_shape::<Sphere<f64>>(extent, seed, &is_wanted, say, theirs, &mut findings);
    of_shape::<Plane<f64>>(extent, seed, &is_wanted, say, theirs, &mut findings);
    of_shape::<Triangle<f64>>(extent, seed, &is_wanted, say, theirs, &mut findings);
    if is_wanted("mesh") {
        say("closed meshes");
        let kernels = Triangle::contestants();
        let tallies = kernels.par_iter().flat_map_iter(|kernel| {
            Aim::BOTH.map(|aim| leaks::of_kernel(kernel, aim, extent.mesh_rays, seed))
        });
        findings.meshes = tallies.collect();
        let told = Aim::BOTH
            .into_iter()
            .filter_map(|aim| leaks::of(theirs, aim, seed));
        findings.meshes.extend(told);
    }
    for file in scenes::files() {
        let name = file.file_stem().unwrap_or_default().display();
        if is_wanted("plans") {
            say(&format!("plans for {name}"));
            let tallies = plans::studied(&file, extent.scenes, extent.accuracies);
            let tallies = tallies.expect("the scene is committed and can be planned");
            findings.plans.extend(tallies);
        }
        if is_wanted("scenes") {
            say(&format!("scene {name}"));
            let tallies =
                scenes::studied(&file, extent.scenes, theirs).expect("the scene is committed");
            findings.scenes.extend(tallies);
        }
    }
    findings
}

fn of_shape<S: Studied>(
    extent: &Extent,
    seed: u64,
    is_wanted: &dyn Fn(&str) -> bool,
    say: &dyn Fn(&str),
    theirs: &Theirs,
    findings: &mut Findings,
) {
    // Before anything else heats the machine.
    if is_wanted("speed") {
        say(&format!("{}: speed", S::NAME));
        findings.speed.extend(speeds::<S>(extent, seed));
    }
    for family in S::families().iter().filter(|family| is_wanted(family.name)) {
        for data in [Data::F64, Data::F32] {
            say(&format!("{}: {} in {}", S::NAME, family.name, data.name()));
            let sweep = swept(family, data, extent.questions, seed, theirs);
            findings.breaking.extend(breaking(&sweep, data));
            findings.families.push(sweep);
        }
    }
    if is_wanted("spoilt") {
        say(&format!("{}: inputs that are no ordinary numbers", S::NAME));
        let kernels = S::contestants();
        let tallies = kernels.par_iter().flat_map_iter(|kernel| {
            SPOILERS.map(|(name, value)| on_spoilt(kernel, name, value, extent.spoilt, seed))
        });
        findings.spoilt.par_extend(tallies);
    }
}

/// One family in one type of data, every kernel on the same questions.
pub fn swept<S: Studied>(
    family: &Family<S>,
    data: Data,
    count: usize,
    seed: u64,
    theirs: &Theirs,
) -> Sweep {
    let mut told = match data {
        theirs::DATA => theirs.family(S::NAME, family.name),
        _ => None,
    };
    let kernels: Vec<_> = S::contestants()
        .into_iter()
        .filter(|k| k.data == data)
        .collect();
    let mut point = |exponent| {
        let asked = questions(family, exponent, data, count, seed);
        let truths: Vec<_> = asked.par_iter().map(S::truth).collect();
        let judged = kernels.par_iter().map(|kernel| Judged {
            kernel: kernel.name.into(),
            numbers: kernel.numbers.into(),
            tally: judge(kernel, &asked, &truths),
        });
        let mut kernels: Vec<_> = judged.collect();
        kernels.extend(told.as_mut().map(|told| Judged {
            kernel: theirs::NAME.into(),
            numbers: theirs::DATA.name().into(),
            tally: told.judged(&asked, &truths),
        }));
        (!asked.is_empty()).then_some(Point { exponent, kernels })
    };
    Sweep {
        shape: S::NAME.into(),
        family: family.name.into(),
        meaning: family.meaning.into(),
        axis: family.axis.into(),
        data: data.name().into(),
        easy: family.easy,
        points: (family.exponents)(data)
            .into_iter()
            .filter_map(&mut point)
            .collect(),
    }
}

/// One kernel on questions of which one number is replaced: each number in turn.
pub fn on_spoilt<S: Studied>(
    kernel: &Contestant<S>,
    name: &str,
    value: f64,
    count: usize,
    seed: u64,
) -> SpoiltTally {
    let families = S::families();
    let plain = families.iter().find(|family| family.name == "offset");
    let plain = plain.expect("every shape has an offset");
    let value = spoiler(value, kernel.data);
    let mut tally = SpoiltTally {
        shape: S::NAME.into(),
        kernel: kernel.name.into(),
        numbers: kernel.numbers.into(),
        spoiler: name.into(),
        asked: 0,
        hits_of_nothing: 0,
        wrong: 0,
        not_finite: 0,
    };
    for question in questions(plain, 0, kernel.data, count, seed) {
        let all = (0..).map_while(|place| spoilt(&question, place, value));
        for question in all {
            // That is an honest way to ask for every t.
            if question.min_t == f64::NEG_INFINITY {
                continue;
            }
            if question.is_sound() {
                let judged = judge(kernel, &[question], &[S::truth(&question)]);
                tally.asked += judged.asked;
                tally.wrong += judged.wrong();
                tally.not_finite += judged.not_finite;
            } else {
                let answer = (kernel.answer)(&question);
                tally.asked += 1;
                tally.hits_of_nothing += u64::from(answer.is_some());
                tally.not_finite += u64::from(answer.is_some_and(|t| !t.is_finite()));
            }
        }
    }
    tally
}

fn speeds<S: Studied>(extent: &Extent, seed: u64) -> Vec<Speed> {
    let kernels = S::contestants();
    let mut speeds = Vec::new();
    for data in [Data::F64, Data::F32] {
        let times = race(&kernels, data, extent.rounds, seed);
        let fastest = times
            .iter()
            .map(|time| time.nanoseconds)
            .fold(f64::MAX, f64::min);
        let entered = kernels
            .iter()
            .enumerate()
            .filter(|(_, kernel)| kernel.data == data);
        speeds.extend(entered.zip(times).map(|((at, kernel), time)| {
            Speed {
                shape: S::NAME.into(),
                kernel: kernel.name.into(),
                numbers: kernel.numbers.into(),
                nanoseconds: time.nanoseconds,
                spread: time.spread,
                ratio: time.nanoseconds / fastest,
                instructions: extent
                    .instructions
                    .then(|| instructions::count::<S>(at))
                    .flatten(),
            }
        }));
    }
    speeds
}
