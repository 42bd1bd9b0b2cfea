//! What the command understands; the texts of `--help`.

mod golden;
mod instructor;
mod student;
#[cfg(feature = "study")]
mod study;

use clap::{Args, Parser, Subcommand};

pub use golden::*;
pub use instructor::*;
pub use student::*;
#[cfg(feature = "study")]
pub use study::*;

use crate::sandbox::Choice;
#[cfg(target_os = "linux")]
use crate::sandbox::confine::Confine;

/// Ray casting assignments, judged against golden films by Mitsuba.
///
/// Run `cargo run --release -- check --watch`, and fill the answers in
/// assignments/ray_casting/handout/src: each is judged when you save it.
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
    /// Make goldens with Mitsuba, or verify the committed ones
    #[command(subcommand)]
    Golden(Golden),
    /// Grade a class of submissions: marks, reports and a page of them all
    Grade(Grade),
    /// Put shards of a class that were graded apart together
    Merge(Merge),
    /// Generate the handout, students' stubs, from the reference, or their whole repository
    Handout(Handout),
    /// Grade the grading: does it catch every known mistake, and fail nobody who is right?
    #[cfg(feature = "validate")]
    Validate(Validate),
    /// Measure the trade between speed and accuracy, and the extremes
    #[cfg(feature = "study")]
    Study(Study),
    /// The cheapest way to cast a scene that is as accurate as you wish, and why
    #[cfg(feature = "study")]
    Plan(Plan),
    /// Build the book, or prove it
    Book(Book),
    /// Give up all rights and become a program: what sandboxes start first
    #[cfg(target_os = "linux")]
    #[command(hide = true)]
    Confine(Confine),
}

impl Command {
    /// Whether standard output is to be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Check(arguments) => arguments.json,
            Command::Render(arguments) => arguments.json,
            Command::Explain(arguments) => arguments.json,
            Command::Diff(arguments) => arguments.json,
            Command::Golden(Golden::Verify(arguments)) => arguments.json,
            #[cfg(feature = "validate")]
            Command::Validate(arguments) => arguments.json,
            #[cfg(feature = "study")]
            Command::Study(arguments) => arguments.json,
            #[cfg(feature = "study")]
            Command::Plan(arguments) => arguments.json,
            Command::Grade(arguments) => arguments.json,
            Command::Merge(arguments) => arguments.json,
            Command::Handout(arguments) => arguments.json,
            Command::Golden(_) | Command::Book(_) => false,
            #[cfg(target_os = "linux")]
            Command::Confine(_) => false,
        }
    }
}
/// How a submission's program is run.
#[derive(Args)]
pub struct Run {
    /// Seconds after which an answer no longer counts
    #[arg(long, value_name = "SECONDS", default_value_t = Run::TIMEOUT,
          value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub timeout: u64,
    /// Which walls the code runs behind
    #[arg(long, value_enum, value_name = "WALLS", default_value_t)]
    pub sandbox: Choice,
    /// Run a folder outside this checkout without a sandbox: your own code only
    /// (--sandbox none)
    #[arg(long, conflicts_with = "sandbox")]
    pub trust: bool,
}

impl Run {
    /// Seconds, unless the user says otherwise.
    pub const TIMEOUT: u64 = 30;

    /// Which walls the user has chosen.
    pub fn walls(&self) -> Choice {
        walls(self.trust, self.sandbox)
    }
}

fn walls(trust: bool, chosen: Choice) -> Choice {
    match trust {
        true => Choice::None,
        false => chosen,
    }
}
