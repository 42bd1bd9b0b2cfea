//! What the study's package does, which this command runs.

use std::path::PathBuf;

use clap::Args;
use pinhole::Resolution;

use super::Run;
use super::student::resolution;

/// Measure the trade between speed and accuracy, and the extremes.
///
/// Many ways to intersect a sphere, a plane and a triangle are asked the same questions,
/// which get harder step by step, and are judged by exact arithmetic; then every scene is
/// cast, and every pixel judged. Writes study.json, summary.md and plots; prints what was
/// measured before, or promised, beside what came. Exit 0 if all of that agrees but for
/// times, which depend on the machine; otherwise 1. The first run compiles the study, which
/// nothing else needs.
#[derive(Args)]
pub struct Study {
    /// Ask fewer questions: less than a minute
    #[arg(long)]
    pub quick: bool,
    /// Put these answers among the kernels, by the questions of --quick: their sphere,
    /// plane and triangle through the extremes, all six through the scenes. Nothing of it
    /// is graded
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "study")]
    pub out: PathBuf,
    /// Only this family of questions (distance, surface, …), or crossover, mesh, plans, scenes,
    /// spoilt or speed
    #[arg(long, value_name = "FAMILY")]
    pub only: Option<String>,
    #[command(flatten)]
    pub run: Run,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// The cheapest way to cast a scene that is as accurate as you wish, and why.
///
/// Says for spheres, planes and triangles whether f32 will do, or f64, or exact arithmetic,
/// from bounds of what rounding does in this very scene, and whether boxes around the
/// parts pay. Then it casts some of the rays so and judges them by exact arithmetic: what
/// that refuses is planned anew. Try: cargo run --release -- plan bunny --accuracy 1e-6
#[derive(Args)]
pub struct Plan {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// The largest relative error of t, and the largest angle between a normal and the true
    /// one, in radians
    #[arg(long, value_name = "X", value_parser = accuracy)]
    pub accuracy: f64,
    #[command(flatten)]
    pub wanted: Wanted,
    /// Plan for this many pixels instead of the scene's own
    #[arg(long, value_name = "NXxNY", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// What is wanted of a planned film.
#[derive(Args)]
pub struct Wanted {
    /// With a plan: whether a pixel may show another object where rounding decides
    /// [default: rounded]
    #[arg(long, value_enum, value_name = "IDS")]
    pub ids: Option<Ids>,
    /// With a plan: what is worked out for a pixel; the rest is 0 in the film [default:
    /// id,depth,normal]
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',')]
    pub outputs: Vec<Output>,
}

/// Which objects a planned film shows.
#[derive(Clone, Copy, clap::ValueEnum)]
pub enum Ids {
    /// As rounding has them
    Rounded,
    /// As they truly are, at every pixel
    Exact,
}

/// What is worked out for a pixel.
#[derive(Clone, Copy, clap::ValueEnum)]
pub enum Output {
    /// The object
    Id,
    /// t
    Depth,
    /// The unit normal
    Normal,
}

pub(super) fn accuracy(text: &str) -> Result<f64, String> {
    let accuracy = text.parse().ok().filter(|x| (1e-15..=1.0).contains(x));
    accuracy.ok_or_else(|| format!("`{text}` is no accuracy between 1e-15 and 1, like 1e-6"))
}
