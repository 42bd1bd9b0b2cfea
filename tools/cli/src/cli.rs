//! The command line, and the texts of `--help`.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use pinhole::Resolution;
use pinhole_course::run_options::{AssignmentOption, RunOptions, resolution};

/// Computer graphics assignments, judged by comparing answers with those of the renderer Mitsuba.
///
/// To begin, run `cargo pinhole check --watch` and write your answers in the `handout/src` folder
/// of the assignment. Each answer is judged when you save it.
///
/// Exit codes: 0 if everything is right; 1 if an answer is wrong; 2 if a file or an argument is
/// wrong; 3 if something is missing on this machine, or Pinhole has a bug.
#[derive(Parser)]
#[command(
    bin_name = "pinhole",
    version,
    max_term_width = 100,
    after_help = "The instructor's repository has more commands, each with --help. For \
                  instructors: golden, grade, merge, dispute, handout, validate. For the study of \
                  speed and accuracy: study, plan. For the book: book."
)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    Check(Check),
    Render(Render),
    Explain(Explain),
    Examples(Examples),
    Diff(Diff),
    Reset(Reset),
    Doctor(Doctor),
    Completions(Completions),
}

impl Command {
    /// Whether standard output must be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Check(arguments) => arguments.json,
            Command::Render(arguments) => arguments.json,
            Command::Explain(arguments) => arguments.json,
            Command::Examples(arguments) => arguments.json,
            Command::Diff(arguments) => arguments.json,
            Command::Reset(arguments) => arguments.json,
            Command::Doctor(arguments) => arguments.json,
            Command::Completions(_) => false,
        }
    }
}

/// Compile a submission and judge its answers
///
/// An answer is the code that you write for one task. Each task has several groups of questions.
/// What your code returns is compared with what the renderer Mitsuba returns. Then all your answers
/// are used together to render each scene as a film, which is compared with Mitsuba's. For each
/// pixel, a film holds the object that its ray hits, the ray's parameter t at the hit, and the
/// surface normal there. For each group and scene that fails, you see what was asked, what was
/// expected and what your code returned.
///
/// With --watch, `check` keeps running and judges an answer whenever you save it. Once all tasks
/// pass, it judges the scenes. Press h for a hint and ? for all keys. Without a terminal, or with
/// --json, `check --watch` prints verdicts as they come, until you press Ctrl-C or close the pipe
/// to its standard input. With --watch --json, each verdict is a JSON document on a line of its own.
/// With --watch, the exit code doesn't depend on the verdicts.
///
/// Only the answer files in the folder DIR are used. If DIR is outside this repository, the code is
/// compiled and run in a sandbox.
///
/// `check` also writes a report, an HTML file with hints. For every scene that fails, the report
/// shows the expected picture and yours. Click a pixel to see what Mitsuba and your code
/// each returned for it.
#[derive(Args)]
pub struct Check {
    /// The folder with the answer files, or a folder that has them in its `src` folder [default:
    /// the current folder if it has answer files, else the assignment's `handout` folder]
    pub dir: Option<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Keep running, and judge each answer when it is saved
    #[arg(long, conflicts_with_all = ["scene", "oiiotool", "no_report"])]
    pub watch: bool,
    /// Judge only this task (repeatable)
    #[arg(long, value_name = "TASK")]
    pub task: Vec<String>,
    /// Judge only this scene (repeatable)
    #[arg(long, value_name = "SCENE")]
    pub scene: Vec<String>,
    /// Judge against the golden films (made by Mitsuba) in this folder
    #[arg(long, value_name = "DIR")]
    pub golden: Option<PathBuf>,
    /// Also judge every film with OpenImageIO's oiiotool
    #[arg(long)]
    pub oiiotool: bool,
    #[command(flatten)]
    pub run: RunOptions,
    /// Write the report to this HTML file [default: target/pinhole/report.html in the repository]
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Don't write a report
    #[arg(long, conflicts_with = "report")]
    pub no_report: bool,
    /// Open the page of the book that helps with the first thing that is wrong
    #[arg(long, conflicts_with_all = ["json", "watch"])]
    pub read: bool,
    /// Also pack your answers into this ZIP file, so that you can hand them in
    #[arg(long, value_name = "FILE", conflicts_with = "watch")]
    pub pack: Option<PathBuf>,
    /// Show how long each stage took
    #[arg(long, conflicts_with = "watch")]
    pub timings: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
    /// Compile answers with any attribute and macro, for tests of the sandbox
    #[arg(long, hide = true)]
    pub allow_everything: bool,
}

/// Render a scene, and write its film and pictures
///
/// For each pixel, film.exr holds the id of the object that its ray hits, the ray's parameter t at
/// the hit, and the surface normal there. id.png, depth.png and normal.png show these three in
/// false colours. If Mitsuba has rendered the scene too, depth.png uses the same colours as
/// Mitsuba's depth picture, so you can compare the two. If the assignment counts how often rays are
/// tested against boxes and triangles, tests.png shows how many tests each pixel took, and
/// expected-tests.png shows how many each pixel takes with the reference answers.
///
/// If some of your answers are still missing, pixels that need them are taken from Mitsuba's film.
/// These pixels are faded in the pictures, so that you can see what your own code already does.
#[derive(Args)]
pub struct Render {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// Use the answers in this folder [default: the current folder if it has answer files, else the
    /// assignment's `handout` folder]
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Render at this resolution instead of the scene's own; the image plane keeps its size
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = resolution)]
    pub resolution: Option<Resolution>,
    /// Write the files to this folder
    #[arg(long, value_name = "DIR", default_value = "render")]
    pub out: PathBuf,
    #[command(flatten)]
    pub run: RunOptions,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Explain one pixel in words
