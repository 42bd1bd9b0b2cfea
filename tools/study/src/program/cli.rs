//! The command line of the study's program, and the text of its `--help`.

use std::path::PathBuf;

use clap::{ArgGroup, Args, Parser, Subcommand};
use pinhole::Resolution;
use pinhole_course::run_options::{AssignmentOption, resolution};
use pinhole_study::extent::{Extent, Part};
use pinhole_study::plan::FINEST;
use pinhole_study::record::Kind;

/// Measures speed and accuracy in ray casting, and casts scenes as accurately as you ask for.
///
/// Exit codes: 0 if everything is right; 1 if a promise is not kept; 2 if a file or an argument is
/// wrong; 3 if something is missing on this machine, or Pinhole has a bug.
#[derive(Parser)]
#[command(name = "pinhole", bin_name = "pinhole", version, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    Study(Study),
    Plan(Plan),
    Render(Render),
    Record(Record),
    /// Cast one kernel's workload, or a scene: what runs under callgrind
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

/// Measure how fast and how accurate different ways to cast rays are
///
/// There are several ways to intersect a sphere, a plane or a triangle. The study tries each way on
/// the same questions, which get harder step by step, and judges the answers with exact arithmetic.
/// Everyday, hard and absurd questions are counted separately. Then the study renders every scene
/// and judges every pixel.
///
/// Writes study.json, summary.md and plots, and prints what Pinhole promises beside what was
/// measured. The exit code is 0 if all promises about accuracy are kept, and otherwise 1. Promises
/// about speed don't change it, because speed depends on the machine.
#[derive(Args)]
pub struct Study {
    /// Ask fewer questions, which takes less than a minute
    #[arg(long)]
    pub quick: bool,
    /// Write the files to this folder
    #[arg(long, value_name = "DIR", default_value = "study")]
    pub out: PathBuf,
    /// Run only this part
    #[arg(long, value_enum, value_name = "PART")]
    pub only: Option<Part>,
    /// The seed of random questions
    #[arg(long, value_name = "N", default_value_t = Extent::FULL.seed)]
    pub seed: u64,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Find the fastest way to render a scene's film with a given accuracy, and explain the choice
///
/// This way is called a plan. A film that is rendered by a plan shows the true object at every
/// pixel. Normals and the rays' parameters t at the hits are as accurate as you ask for. (The
/// exception is a t below 2e-308 or above 1.7e308, where f64 has fewer digits or none. A file of a
/// film keeps only 7 digits, and numbers from 1e-38 to 3e38.) The accuracy is proven for every
/// camera ray, not estimated from samples. For each kind of shape, the output says how accurate f64
/// arithmetic is, and which hits must be checked and perhaps computed exactly. It also says whether
/// a bounding volume hierarchy is worthwhile. The same scene and options always give the same plan.
///
/// Try: cargo pinhole plan bunny --accuracy 1e-6
#[derive(Args)]
pub struct Plan {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// The largest relative error allowed in t, and also the largest angle allowed between a normal
    /// and the true one, in radians
    #[arg(long, value_name = "X", value_parser = accuracy)]
    pub accuracy: f64,
    /// Plan for this resolution instead of the scene's
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Render a scene exactly, or by a plan, and write its film and three pictures
///
/// film.exr holds the id, t and normal of each pixel. id.png, depth.png and normal.png show them in
/// false colours. If Mitsuba has rendered the scene, depth.png uses the same colours for the same
/// depths as Mitsuba's picture.
#[derive(Args)]
#[command(group = ArgGroup::new("caster").required(true).args(["exact", "plan"]))]
pub struct Render {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Use the exact caster, which never shows a wrong object and keeps t and normals accurate to
    /// 1e-12. If rounding leaves a decision open, exact arithmetic decides, and the output says how
    /// often that happened. A ray that meets a triangle's edge hits the triangle. Before the rays
    /// are cast, they are rounded to f64. The film's file keeps only 7 digits, and numbers from 1e-38
    /// to 3e38
    #[arg(long)]
    pub exact: bool,
    /// Use the fastest plan that is proven to keep t and normals as accurate as ACCURACY, a number
    /// such as 1e-6; `pinhole plan` explains it
    #[arg(long, value_name = "ACCURACY", value_parser = accuracy)]
    pub plan: Option<f64>,
    /// Render this many pixels instead of the scene's own number; the image plane keeps its size
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Write the files to this folder
    #[arg(long, value_name = "DIR", default_value = "render")]
    pub out: PathBuf,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Test exact casting with as many random questions as you have time for
///
/// Questions come in rounds, and each line of the output summarises some rounds. A round depends
/// only on its number and the seed, so you can resume a stopped run: pass the number of the next
/// round with --from.
#[derive(Args)]
pub struct Record {
    /// What to ask. In a round, `random` and `adversarial` ask 500 questions at each step of each
    /// family, `edges` casts 1,000 rays, and `plans` renders a scene of 64 pixels
    #[arg(value_enum)]
    pub kind: Kind,
    /// Begin with this round
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub from: u64,
    /// Run this many rounds
    #[arg(long, value_name = "N", default_value_t = 1_000)]
    pub rounds: u64,
    /// The seed of random questions
    #[arg(long, value_name = "N", default_value_t = Extent::FULL.seed)]
    pub seed: u64,
}

fn accuracy(text: &str) -> Result<f64, String> {
    let accuracy = text.parse().ok().filter(|x| (FINEST..=1.0).contains(x));
    accuracy.ok_or_else(|| {
        format!("`{text}` is not an accuracy between {FINEST:e} and 1, such as 1e-6")
    })
}
