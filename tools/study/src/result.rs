//! What a study found, as it is written to `study.json`: `tools/schema/study.schema.json`
//! says the same to other programs.

use serde::Serialize;

use crate::judge::Tally;
use crate::kernel::Tier;
use crate::question::Class;

/// The version of the document; it changes when a field changes its meaning.
pub const SCHEMA: &str = "pinhole-study/3";

/// One run of the instrument.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Study {
    /// [`SCHEMA`].
    pub schema: String,
    /// Where, when and how.
    pub provenance: Provenance,
    /// What was found.
    #[serde(flatten)]
    pub findings: Findings,
    /// What was promised or measured before, beside what came.
    pub targets: Vec<Target>,
}

/// What a run finds, before it is judged itself.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Findings {
    /// The sweeps.
    pub families: Vec<Sweep>,
    /// Closed meshes.
    pub meshes: Vec<MeshTally>,
    /// What each kernel costs, and what it gets wrong, by class.
    pub trades: Vec<Trade>,
    /// The tiers of the exact kernels.
    pub tiers: Vec<TierTally>,
    /// Errors of t against the question's conditioning.
    pub conditioning: Vec<ConditioningErrors>,
    /// Rays that begin on a surface.
    pub secondary: Vec<Secondary>,
    /// Where each kernel breaks.
    pub breaking: Vec<BreakingPoint>,
    /// Whole scenes.
    pub scenes: Vec<SceneTally>,
    /// What plans come to.
    pub plans: Vec<PlanTally>,
}

/// Where, when and how a study was made.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
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
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
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
    /// From small to large x.
    pub points: Vec<Point>,
}

/// One exponent of a sweep.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Point {
    /// x.
    pub exponent: i32,
    /// How far from the ordinary its questions are.
    pub class: Class,
    /// Of each kernel.
    pub kernels: Vec<KernelTally>,
}

/// One kernel's tally.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct KernelTally {
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// What came of it.
    #[serde(flatten)]
    pub tally: Tally,
}

/// One kernel on closed meshes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
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

/// One kernel on one class of questions about one shape: what it costs, and what it gets
/// wrong. Costs are those of an even sample of the questions that are judged.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Trade {
    /// sphere, plane or triangle.
    pub shape: String,
    /// How far from the ordinary the questions are.
    pub class: Class,
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// Questions that count.
    pub asked: u64,
    /// Wrong decisions.
    pub wrong: u64,
    /// Hits whose t is infinite or NaN.
    pub not_finite: u64,
    /// The median error of t, in ulp.
    pub median_ulp: Option<f64>,
    /// The largest.
    pub worst_ulp: Option<f64>,
    /// CPU time for one ray and one shape: the median round.
    pub nanoseconds: Option<f64>,
    /// Half the width of the median's 95 % confidence interval, over the median.
    pub spread: Option<f64>,
    /// For one ray and one shape, by callgrind.
    pub instructions: Option<f64>,
}

/// One tier of an exact kernel in `f64`: how often it has the last word, and what a question
/// costs then, the tiers before it included.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TierTally {
    /// sphere, plane or triangle.
    pub shape: String,
    /// Of the questions.
    pub class: Class,
    /// Which.
    pub tier: Tier,
    /// Questions it decided.
    pub decided: u64,
    /// Of so many.
    pub asked: u64,
    /// CPU time for a question that it decides.
    pub nanoseconds: f64,
    /// The same in instructions, by callgrind.
    pub instructions: Option<f64>,
}

/// One kernel's errors of t where questions are about as sensitive to their own numbers:
/// everyday and hard ones.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ConditioningErrors {
    /// sphere, plane or triangle.
    pub shape: String,
    /// Its name.
    pub kernel: String,
    /// What it computes with.
    pub numbers: String,
    /// The condition number is from 10^`decade` to ten times as much.
    pub decade: i32,
    /// True hits that were answered with a finite t.
    pub hits: u64,
    /// The median error of t, in ulp.
    pub median_ulp: f64,
    /// The largest.
    pub worst_ulp: f64,
}

/// Where one kernel breaks in one family.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BreakingPoint {
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
}

/// One way to cast one whole scene.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SceneTally {
    /// Its name.
    pub scene: String,
    /// `f64`, `exact`, or `Mitsuba` (the golden film, by rays of its own in `f32`).
    pub model: String,
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
    /// Instructions for a ray of a film, by callgrind.
    pub instructions: Option<f64>,
    /// Parts tested for a ray.
    pub tests: Option<f64>,
    /// Tests that the static filter left open.
    pub semi_static: u64,
    /// Tests that both filters left open: of triangles, decided in double-double first.
    pub double_double: u64,
    /// Tests that were decided exactly.
    pub exact: u64,
    /// Comparisons of t that were decided exactly.
    pub close_calls: u64,
}

/// Rays that begin where another met a surface, moved off it by one method, all in `f32`.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Secondary {
    /// sphere or triangle.
    pub shape: String,
    /// How the origin is moved.
    pub method: String,
    /// The distance of the scene from the world's origin, in sizes of the surface.
    pub offset: f64,
    /// Rays that leave the surface and do not come back.
    pub leaving: u64,
    /// Of them, those that meet the surface they leave: dark specks in shadows.
    pub self_hits: u64,
    /// Rays at a surface that lies a thousandth of the size away.
    pub near: u64,
    /// Of them, those that miss it: light that leaks.
    pub lost: u64,
}

/// What the oracle says of a planned film.
#[derive(Clone, Copy, Debug, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PlanErrors {
    /// Rays that were judged.
    pub rays: u64,
    /// Whose object is not the one truly seen.
    pub wrong_ids: u64,
    /// Where t or the normal is off by more than is wished.
    pub violations: u64,
    /// The largest relative error of t.
    pub worst_t: f64,
    /// The largest angle between a normal and the true one, in radians.
    pub worst_normal: f64,
}

/// One plan, and what came of it at the pixels of its scene.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PlanTally {
    /// The scene's name.
    pub scene: String,
    /// The accuracy that was wished.
    pub accuracy: f64,
    /// What the oracle says of its film.
    #[serde(flatten)]
    pub kept: PlanErrors,
    /// Pixels whose t and normal were computed exactly.
    pub exact_hits: u64,
    /// CPU time for a ray: the median film.
    pub nanoseconds: f64,
    /// The same for exact objects, and t and normals as they come.
    pub exact_ids: f64,
    /// And for plain `f64`.
    pub plain: f64,
}

/// A figure that was promised or measured before, and the one measured now.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
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

#[cfg(test)]
#[test]
fn the_committed_schema_is_that_of_the_type() {
    use schemars::generate::SchemaSettings;
    let generator = SchemaSettings::draft2020_12().into_generator();
    let schema = generator.into_root_schema_for::<Study>();
    let text = serde_json::to_string_pretty(&schema).expect("it can be written") + "\n";
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../schema/study.schema.json");
    if std::env::var_os("UPDATE_SCHEMAS").is_some() {
        std::fs::write(path, &text).expect("it can be written");
    }
    let committed = std::fs::read_to_string(path).unwrap_or_default();
    let again = "UPDATE_SCHEMAS=1 cargo test -p pinhole-study schema";
    assert_eq!(committed, text, "if this is meant, run: {again}");
}
