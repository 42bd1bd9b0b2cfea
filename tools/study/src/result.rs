//! The result of a study, as written to `study.json`.

use serde::Serialize;

use crate::cast;
use crate::judge::Tally;
use crate::kernel::Tier;
use crate::oracle::scene::FilmErrors;
use crate::question::Class;

/// The version of the document; it changes when a field changes its meaning.
pub const SCHEMA: &str = "pinhole-study/3";

/// One run of the study.
#[derive(Clone, Debug, Serialize)]
pub struct Study {
    /// The version of this format.
    pub schema: String,
    /// Where, when and how.
    pub provenance: Provenance,
    /// What was found.
    #[serde(flatten)]
    pub findings: Findings,
    /// Promised or earlier figures, with the ones measured now.
    pub targets: Vec<Target>,
}

/// The findings of a run, before they are compared with the promises.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Findings {
    /// The sweeps.
    pub families: Vec<Sweep>,
    /// Closed meshes.
    pub meshes: Vec<MeshTally>,
    /// Cost and wrong answers of each kernel, by class.
    pub trades: Vec<Trade>,
    /// The tiers of the exact kernels.
    pub tiers: Vec<TierTally>,
    /// Errors of t by the question's condition number.
    pub conditioning: Vec<ConditioningErrors>,
    /// Rays that begin on a surface.
    pub secondary: Vec<Secondary>,
    /// Where each kernel breaks.
    pub breaking: Vec<BreakingPoint>,
    /// Whole scenes.
    pub scenes: Vec<SceneTally>,
    /// Scenes made of small integers, in which rays hit edges, corners and tangents exactly.
    pub grids: Vec<SceneTally>,
    /// Whole scenes, cast by plans.
    pub plans: Vec<PlanTally>,
    /// Plans of random scenes, if any were made.
    pub random_plans: Option<RandomPlans>,
    /// Meshes that were cast beside Embree.
    pub embree: Vec<EmbreeTally>,
    /// What could not be measured on this machine, and why.
    pub notes: Vec<&'static str>,
}

/// Where, when and how a study was made.
#[derive(Clone, Debug, Serialize)]
pub struct Provenance {
    /// The processor.
    pub machine: String,
    /// The date, in UTC.
    pub date: String,
    /// The commit, with `+` appended if the work tree differs.
    pub commit: String,
    /// The command.
    pub command: String,
    /// `quick` or `full`.
    pub mode: String,
    /// The seed of random numbers.
    pub seed: u64,
    /// The compiler's target features that matter.
    pub features: String,
}

/// One family of questions about one shape, in one type of data.
#[derive(Clone, Debug, Serialize)]
pub struct Sweep {
    /// sphere, plane or triangle.
    pub shape: &'static str,
    /// The family's name.
    pub family: &'static str,
    /// The meaning of x.
    pub axis: &'static str,
    /// The type that the questions' numbers are rounded to.
    pub data: &'static str,
    /// The points, in order of x.
    pub points: Vec<Point>,
}

/// One exponent of a sweep.
#[derive(Clone, Debug, Serialize)]
pub struct Point {
    /// The exponent x.
    pub exponent: i32,
    /// The class of the questions with this exponent.
    pub class: Class,
    /// The results of all kernels.
    pub kernels: Vec<KernelTally>,
}

/// The result of one kernel.
#[derive(Clone, Debug, Serialize)]
pub struct KernelTally {
    /// The kernel's name.
    pub kernel: &'static str,
    /// The numbers that the kernel computes with, such as `f64`.
    pub numbers: &'static str,
    /// The tally of its answers.
    #[serde(flatten)]
    pub tally: Tally,
    /// The error of each t that is not a wrong decision, in ulp, and its question's condition
    /// number.
    #[serde(skip)]
    pub errors: Vec<(f64, f64)>,
}

/// One kernel on closed meshes.
#[derive(Clone, Debug, Serialize)]
pub struct MeshTally {
    /// The kernel's name.
    pub kernel: &'static str,
    /// The numbers that the kernel computes with, such as `f64`.
    pub numbers: &'static str,
    /// `edge` or `vertex`.
    pub aimed_at: &'static str,
    /// Rays from inside; each leaves the mesh exactly once.
    pub rays: u64,
    /// Rays that hit nothing.
    pub leaks: u64,
    /// Rays that hit more than one triangle.
    pub double_hits: u64,
}

/// One kernel on one class of questions about one shape: what it costs, and what it gets
/// wrong. Costs are those of an even sample of the questions that are judged.
#[derive(Clone, Debug, Serialize)]
pub struct Trade {
    /// sphere, plane or triangle.
    pub shape: &'static str,
    /// The class of the questions.
    pub class: Class,
    /// The kernel's name.
    pub kernel: &'static str,
    /// The numbers that the kernel computes with, such as `f64`.
    pub numbers: &'static str,
    /// Questions that were judged.
    pub asked: u64,
    /// Wrong decisions.
    pub wrong: u64,
    /// Answers whose t is infinite or NaN.
    pub not_finite: u64,
    /// The median error of t, in ulp.
    pub median_ulp: Option<f64>,
    /// CPU time for one ray and one shape, in the median round.
    pub nanoseconds: Option<f64>,
    /// Half the width of the median's 95 % confidence interval, divided by the median.
    pub spread: Option<f64>,
    /// Instructions for one ray and one shape, by callgrind.
    pub instructions: Option<f64>,
}

/// One tier of an exact kernel in `f64`: how often it decides, and what a question that it
/// decides costs, including the tiers before it.
#[derive(Clone, Debug, Serialize)]
pub struct TierTally {
    /// sphere, plane or triangle.
    pub shape: &'static str,
    /// The class of the questions.
    pub class: Class,
    /// The tier.
    pub tier: Tier,
    /// Questions that this tier decided.
    pub decided: u64,
    /// All questions.
    pub asked: u64,
    /// CPU time for a question that it decides.
    pub nanoseconds: f64,
    /// Instructions for a question that it decides, by callgrind.
    pub instructions: Option<f64>,
}

