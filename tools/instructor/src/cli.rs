//! The instructor's command line: grading a class, handing out a course, making goldens, and
//! testing the grading.

use std::path::PathBuf;

use clap::{ArgGroup, Args, Parser, Subcommand};
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::sandbox::Choice;
use pinhole_course::seed::Seed;

use crate::golden::arguments::Golden;
use crate::grade::intake::pattern::NamePattern;
use crate::grade::redact::Reveal;
use crate::grade::views::formats::Format;
use crate::validate::Part;

/// Commands for instructors: grade a class, make the students' repository, make goldens, and test
/// the grading.
///
/// Exit codes: 0 if everything is right; 1 if an answer or a golden is wrong, or something needs
/// your attention; 2 if a file or an argument is wrong; 3 if something is missing on this machine,
/// or Pinhole has a bug.
#[derive(Parser)]
#[command(name = "pinhole", bin_name = "pinhole", version, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Make goldens with Mitsuba, or verify them
    #[command(subcommand)]
    Golden(Golden),
    Grade(Grade),
    Dispute(Dispute),
    Merge(Merge),
    Handout(Handout),
    Validate(Validate),
}

impl Command {
    /// Whether standard output must be one JSON document, errors included.
    pub fn wants_json(&self) -> bool {
        match self {
            Command::Golden(Golden::Verify(arguments)) => arguments.json,
            Command::Golden(_) => false,
            Command::Grade(arguments) => arguments.json,
            Command::Dispute(arguments) => arguments.json,
            Command::Merge(arguments) => arguments.json,
            Command::Handout(arguments) => arguments.json,
            Command::Validate(arguments) => arguments.json,
        }
    }
}

