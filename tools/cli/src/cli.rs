//! What the command understands; the texts of `--help`.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use pinhole::Resolution;
use pinhole_course::run_options::{AssignmentOption, RunOptions, resolution};

/// Computer graphics assignments, judged against golden films by Mitsuba.
///
/// Run `cargo pinhole check --watch`, and fill the answers in the folder
/// `handout/src` of the assignment: each is judged when you save it.
///
/// Exit codes: 0 all well; 1 judged wrong; 2 a file or an argument is wrong; 3 the
/// machine or this program is at fault.
#[derive(Parser)]
#[command(version, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Build a submission, ask it everything, and judge what it answers
    Check(Check),
    /// Cast a scene: writes film.exr, id.png, depth.png and normal.png
    Render(Render),
    /// One pixel in words: its ray, every candidate intersection, what was expected
    Explain(Explain),
    /// Judge any renderer's film against a golden, by both judges
    Diff(Diff),
}

impl Command {
    /// Whether standard output is to be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Check(arguments) => arguments.json,
            Command::Render(arguments) => arguments.json,
            Command::Explain(arguments) => arguments.json,
            Command::Diff(arguments) => arguments.json,
        }
    }
}

/// Build a submission, ask it everything, and judge what it answers.
///
/// Each task is asked alone, in groups of questions that Mitsuba has answered too;
/// then every scene is cast by all answers together. For each group and scene that
/// fails, the table says what was asked, what was expected and what came.
///
/// With --watch it stays, and judges an answer whenever you save it: one task at a
/// time, from the first with missing points on, then the scenes. Keys give a hint, go to
/// the next task, quit; ? tells them all. In a pipe, and with --json, which then prints
/// a document on each line, it tells every verdict as it comes, and ends when standard
/// input was a pipe and is closed, or with Ctrl-C. However it ends, the exit code is 0.
///
/// Only the six answer files are taken from the folder. A folder outside this
/// checkout is compiled and run in a sandbox.
///
/// A report of it all is written too, one HTML file to open in a browser: expected and
/// given pictures of every scene that fails, each pixel to click on, and hints.
#[derive(Args)]
pub struct Check {
    /// A folder with the answer files, itself or in `src` [default: the current folder
    /// if it is a submission, else the handout]
    pub dir: Option<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Stay, and judge an answer whenever it is saved
    #[arg(long, conflicts_with_all = ["scene", "oiiotool", "no_report"])]
    pub watch: bool,
    /// Only this task; may be given more than once
    #[arg(long, value_name = "TASK")]
    pub task: Vec<String>,
    /// Only this scene; may be given more than once
    #[arg(long, value_name = "SCENE")]
    pub scene: Vec<String>,
    /// Judge by the goldens in this folder
    #[arg(long, value_name = "DIR")]
    pub golden: Option<PathBuf>,
    /// Ask oiiotool, the second judge, about every film too
    #[arg(long)]
    pub oiiotool: bool,
    #[command(flatten)]
    pub run: RunOptions,
    /// Where to write the report, one HTML file [default: target/pinhole/report.html of
    /// the checkout]
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Write no report
    #[arg(long, conflicts_with = "report")]
    pub no_report: bool,
    /// Open the page of the book that helps with the first thing that is wrong
    #[arg(long, conflicts_with_all = ["json", "watch"])]
    pub read: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Cast a scene and write its film and three pictures.
///
/// film.exr holds id, t and normal per pixel; id.png, depth.png and normal.png show
/// them in false colour. Where a golden of the scene is committed, depth.png spans
/// the golden's depths, so that yours and the golden's can be compared.
#[derive(Args)]
pub struct Render {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// Whose answers cast [default: the current folder if it is a submission, else the
    /// reference, or the handout where there is none]
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Cast this many pixels instead of the scene's own; the image plane stays
    #[arg(long, value_name = "NXxNY", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "render")]
    pub out: PathBuf,
    #[command(flatten)]
    pub run: RunOptions,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// One pixel in words.
///
/// Shows the pixel's place on the image plane, its ray in camera space and in world
/// space, every object's own answer, the first hit, and, where a golden is
/// committed, what Mitsuba found. Try: cargo pinhole explain slide_example 2 3
#[derive(Args)]
pub struct Explain {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// Column, from the left, from 0
    pub i: usize,
    /// Row, from the bottom, from 0
    pub j: usize,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Whose answers to explain [default: the current folder if it is a submission,
    /// else the reference, or the handout where there is none]
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    #[command(flatten)]
    pub run: RunOptions,
    /// Open the page of the book on the answer that is wrong first
    #[arg(long, conflicts_with = "json")]
    pub read: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Judge any renderer's film against a golden.
///
/// The rule: same size, same channels, all finite, and at every pixel
/// |film − golden| ≤ tolerance in every channel, with the tolerance film that lies
/// beside the golden as NAME.tol.exr. The Rust judge rules; oiiotool, if it is
/// installed, is asked the same, and a disagreement is reported as our fault.
#[derive(Args)]
pub struct Diff {
    /// The golden film: NAME.exr, with NAME.tol.exr beside it
    pub golden: PathBuf,
    /// The film to judge
    pub film: PathBuf,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write pictures of what was expected, what came, and where they differ, and
    /// report.html, which shows both films pixel by pixel
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Where to write the report [default: report.html in the folder of --out]
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// The scene that was cast, so that the report can name its objects: a scene file,
    /// or the name of one of the assignment's scenes [default: the one whose golden this is]
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}