///
/// Shows your ray beside the expected one: first where each crosses the image plane, then both rays
/// in camera space. After that, you see your ray in world space, what your code returned for each
/// object, everything that it printed, and your first hit. If Mitsuba has rendered the scene, you
/// see Mitsuba's ray and first hit beside yours.
///
/// Try: cargo pinhole explain slide_example 2 3
#[derive(Args)]
pub struct Explain {
    /// A scene file, or the name of one of the assignment's scenes
    pub scene: String,
    /// The pixel's column, counted from the left, starting at 0
    pub i: usize,
    /// The pixel's row, counted from the bottom, starting at 0
    pub j: usize,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Explain the answers in this folder [default: the current folder if it has answer files, else
    /// the assignment's `handout` folder]
    #[arg(long, value_name = "DIR")]
    pub submission: Option<PathBuf>,
    #[command(flatten)]
    pub run: RunOptions,
    /// Open the page of the book that helps with the first wrong answer
    #[arg(long, conflicts_with = "json")]
    pub read: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Work out answers by hand, and see how many mistakes they would catch
///
/// Do this before you write any code, to find out whether you understand a task. You choose some of
/// its public questions and write down the answers. For each answer, you see whether Mitsuba gives
/// the same one. Your right answers are also tested against mistakes that people make in this task.
/// An answer catches a mistake if code with that mistake gives a different answer. You see how many
/// mistakes your answers catch. If a right answer catches none, choose another question, because
/// even wrong code gets this one right.
///
/// Each task's questions come in groups. To begin, have the command write a file with one question
/// from each group, with the answers left out:
///
/// cargo pinhole examples --new sphere
///
/// An example is a question with its answer, and looks like this:
///
/// [[example]]
/// group = "inside"
/// question = 3
/// hit = true
/// t = 1.25
/// normal = [0, 0.6, 0.8]
///
/// Three significant digits are enough. If nothing is hit, write `hit = false`, and leave out `t`
/// and `normal`. You may leave out a part of any answer, such as the normal, but then the example
/// can't catch mistakes in that part. If a question has no answer yet, the command prints it in
/// words. Examples earn points only if your assignment says so.
///
/// If the task is about one shape, you can also choose a ray and a shape yourself. Write them in
/// place of `group` and `question`, with the keys that the shape has in scene files:
///
/// ray = { e = [0, 0, 4], d = [0, 0, -2], min_t = 0 }
/// shape = { center = [0, 0, 0], radius = 1 }
///
/// Such examples can only be judged where Mitsuba is installed. Students don't need to install it:
/// their instructor can run this command for them.
#[derive(Args)]
#[command(verbatim_doc_comment)]
pub struct Examples {
    /// The file with your examples
    pub file: Option<PathBuf>,
    /// Write questions from this task to FILE [default: TASK.examples.toml]
    #[arg(long, value_name = "TASK")]
    pub new: Option<String>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Compare a film made by any program with a golden film
///
/// A golden film is one that Mitsuba has rendered. Your film passes if it has the
/// golden's size and channels, all its values are finite, and |film − golden| ≤ tolerance in every
/// channel of every pixel. (Some films have a channel `tests`, which counts how often the ray was
/// tested against boxes and triangles. This channel is judged as a whole: the sum of
/// |film − golden| over all pixels must not exceed the sum of the tolerances.) The tolerances for
/// the golden film NAME.exr are in NAME.tol.exr, in the same folder. If OpenImageIO's oiiotool is
/// installed, it judges the film too. If the two verdicts differ, Pinhole has a bug, and `diff`
/// says so.
#[derive(Args)]
pub struct Diff {
    /// The golden film: NAME.exr, with NAME.tol.exr beside it
    pub golden: PathBuf,
    /// The film to judge
    pub film: PathBuf,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write pictures of both films and of their difference to this folder, and a report.html that
    /// shows both films pixel by pixel
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write the report to this file [default: report.html in the folder that --out names]
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// The scene that the films show: a scene file, or the name of one of the assignment's
    /// scenes. With it, the report can name the scene's objects [default: the golden film's own
    /// scene]
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Replace an answer with its stub, the code that you started from
///
/// Your answer is kept in the same folder, under a name that ends in .old. If you reset the answer
/// again, the next copy's name ends in .old2, and so on.
#[derive(Args)]
pub struct Reset {
    /// The task
    pub task: String,
    /// The folder with the answer files, or a folder that has them in its `src` folder [default:
    /// the current folder if it has answer files, else the assignment's `handout` folder]
    pub dir: Option<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Check whether this machine has what Pinhole needs
///
/// Lists what Pinhole uses, such as the Rust compiler and a linker, and says whether each was
/// found. In the instructor's repository, the list includes the sandbox and Mitsuba. A student's
/// repository needs neither: it contains the films that Mitsuba has rendered, and students run their
/// own code without a sandbox. If something is missing, you also see what it is used for and how to get it. Only the
/// Rust compiler, a linker and enough free disk space are required. If one of these is missing, the
/// exit code is 3.
#[derive(Args)]
pub struct Doctor {
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Print a script that completes commands and options in your shell
///
/// The script works for the program `pinhole`, but not for `cargo pinhole`. To install the program,
/// run `cargo install --path tools/cli` in the repository. Then, for Bash, run:
///
/// pinhole completions bash > ~/.local/share/bash-completion/completions/pinhole
#[derive(Args)]
pub struct Completions {
    /// The shell that will run the script
    pub shell: clap_complete::Shell,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;
    use pinhole_testing::documented_commands::assert_all_parse;

    use super::Cli;

    #[test]
    fn every_documented_command_parses() {
        // Only the study has options to cast exactly or by a plan.
        assert_all_parse(&Cli::command(), &["--exact", "--plan"], 10);
    }
}
