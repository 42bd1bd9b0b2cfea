//! What a study found, as it is written to `study.json`: `schema/study-1.json` says what
//! each field means to other programs.

use serde::{Deserialize, Serialize};

use crate::judge::Tally;

/// The version of the document; it changes when a field changes its meaning.
pub const SCHEMA: &str = "pinhole-study/1";

/// One run of the instrument.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Study {
    /// [`SCHEMA`].
    pub schema: String,
    /// Where, when and how.
    pub provenance: Provenance,
    /// The sweeps.
    pub families: Vec<Sweep>,
    /// Closed meshes.
    pub meshes: Vec<MeshTally>,
    /// Inputs that are no ordinary numbers.
    pub spoilt: Vec<SpoiltTally>,
    /// What each kernel costs.
    pub speed: Vec<Speed>,
    /// Where each kernel breaks.
    pub breaking: Vec<Breaking>,
    /// Whole scenes.
    pub scenes: Vec<SceneTally>,
    /// Where a student's code, if it takes part, left questions without an answer, and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub problems: Vec<String>,
    /// What plans come to.
    pub plans: Vec<PlanTally>,
    /// What makes one way cheaper than another.
    pub crossovers: Vec<CrossoverTally>,
    /// What was promised or measured before, beside what came.
    pub targets: Vec<Target>,
}

/// Where, when and how a study was made.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Provenance {
    /// The processor.
    pub machine: String,
    /// UTC.
    pub date: String,
    /// The commit, with `+` behind it if the work tree differs.
    pub commit: String,
    /// What was typed.
    pub command: String,
    /// `quick` or `full`.
    pub mode: String,
    /// What random numbers come from.
    pub seed: u64,
    /// The compiler's target features that matter.
    pub features: String,
}

/// One family of questions about one shape, in one type of data.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Sweep {
    /// sphere, plane or triangle.
    pub shape: String,
    /// The family's name.
    pub family: String,
    /// What it shows.
    pub meaning: String,
    /// What x is.
    pub axis: String,
    /// The type its numbers are rounded to.
    pub data: String,
    /// The exponent that is easy.
    pub easy: i32,
    /// From small to large x.
    pub points: Vec<Point>,
}

/// One exponent of a sweep.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// x.
    pub exponent: i32,
    /// Of each kernel.
    pub kernels: Vec<Judged>,
}

/// One kernel's tally.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Judged {
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// What came of it.
    #[serde(flatten)]
    pub tally: Tally,
}

/// One kernel on closed meshes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MeshTally {
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// `edge` or `vertex`.
    pub aimed_at: String,
    /// Rays from inside; each leaves the mesh exactly once.
    pub rays: u64,
    /// Rays that hit nothing.
    pub leaks: u64,
    /// Rays that hit more than one triangle.
    pub double_hits: u64,
}

/// One kernel on inputs with one number that is no ordinary one.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SpoiltTally {
    /// sphere, plane or triangle.
    pub shape: String,
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// What was put in a number's place.
    pub spoiler: String,
    /// Questions.
    pub asked: u64,
    /// A hit although a number was no number, or infinite.
    pub hits_of_nothing: u64,
    /// Wrong decisions where all numbers are finite.
    pub wrong: u64,
    /// Hits whose t is infinite or NaN.
    pub not_finite: u64,
}

/// What one kernel costs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Speed {
    /// sphere, plane or triangle.
    pub shape: String,
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// CPU time for one ray and one shape: the median round.
    pub nanoseconds: f64,
    /// The difference of the quartiles over the median.
    pub spread: f64,
    /// Over the fastest kernel on the same type of data.
    pub ratio: f64,
    /// For one ray and one shape, by callgrind.
    pub instructions: Option<f64>,
}

/// Where one kernel breaks in one family.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Breaking {
    /// sphere, plane or triangle.
    pub shape: String,
    /// The family's name.
    pub family: String,
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// The first exponent above the easy one at which it is broken.
    pub above: Option<i32>,
    /// The first below.
    pub below: Option<i32>,
    /// Wrong decisions in the whole sweep.
    pub wrong: u64,
    /// Questions in the whole sweep.
    pub asked: u64,
    /// Of the faults, those that only overflow or underflow explains, and nothing shows.
    pub silent: u64,
    /// The largest median error of its points, in ulp.
    pub worst_median_ulp: Option<f64>,
}

/// One way to cast one whole scene.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct SceneTally {
    /// Its name.
    pub scene: String,
    /// `f32`, `f64 on f32`, `f64`, `exact`, or `Mitsuba` (the golden film, by rays of its
    /// own in `f32`).
    pub model: String,
    /// The set: `fastest`, `usual`, `steadiest`, or `adaptive`.
    pub kernels: Option<String>,
    /// `brute force` or `boxes`.
    pub search: Option<String>,
    /// Spheres, planes and triangles in the scene.
    pub parts: u64,
    /// Pixels that were asked.
    pub rays: u64,
    /// Pixels whose object is not the one that is truly seen.
    pub wrong_ids: u64,
    /// Median relative error of t, where the object is right.
    pub median_t: Option<f64>,
    /// The largest.
    pub worst_t: Option<f64>,
    /// The largest angle between a normal and the true one, in radians.
    pub worst_normal: Option<f64>,
    /// CPU time for a ray: the median film.
    pub nanoseconds: Option<f64>,
    /// Parts tested for a ray.
    pub tests: Option<f64>,
    /// Tests that a filter left open, and that were decided exactly.
    pub fallbacks: u64,
    /// Comparisons of t that were decided exactly.
    pub close_calls: u64,
    /// Whether no other way is as good in time, wrong objects, t and normal, and better in
    /// one of them.
    pub on_front: bool,
}

/// What so many parts of a kind cost, in nanoseconds of CPU time for a ray.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CrossoverTally {
    /// `spheres` or `triangles`.
    pub shape: String,
    /// `f32` (eight at a time), `f64` or `exact`.
    pub numbers: String,
    /// How many.
    pub parts: u64,
    /// If each is asked.
    pub brute_force: f64,
    /// If boxes are searched.
    pub boxes: f64,
}

/// One plan, and what came of it at the pixels of its scene.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct PlanTally {
    /// The scene's name.
    pub scene: String,
    /// The accuracy that was wished.
    pub accuracy: f64,
    /// Whether exact ids were wished.
    pub exact_ids: bool,
    /// What was chosen, in a few words.
    pub choice: String,
    /// Pixels that were judged.
    pub rays: u64,
    /// Of them, where t or the normal is off by more than was wished.
    pub violations: u64,
    /// Where another object is seen.
    pub wrong_ids: u64,
    /// The largest relative error of t.
    pub worst_t: f64,
    /// The largest angle between a normal and the true one, in radians.
    pub worst_normal: f64,
    /// Pixels that were uncertain in `f32` and cast again in `f64`.
    pub again_in_f64: u64,
    /// Pixels that were cast again exactly.
    pub again_exactly: u64,
    /// CPU time for a ray: the median film.
    pub nanoseconds: f64,
    /// The same for the most accurate way: every decision exact, and every t.
    pub most_accurate: f64,
    /// And for the least: the fastest kernels in `f32`, in the cheaper search.
    pub least_accurate: f64,
}

/// A figure that was promised or measured before, and the one measured now.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Target {
    /// What it is about.
    pub about: String,
    /// As it was written.
    pub expected: String,
    /// As it came.
    pub measured: String,
    /// Whether they agree.
    pub met: bool,
    /// Whether it is a time, which another machine or a busy one changes: to fall short in
    /// it is told, and is no fault of the run.
    pub is_time: bool,
}
