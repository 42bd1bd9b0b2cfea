//! What instructors ask for: a class's grades, a course to hand out, goldens, and a check
//! of all that.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::sandbox::Choice;

use crate::golden::arguments::Golden;
use crate::grade::redact::Reveal;
use crate::grade::views::formats::Format;
use crate::validate::Part;

/// What instructors do with Pinhole: grade, hand out, make goldens, validate.
///
/// Exit codes: 0 all well; 1 judged wrong; 2 a file or an argument is wrong; 3 the
/// machine or this program is at fault.
#[derive(Parser)]
#[command(name = "pinhole", bin_name = "pinhole", version, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
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
    Validate(Validate),
}

impl Command {
    /// Whether standard output is to be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Golden(Golden::Verify(arguments)) => arguments.json,
            Command::Golden(_) => false,
            Command::Grade(arguments) => arguments.json,
            Command::Merge(arguments) => arguments.json,
            Command::Handout(arguments) => arguments.json,
            Command::Validate(arguments) => arguments.json,
        }
    }
}

/// Grade a class of submissions.
///
/// Each path is a submission, a folder or a zip archive with the answer files, or a folder
/// of submissions. For each, a result and a report are written to DIR/submissions; for the
/// class, DIR/grades.csv and DIR/class.html. Foreign code runs in a sandbox.
///
/// Whatever is finished is kept: killed at any moment and run again, this goes on, and
/// grades again only what has changed. A fault of the grader's is nobody's zero: such a
/// submission has no mark, is listed first, and the exit code is 3.
///
/// If Mitsuba is installed, questions from a fresh seed are asked too, the same of the
/// whole class: a group of questions earns its points only if it passes both, and scenes
/// earn no more than the larger of what fresh scenes earn and the tasks' share of their
/// points.
#[derive(Args)]
pub struct Grade {
    /// Submissions, and folders of submissions
    #[arg(required = true, value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Where results are written, and kept for the next time
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// How many submissions to grade at a time [default: one for each core]
    #[arg(long, value_name = "N")]
    pub jobs: Option<usize>,
    /// Judge by the goldens in this folder, which stay withheld from students; such as
    /// `golden render my.toml --out DIR` makes
    #[arg(long, value_name = "DIR")]
    pub golden: Option<PathBuf>,
    /// What results and reports show of withheld and fresh questions
    #[arg(long, value_enum, default_value_t)]
    pub reveal: Reveal,
    /// The seed of fresh questions [default: that of DIR/fresh, or else a random one]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Fresh questions that were made before, by `golden render --seed N --out DIR`
    #[arg(long, value_name = "DIR", conflicts_with = "seed")]
    pub fresh: Option<PathBuf>,
    /// Ask the known questions only
    #[arg(long, conflicts_with_all = ["seed", "fresh"])]
    pub no_fresh: bool,
    /// A CSV file with a first line `id,name,section`: who should have handed in
    #[arg(long, value_name = "CSV")]
    pub roster: Option<PathBuf>,
    /// Another format to write results in; may be given more than once
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Vec<Format>,
    /// Grade everything again, and list each mark that changes, drops first
    #[arg(long)]
    pub regrade: bool,
    /// Grade only part K of N, for `pinhole merge`
    #[arg(long, value_name = "K/N", value_parser = shard)]
    pub shard: Option<(usize, usize)>,
    /// Seconds of processor time that each task and scene has at least; never less than a
    /// hundred times what the reference takes. Late is only what is late again, alone
    #[arg(long, value_name = "SECONDS", default_value_t = 4,
          value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub timeout: u64,
    /// Which walls the code runs behind, wherever it lies; `auto` is bubblewrap
    #[arg(long, value_enum, value_name = "WALLS", default_value_t)]
    pub sandbox: Choice,
    /// Run without a sandbox, as every result says: your own code only (--sandbox none)
    #[arg(long, conflicts_with = "sandbox")]
    pub trust: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

impl Grade {
    /// Which walls the user has chosen.
    pub fn walls(&self) -> Choice {
        match self.trust {
            true => Choice::None,
            false => self.sandbox,
        }
    }
}

/// Put shards of a class together: the --out folders of `grade --shard K/N`, all of the
/// same paths, roster and goldens. What comes is what grading all at once had given.
#[derive(Args)]
pub struct Merge {
    /// The shards' folders
    #[arg(required = true, value_name = "DIR")]
    pub shards: Vec<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Where the whole class is written
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Another format to write results in; may be given more than once
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Vec<Format>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Generate the handout from the reference, or a whole repository for students.
///
/// Signatures and documentation stay, answers become `todo!`. Everything else is
/// copied as it is.
///
/// With --out, a repository of its own is made around the stubs: the harness, this
/// command, the public scenes and their goldens, tests, a README and a workflow for
/// GitHub. It needs Rust and nothing else, and holds no answer of ours, no source of a
/// mistake or a variant, and nothing of a scene that says `public = false`.
#[derive(Args)]
pub struct Handout {
    /// The assignment
    #[arg(value_name = "ASSIGNMENT", conflicts_with = "name")]
    pub positional: Option<String>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Change nothing; fail if the committed handout is out of step
    #[arg(long, conflicts_with_all = ["out", "gradescope"])]
    pub check: bool,
    /// Write a student's repository here; the folder must be new or empty
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Put this built book into the repository, as `book/`: the students' edition that
    /// `book build` makes in book/build/student
    #[arg(long, value_name = "DIR", requires = "out")]
    pub book: Option<PathBuf>,
    /// Replace what an earlier run wrote to DIR; a file that was changed since is never
    /// touched, and then nothing is
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Write an autograder for Gradescope here, for instructors alone: it holds all
    /// goldens and our answers
    #[arg(long, value_name = "FILE.zip")]
    pub gradescope: Option<PathBuf>,
    /// Put these fresh questions into the autograder, as `golden render --seed N --out DIR`
    /// makes them: public goldens alone could be memorised
    #[arg(long, value_name = "DIR", requires = "gradescope")]
    pub fresh: Option<PathBuf>,
    /// What the autograder shows of withheld and fresh questions
    #[arg(long, value_enum, default_value_t, requires = "gradescope")]
    pub reveal: Reveal,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Grade the grading.
///
/// Everything whose verdict is known beforehand goes down the same path as a student's
/// answers, and the verdicts are compared with what is known:
///
/// - the stub is unanswered, the reference and every variant pass;
/// - every known mistake fails in exactly the tasks that it declares, and so does its
///   rewrite, which starts from another algorithm;
/// - with --mutants: of the reference with one small fault each (a sign, a comparison, a
///   constant, a vector for its neighbour, …) none that compiles passes, unless
///   equivalent.toml lists it and a search for differences agrees.
///
/// The tables say for each group of questions and each scene how many mistakes it catches
/// and how many only it does, and what the smallest error is that each scene detects.
/// Exit 0 if every target is met; otherwise 1, and what misses one comes first.
#[derive(Args)]
pub struct Validate {
    /// The assignment: its name, or its folder
    #[arg(value_name = "ASSIGNMENT", conflicts_with = "name")]
    pub positional: Option<String>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write mutants of the reference, and judge them too: some 600, a minute or two
    #[arg(long)]
    pub mutants: bool,
    /// Only this part; may be given more than once
    #[arg(long, value_name = "PART")]
    pub only: Vec<Part>,
    /// Only what has this in its name, as `mistakes/sphere_`, `variants/`, `triangle.rs:26:`
    /// (a mutant) or `bunny`
    #[arg(long, value_name = "TEXT")]
    pub named: Option<String>,
    /// Ask oiiotool, the second judge, about every film too
    #[arg(long)]
    pub oiiotool: bool,
    /// Judge so many at a time [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Part K of N, from 1.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    parts
        .filter(|(k, n)| (1..=*n).contains(k))
        .ok_or_else(|| format!("`{text}` is no part like 2/8"))
}
