//! What the study's program understands; the texts of `--help`.

use std::path::PathBuf;

use clap::{ArgGroup, Args, Parser, Subcommand, ValueEnum};
use pinhole::Resolution;
use pinhole_course::run_options::{AssignmentOption, RunOptions, resolution};
use pinhole_study::plan::Wish;

/// The trade between speed and accuracy in ray casting.
///
/// Exit codes: 0 all well; 1 measured otherwise than promised; 2 a file or an argument is
/// wrong; 3 the machine or this program is at fault.
#[derive(Parser)]
#[command(name = "pinhole", bin_name = "pinhole", version, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Measure the trade between speed and accuracy, and the extremes
    Study(Study),
    /// The cheapest way to cast a scene that is as accurate as you wish, and why
    Plan(Plan),
    /// Cast a scene exactly, or as planned
    Render(Render),
    /// Ask exact casting as many questions as there is time for, and print what came
    Record(Record),
    /// Cast one kernel's workload: what runs under callgrind
    #[command(hide = true)]
    Cast {
        shape: String,
        kernel: usize,
        casts: u32,
    },
}

impl Command {
    /// Whether standard output is to be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Study(arguments) => arguments.json,
            Command::Plan(arguments) => arguments.json,
            Command::Render(arguments) => arguments.json,
            Command::Record(_) | Command::Cast { .. } => false,
        }
    }
}

/// Measure the trade between speed and accuracy, and the extremes.
///
/// Many ways to intersect a sphere, a plane and a triangle are asked the same questions,
/// which get harder step by step, and are judged by exact arithmetic; then every scene is
/// cast, and every pixel judged. Writes study.json, summary.md and plots; prints what was
/// measured before, or promised, beside what came. Exit 0 if all of that agrees but for
/// times, which depend on the machine; otherwise 1.
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
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "study")]
    pub out: PathBuf,
    /// Only this family of questions (distance, surface, …), or crossover, mesh, plans, scenes,
    /// spoilt or speed
    #[arg(long, value_name = "FAMILY")]
    pub only: Option<String>,
    /// What random questions come from
    #[arg(long, value_name = "N", default_value_t = 20_261_121)]
    pub seed: u64,
    #[command(flatten)]
    pub run: RunOptions,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// The cheapest way to cast a scene that is as accurate as you wish, and why.
///
/// Says for spheres, planes and triangles whether f32 will do, or f64, or exact arithmetic,
/// from bounds of what rounding does in this very scene, and whether boxes around the
/// parts pay. Then it casts some of the rays so and judges them by exact arithmetic: what
/// that refuses is planned anew. Try: cargo pinhole plan bunny --accuracy 1e-6
#[derive(Args)]
pub struct Plan {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    #[command(flatten)]
    pub assignment: AssignmentOption,
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

/// Cast a scene by the study's own casters, and write its film and three pictures.
///
/// film.exr holds id, t and normal per pixel; id.png, depth.png and normal.png show
/// them in false colour. Where a golden of the scene is committed, depth.png spans
/// the golden's depths, so that yours and the golden's can be compared.
#[derive(Args)]
#[command(group = ArgGroup::new("caster").required(true).args(["exact", "plan"]))]
pub struct Render {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Cast by the exact caster, whose objects are never wrong, whatever the scene: what
    /// rounding leaves open is decided by exact arithmetic, and it is told how often.
    /// Exact for the rays as rounded to f64
    #[arg(long)]
    pub exact: bool,
    /// Cast by the cheapest way that keeps t and normals to this accuracy, as `pinhole plan`
    /// chooses it
    #[arg(long, value_name = "X", value_parser = accuracy)]
    pub plan: Option<f64>,
    #[command(flatten)]
    pub wanted: Wanted,
    /// Cast this many pixels instead of the scene's own; the image plane stays
    #[arg(long, value_name = "NXxNY", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "render")]
    pub out: PathBuf,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Ask exact casting as many questions as there is time for, and print what came.
///
/// The promise is for 100 million random and 10 million adversarial questions, and
/// 500 million rays at edges and as many at vertices: about two hours of a core.
#[derive(Args)]
pub struct Record {
    /// Everyday questions
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    pub random: u64,
    /// Questions at the extremes
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    pub adversarial: u64,
    /// Rays at edges, and as many at vertices, of closed meshes
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    pub edges: u64,
    /// What random questions come from
    #[arg(long, value_name = "N", default_value_t = 20_261_121)]
    pub seed: u64,
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
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Ids {
    /// As rounding has them
    Rounded,
    /// As they truly are, at every pixel
    Exact,
}

/// What is worked out for a pixel.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Output {
    /// The object
    Id,
    /// t
    Depth,
    /// The unit normal
    Normal,
}

fn accuracy(text: &str) -> Result<f64, String> {
    let accuracy = text.parse().ok().filter(|x| (1e-15..=1.0).contains(x));
    accuracy.ok_or_else(|| format!("`{text}` is no accuracy between 1e-15 and 1, like 1e-6"))
}

impl Wanted {
    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.ids.is_none() && self.outputs.is_empty()
    }

    /// What the user wishes of a plan; unless they say otherwise, everything, with objects
    /// as rounding has them.
    pub fn wish(&self, accuracy: f64) -> Wish {
        let wants = |output| self.outputs.is_empty() || self.outputs.contains(&output);
        Wish {
            accuracy,
            exact_ids: self.ids == Some(Ids::Exact),
            depth: wants(Output::Depth),
            normal: wants(Output::Normal),
        }
    }
}