/// One kernel's errors of t in everyday and hard questions whose condition numbers are in the
/// same decade.
#[derive(Clone, Debug, Serialize)]
pub struct ConditioningErrors {
    /// sphere, plane or triangle.
    pub shape: &'static str,
    /// The kernel's name.
    pub kernel: &'static str,
    /// The numbers that the kernel computes with, such as `f64`.
    pub numbers: &'static str,
    /// The condition number is from 10^`decade` to ten times as much.
    pub decade: i32,
    /// True hits that were answered with a finite t.
    pub hits: u64,
    /// The median error of t, in ulp.
    pub median_ulp: f64,
    /// The largest error of t, in ulp.
    pub worst_ulp: f64,
}

/// Where one kernel breaks in one family.
#[derive(Clone, Debug, Serialize)]
pub struct BreakingPoint {
    /// sphere, plane or triangle.
    pub shape: &'static str,
    /// The family's name.
    pub family: &'static str,
    /// The kernel's name.
    pub kernel: &'static str,
    /// The numbers that the kernel computes with, such as `f64`.
    pub numbers: &'static str,
    /// Going up from the easiest exponent, the first at which the kernel is broken.
    pub above: Option<i32>,
}

/// One way to cast one whole scene.
#[derive(Clone, Debug, Default, Serialize)]
pub struct SceneTally {
    /// The scene's name.
    pub scene: String,
    /// `f64`, `exact`, or `Mitsuba` (the golden film, which Mitsuba made with its own rays in
    /// `f32`).
    pub model: &'static str,
    /// `brute force` or `boxes`.
    pub search: Option<&'static str>,
    /// The oracle's judgement of the film, without a request for accuracy.
    #[serde(flatten)]
    pub errors: FilmErrors,
    /// CPU time for a ray, in the median film.
    pub nanoseconds: Option<f64>,
    /// Instructions for a ray of a film, by callgrind.
    pub instructions: Option<f64>,
    /// Mean number of parts tested per ray.
    pub tests: Option<f64>,
    /// The work of all rays together.
    #[serde(flatten)]
    pub tally: cast::Tally,
}

/// Rays that begin at the hit of another ray, with the origin moved off the surface by one
/// method, all in `f32`.
#[derive(Clone, Debug, Serialize)]
pub struct Secondary {
    /// The shape that the rays leave: `sphere`.
    pub shape: &'static str,
    /// How the origin is moved.
    pub method: &'static str,
    /// The distance of the scene from the world's origin, in sizes of the surface.
    pub offset: f64,
    /// Rays that leave the surface, none of which truly hits it again.
    pub leaving: u64,
    /// Those of the rays in `leaving` that hit the surface again, which causes dark specks in
    /// shadows.
    pub self_hits: u64,
    /// As many rays are aimed at a surface that is a thousandth of the sphere's radius away. These
    /// miss it, which causes light leaks.
    pub lost: u64,
}

/// One plan, and its result at the pixels of its scene.
#[derive(Clone, Debug, Serialize)]
pub struct PlanTally {
    /// The scene's name.
    pub scene: String,
    /// The requested accuracy.
    pub accuracy: f64,
    /// The oracle's judgement of its film.
    #[serde(flatten)]
    pub kept: FilmErrors,
    /// Pixels whose t and normal were computed exactly.
    pub exact_hits: u64,
    /// Time for making the plan, divided by the number of pixels.
    pub planning: f64,
    /// CPU time for a ray, in the median film.
    pub nanoseconds: f64,
    /// CPU time for a ray if only objects are exact, and t and normals are not refined.
    pub exact_ids: f64,
    /// CPU time for a ray in plain `f64`.
    pub plain: f64,
    /// Time for building the tree for plain `f64`, divided by the number of pixels.
    pub plain_tree: f64,
}

/// Plans of random scenes, with sizes from 1e-30 to 1e30, judged at every pixel.
#[derive(Clone, Debug, Serialize)]
pub struct RandomPlans {
    /// Plans that were made, each for another scene.
    pub plans: u64,
    /// Pixels that were judged.
    pub pixels: u64,
    /// The numbers of the plans with a wrong object or a pixel that is less accurate than requested.
    pub broken: Vec<u64>,
}

/// One caster on the rays of a camera at one mesh.
#[derive(Clone, Debug, Serialize)]
pub struct EmbreeTally {
    /// The mesh's name.
    pub mesh: &'static str,
    /// The number of its triangles.
    pub triangles: usize,
    /// The caster's name.
    pub caster: &'static str,
    /// Rays that were cast.
    pub rays: u64,
    /// Rays whose answer differs from that of exact casting by more than rounding to `f32` explains.
    pub differ: u64,
    /// CPU time for a ray, in the median film.
    pub nanoseconds: f64,
    /// Half the width of the median's 95 % confidence interval, divided by the median.
    pub spread: f64,
    /// The time divided by that of Embree.
    pub over_embree: f64,
}

/// A figure that was promised or measured before, and the one measured now.
#[derive(Clone, Debug, Serialize)]
pub struct Target {
    /// What was measured.
    pub about: String,
    /// The promise, in words.
    pub expected: String,
    /// The measurement, in words.
    pub measured: String,
    /// Whether the promise is kept.
    pub met: bool,
    /// Whether the figure is a cost: a time, which depends on the machine and its load, or a number
    /// of instructions. Missing such a target is reported, but does not fail the run.
    pub is_time: bool,
}