/// Grade the submissions of a whole class
///
/// Each path is a submission (a folder, .zip or .tar.gz with the answer files), a folder of
/// submissions, or a learning platform's export of a class. The result and the report of each
/// submission are written to OUT/submissions, and the results of the whole class to OUT/grades.csv
/// and OUT/class.html. All code runs in a sandbox, unless you turn it off.
///
/// You can stop `grade` at any time and run it again. It continues where it left off, and
/// regrades only what has changed. Submissions that can't be graded because the machine or Pinhole
/// failed are listed first. They get no mark, which is not the same as a zero. If there are any,
/// the exit code is 3.
///
/// The end of the output and the top of class.html list what you should look at: files that are
/// part of no submission, and submissions that lack files, that could belong to several people, or
/// that belong to nobody on the roster. If any of these may have cost somebody points, the exit
/// code is 1.
///
/// If Mitsuba is installed, `grade` also asks fresh questions, which are drawn from a new seed and
/// are the same for the whole class. A submission earns the points for a group of questions only if
/// its answers to the public and to the fresh questions are right.
#[derive(Args)]
pub struct Grade {
    /// Submissions and folders of submissions
    #[arg(required = true, value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write results to this folder, and keep the results in it that are still valid (required,
    /// except with --dry-run)
    #[arg(long, value_name = "OUT", required_unless_present = "dry_run")]
    pub out: Option<PathBuf>,
    /// Show who handed in each submission and what it contains, and grade nothing
    #[arg(long)]
    pub dry_run: bool,
    /// Grade this many submissions at a time [default: one for each core]
    #[arg(long, value_name = "N")]
    pub jobs: Option<usize>,
    /// Judge against the golden films in this folder, and withhold them from students; `pinhole
    /// golden render SCENE.toml --out DIR` makes them
    #[arg(long, value_name = "DIR")]
    pub golden: Option<PathBuf>,
    /// How much to reveal about what students don't have: fresh questions, withheld scenes, and the
    /// films given with --golden
    #[arg(long, value_enum, default_value_t)]
    pub reveal: Reveal,
    /// Draw fresh questions from this seed [default: the seed of OUT/fresh; if there is none, or
    /// with --regrade, a random 128-bit seed]
    #[arg(long, value_name = "N")]
    pub seed: Option<Seed>,
    /// Ask the fresh questions in this folder; `pinhole golden render --seed random --out
    /// DIR` makes them
    #[arg(long, value_name = "DIR", conflicts_with = "seed")]
    pub fresh: Option<PathBuf>,
    /// Ask no fresh questions
    #[arg(long, conflicts_with_all = ["seed", "fresh"])]
    pub no_fresh: bool,
    /// The list of students: a CSV file whose first line is `id,name,section`, or a list from
    /// Canvas or Moodle
    #[arg(long, value_name = "CSV")]
    pub roster: Option<PathBuf>,
    /// How folders and archives are named if their names are not just ids, for instance `hw1-{github}`
    /// for clones from GitHub, or `HW1_{id}` for files from Blackboard. `{id}` stands for an id or a
    /// university login, `{github}` for a login on GitHub, `{group}` for a group's name, and `{name}` for
    /// a person's
    #[arg(long, value_name = "PATTERN", requires = "roster")]
    pub named: Option<NamePattern>,
    /// A policy.toml, which sets deadlines, late days and extra credit, and changes individual
    /// marks
    #[arg(long, value_name = "TOML")]
    pub policy: Option<PathBuf>,
    /// Also write results in this format (repeatable)
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Vec<Format>,
    /// Grade everything again, with newly drawn questions, and list the marks that change,
    /// beginning with those that drop
    #[arg(long)]
    pub regrade: bool,
    /// Grade only part K of N; `pinhole merge` combines the parts
    #[arg(long, value_name = "K/N", value_parser = shard)]
    pub shard: Option<(usize, usize)>,
    /// Limit each task and scene to this many seconds of processor time, or to a hundred times what
    /// the reference solution takes, whichever is more. A submission that exceeds a limit is graded
    /// again at the end, with nothing else running
    #[arg(long, value_name = "SECONDS", default_value_t = 4,
          value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub timeout: u64,
    /// The sandbox that all code runs in
    #[arg(long, value_enum, value_name = "SANDBOX", default_value_t)]
    pub sandbox: Choice,
    /// Run code without a sandbox, and say so in every result; only for your own code (short for
    /// --sandbox none)
    #[arg(long, conflicts_with = "sandbox")]
    pub trust: bool,
    /// Print to standard error how long each stage took, summed over all submissions
    #[arg(long)]
    pub timings: bool,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

impl Grade {
    /// The sandbox that the user has chosen.
    pub fn sandbox_choice(&self) -> Choice {
        match self.trust {
            true => Choice::None,
            false => self.sandbox,
        }
    }
}

/// Show everything behind one mark, so that you can explain it to the student
///
/// Prints the final mark, and each deduction or other adjustment with its reason. For each group of
/// questions that fails, prints one question that was answered wrongly: what was asked, what was
/// expected and what the code returned. For each task with such a group, also prints the file that
/// was handed in. Nothing is graded again.
///
/// Don't give the output to students as it is: it may show fresh questions and questions about
/// withheld scenes, which they must not see.
#[derive(Args)]
pub struct Dispute {
    /// The id of a submission, or the id or name of a person, as in grades.csv
    #[arg(value_name = "ID")]
    pub id: String,
    /// The folder with the results of the class: what you passed to `grade --out`
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Combine the parts of a class that were graded separately
///
/// The parts are the --out folders of `grade --shard K/N`. Give each of these runs the same
/// submissions, roster, policy, goldens and fresh questions (see `grade --fresh`). The result is
/// the same as if the class had been graded in one run.
///
/// You can also pass a single folder, for instance to apply another --policy or to write another
/// --format. `merge` never runs or judges code: it works from the stored results.
#[derive(Args)]
pub struct Merge {
    /// The folders of the parts
    #[arg(required = true, value_name = "DIR")]
    pub shards: Vec<PathBuf>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write the results of the whole class to this folder
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Apply this policy.toml instead of the one that the parts were graded with
    #[arg(long, value_name = "TOML")]
    pub policy: Option<PathBuf>,
    /// Also write results in this format (repeatable)
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Vec<Format>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Make stubs from the reference solution, or write a whole repository for students
///
/// A stub is a copy of a reference file in which the body of each function that students write is
/// `todo!`. Signatures and documentation stay.
///
/// With --out, `handout` writes a repository for students: the stubs, the commands for students,
/// the public scenes and their goldens, tests, a README and a workflow for GitHub. To use the
/// repository, students need only Rust and a linker. The repository contains neither solutions nor
/// the wrong answers that `check` uses to recognise mistakes. About scenes with `public = false`,
/// it reveals only how many points they are worth in total.
#[derive(Args)]
#[command(group = ArgGroup::new("autograder").args(["gradescope", "prairielearn"]).multiple(true))]
pub struct Handout {
    /// The assignment, by name or folder
    #[arg(value_name = "ASSIGNMENT", conflicts_with = "name")]
    pub positional: Option<String>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Write nothing, and fail if the stubs in this repository don't match the reference
    #[arg(long, conflicts_with_all = ["out", "gradescope", "prairielearn"])]
    pub check: bool,
    /// Write a student repository to this folder, which must be new or empty unless you pass
    /// --force
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Put the sources of all dependencies into the repository, so that it builds without network
    /// access
    #[arg(long, requires = "out")]
    pub vendor: bool,
    /// Put the book from this folder into the repository. Pass book/build/student, where
    /// `pinhole book build` writes the student edition
    #[arg(long, value_name = "DIR", requires = "out")]
    pub book: Option<PathBuf>,
    /// Overwrite files that an earlier run has written. With --out, nothing is written if somebody
    /// has changed one of these files since then; without --out, changes to the stubs are lost
    #[arg(long, conflicts_with = "check")]
    pub force: bool,
    /// Write a Gradescope autograder to this file. Keep the file private: it contains all goldens
    /// and the reference solution
    #[arg(long, value_name = "FILE.zip")]
    pub gradescope: Option<PathBuf>,
    /// Write a PrairieLearn question and a Dockerfile for its grader to this folder, which must be
    /// new or empty. Keep it private: it contains all goldens and the reference solution
    #[arg(long, value_name = "DIR")]
    pub prairielearn: Option<PathBuf>,
    /// Have the autograder also ask the questions in this folder. Students must never have seen
    /// them, because known questions can be memorised. To make such a folder, run
    /// `pinhole golden render --seed random --out DIR`
    #[arg(long, value_name = "DIR", requires = "autograder")]
    pub fresh: Option<PathBuf>,
    /// How much the autograder reveals about what students don't have: fresh questions, and scenes
    /// with `public = false`
    #[arg(long, value_enum, default_value_t, requires = "autograder")]
    pub reveal: Reveal,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Test the grading: does it catch every known mistake and pass every right answer?
///
/// Judges answers whose verdict is known, in the same way as students' answers. The stub must count
/// as unanswered. The reference and every variant (another right answer) must pass. Every known
/// mistake must fail in exactly the tasks that it declares, and so must its rewrite with another
/// algorithm, if it has one. Its hint must be short and easy to read, and include an example with
/// numbers.
///
/// The tables show how many mistakes each group of questions and each scene catches, how many it
/// alone catches, and how small an error each scene detects. The exit code is 0 if every target is
/// met. Otherwise it is 1, and the missed targets are listed first.
#[derive(Args)]
pub struct Validate {
    /// The assignment, by name or folder
    #[arg(value_name = "ASSIGNMENT", conflicts_with = "name")]
    pub positional: Option<String>,
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Also judge several hundred copies of the reference with one small fault each (a sign, a
    /// comparison, a constant, …), which takes about ten minutes. Each must fail, except those that
    /// equivalent.toml lists
    #[arg(long)]
    pub mutants: bool,
    /// Judge all pairs of mistakes in pairs.toml, not only a few for each task
    #[arg(long)]
    pub pairs: bool,
    /// Also check that each sentence of a diagnosis, such as “exactly those where d · n > 0”, is
    /// true for the questions in this folder; `golden render --seed N --out DIR` makes them
    #[arg(long, value_name = "DIR")]
    pub fresh: Option<PathBuf>,
    /// Ask every mistake and mutant the fresh questions in each subfolder of DIR, and list the
    /// marks that differ from folder to folder; without --only, nothing else is judged
    #[arg(long, value_name = "DIR")]
    pub draws: Option<PathBuf>,
    /// Judge only this part (repeatable)
    #[arg(long, value_name = "PART")]
    pub only: Vec<Part>,
    /// Judge only items whose name contains this text, such as `mistakes/sphere_`, `variants/`,
    /// `triangle.rs:26:` (a mutant) or `bunny`
    #[arg(long, value_name = "TEXT")]
    pub named: Option<String>,
    /// Also judge every film with OpenImageIO's oiiotool
    #[arg(long)]
    pub oiiotool: bool,
    /// Judge this many submissions at a time [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// Part K of N, counted from 1.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    parts
        .filter(|(k, n)| (1..=*n).contains(k))
        .ok_or_else(|| format!("`{text}` is not K/N with K from 1 to N, such as 2/8"))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;
    use pinhole_testing::documented_commands::assert_all_parse;

    use super::Cli;

    #[test]
    fn every_documented_command_parses() {
        assert_all_parse(&Cli::command(), &[], 20);
    }
}
