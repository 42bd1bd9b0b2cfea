//! What the command understands; the texts of `--help`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use pinhole::Resolution;
use pinhole::scene::MOST_PIXELS;

use crate::grade::formats::Format;
use crate::grade::withheld::Reveal;
use crate::sandbox::Choice;
#[cfg(target_os = "linux")]
use crate::sandbox::confine::Confine;
#[cfg(feature = "validate")]
use crate::validate::Part;

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
    pub run: Run,
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
    /// Cast this many pixels instead of the scene's own; the image plane stays
    #[arg(long, value_name = "NXxNY", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Cast by the study's exact caster, whose objects are never wrong, whatever the scene:
    /// what rounding leaves open is decided by exact arithmetic, and it is told how often.
    /// Exact for the rays as rounded to f64. The first run compiles the study
    #[cfg(feature = "study")]
    #[arg(long, conflicts_with = "submission")]
    pub exact: bool,
    /// Cast by the cheapest way that keeps t and normals to this accuracy, as `pinhole plan`
    /// chooses it. The first run compiles the study
    #[cfg(feature = "study")]
    #[arg(long, value_name = "X", value_parser = accuracy, conflicts_with_all = ["submission", "exact"])]
    pub plan: Option<f64>,
    #[cfg(feature = "study")]
    #[command(flatten)]
    pub wanted: Wanted,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "render")]
    pub out: PathBuf,
    #[command(flatten)]
    pub run: Run,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// One pixel in words.
///
/// Shows the pixel's place on the image plane, its ray in camera space and in world
/// space, every object's own answer, the first hit, and, where a golden is
/// committed, what Mitsuba found. Try: cargo run --release -- explain slide_example 2 3
#[derive(Args)]
pub struct Explain {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// Column, from the left, from 0
    pub i: usize,
    /// Row, from the bottom, from 0
    pub j: usize,
    /// Whose answers to explain [default: the current folder if it is a submission,
    /// else the reference, or the handout where there is none]
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    #[command(flatten)]
    pub run: Run,
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

#[derive(Subcommand)]
pub enum Golden {
    /// Make the Python environment with the pinned Mitsuba and oiiotool
    Setup,
    /// Render goldens with Mitsuba
    Render(GoldenRender),
    /// Cast the known mistakes on goldens that are there, for diagnoses
    Mistakes(GoldenMistakes),
    /// Check that goldens, scenes, scripts and manifest belong together
    Verify(GoldenVerify),
}

/// Render goldens with Mitsuba: a film and a tolerance film for each scene, the same
/// for its viewing rays, and a manifest of what they were made from. Then the known
/// mistakes cast the same, and what each does to every film is kept for diagnoses.
///
/// Without scenes, all of the assignment's are made, and its probes, into `golden/`.
/// A scene is refused if a pixel centre lies on an edge, or if a ray meets a plane
/// too far out: shift its camera a little.
#[derive(Args)]
pub struct GoldenRender {
    /// Scene files, or names of the assignment's scenes
    pub scenes: Vec<String>,
    /// Where to write [default: golden/ray_casting for the assignment's own scenes]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Make fresh probes and random scenes from this seed instead; needs --out
    #[arg(long, value_name = "N", conflicts_with = "scenes", requires = "out")]
    pub seed: Option<u64>,
    /// Leave out the known mistakes' films: sooner done, but nothing will be diagnosed
    #[arg(long)]
    pub no_mistakes: bool,
}

/// Cast the known mistakes on goldens that are there, and keep beside them what each
/// does to every film: by that, `check` and `diff` know a mistake when they see it.
///
/// `golden render` does the same; this is for when only a mistake has changed. Needs no
/// Mitsuba.
#[derive(Args)]
pub struct GoldenMistakes {
    /// The folder of goldens [default: golden/ray_casting]
    pub dir: Option<PathBuf>,
}

/// Check that goldens, scenes, scripts and manifest belong together.
#[derive(Args)]
pub struct GoldenVerify {
    /// The folder of goldens [default: golden/ray_casting]
    pub dir: Option<PathBuf>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
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
        walls(self.trust, self.sandbox)
    }
}

/// Put shards of a class together: the --out folders of `grade --shard K/N`, all of the
/// same paths, roster and goldens. What comes is what grading all at once had given.
#[derive(Args)]
pub struct Merge {
    /// The shards' folders
    #[arg(required = true, value_name = "DIR")]
    pub shards: Vec<PathBuf>,
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
    #[arg(default_value = "ray_casting")]
    pub assignment: String,
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

/// Build the book, or prove it.
///
/// `build` makes both editions, the students' without solutions, in book/build. `check`
/// makes them and looks for whatever is not so: listings, links, figures, what commands
/// print, spelling. The book's own package does both, so that students need not build it;
/// `book build --help` tells the rest.
#[derive(Args)]
#[command(disable_help_flag = true)]
pub struct Book {
    /// build or check, and what it is to be told
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    pub arguments: Vec<OsString>,
}

/// Grade the grading.
///
/// Everything whose verdict is known beforehand goes down the same path as a student's
/// answers, and the verdicts are compared with what is known:
///
/// - the stub is unanswered, the reference and every variant pass;
/// - every known mistake fails in exactly the tasks that it declares, and so does the same
///   belief written anew;
/// - with --mutants: of the reference with one small fault each (a sign, a comparison, a
///   constant, a vector for its neighbour, …) none that compiles passes, unless
///   equivalent.toml lists it and a search for differences agrees.
///
/// The tables say for each group of questions and each scene how many mistakes it catches
/// and how many only it does, and what the smallest error is that each scene detects.
/// Exit 0 if every target is met; otherwise 1, and what misses one comes first.
#[cfg(feature = "validate")]
#[derive(Args)]
pub struct Validate {
    /// The assignment: its name, or its folder
    #[arg(default_value = "ray_casting")]
    pub assignment: String,
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

/// Measure the trade between speed and accuracy, and the extremes.
///
/// Many ways to intersect a sphere, a plane and a triangle are asked the same questions,
/// which get harder step by step, and are judged by exact arithmetic; then every scene is
/// cast, and every pixel judged. Writes study.json, summary.md and plots; prints what was
/// measured before, or promised, beside what came. Exit 0 if all of that agrees but for
/// times, which depend on the machine; otherwise 1. The first run compiles the study, which
/// nothing else needs.
#[cfg(feature = "study")]
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
#[cfg(feature = "study")]
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
#[cfg(feature = "study")]
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
#[cfg(feature = "study")]
#[derive(Clone, Copy, clap::ValueEnum)]
pub enum Ids {
    /// As rounding has them
    Rounded,
    /// As they truly are, at every pixel
    Exact,
}

/// What is worked out for a pixel.
#[cfg(feature = "study")]
#[derive(Clone, Copy, clap::ValueEnum)]
pub enum Output {
    /// The object
    Id,
    /// t
    Depth,
    /// The unit normal
    Normal,
}

#[cfg(feature = "study")]
fn accuracy(text: &str) -> Result<f64, String> {
    let accuracy = text.parse().ok().filter(|x| (1e-15..=1.0).contains(x));
    accuracy.ok_or_else(|| format!("`{text}` is no accuracy between 1e-15 and 1, like 1e-6"))
}

/// Part K of N, from 1.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    parts
        .filter(|(k, n)| (1..=*n).contains(k))
        .ok_or_else(|| format!("`{text}` is no part like 2/8"))
}

fn resolution(text: &str) -> Result<Resolution, String> {
    let wrong = || format!("`{text}` is no size like 640x360");
    let (n_x, n_y) = text.split_once('x').ok_or_else(wrong)?;
    let count = |text: &str| {
        text.parse::<usize>()
            .ok()
            .filter(|n| (1..=20_000).contains(n))
    };
    match (count(n_x), count(n_y)) {
        (Some(n_x), Some(n_y)) if n_x * n_y <= MOST_PIXELS => Ok(Resolution { n_x, n_y }),
        (Some(_), Some(_)) => Err(format!("more than {MOST_PIXELS} pixels cannot be cast")),
        _ => Err(wrong()),
    }
}
