//! One file for each thing the command does.

mod book;
mod built;
mod check;
mod diff;
mod explain;
pub mod golden;
mod grade;
mod handout;
mod merge;
#[cfg(feature = "study")]
mod plan;
mod render;
#[cfg(feature = "study")]
mod study;
#[cfg(feature = "validate")]
mod validate;

use std::path::{Path, PathBuf};

use pinhole::Scene;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::{Cli, Command, Golden};
use crate::error::{Error, Result};
use crate::handout::record::Record;
use crate::submission::Submission;

/// How a command that did its work ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Exit code 0.
    Well,
    /// Exit code 1.
    JudgedWrong,
    /// Exit code 3: what could not be done is told among what could.
    Incomplete,
}

impl Outcome {
    /// How a class ended, of which every submission has its mark or not.
    fn of_class(complete: bool) -> Outcome {
        match complete {
            true => Outcome::Well,
            false => Outcome::Incomplete,
        }
    }
}

/// Does what was asked.
pub fn run(cli: Cli) -> Result<Outcome> {
    let checkout = Checkout::find()?;
    refuse_in_a_handout(&checkout, &cli.command)?;
    match cli.command {
        Command::Check(arguments) => check::run(&checkout, &arguments),
        Command::Render(arguments) => render::run(&checkout, &arguments),
        Command::Explain(arguments) => explain::run(&checkout, &arguments),
        Command::Diff(arguments) => diff::run(&checkout, &arguments),
        Command::Golden(arguments) => golden::run(&checkout, &arguments),
        Command::Grade(arguments) => grade::run(&checkout, &arguments),
        Command::Merge(arguments) => merge::run(&checkout, &arguments),
        Command::Handout(arguments) => handout::run(&checkout, &arguments),
        #[cfg(feature = "validate")]
        Command::Validate(arguments) => validate::run(&checkout, &arguments),
        #[cfg(feature = "study")]
        Command::Study(arguments) => study::run(&checkout, &arguments),
        #[cfg(feature = "study")]
        Command::Plan(arguments) => plan::run(&checkout, &arguments),
        Command::Book(arguments) => book::run(&checkout, &arguments),
        #[cfg(target_os = "linux")]
        Command::Confine(_) => unreachable!("it has become another program by now"),
    }
}

/// What needs our answers, the mistakes or Mitsuba cannot be done by a student, and is
/// told so before it stumbles over the first file that is not there.
fn refuse_in_a_handout(checkout: &Checkout, command: &Command) -> Result<()> {
    let needs_more = match command {
        Command::Handout(_) | Command::Grade(_) | Command::Merge(_) | Command::Book(_) => true,
        Command::Golden(golden) => !matches!(golden, Golden::Verify(_)),
        _ => false,
    };
    if !needs_more || Record::read(checkout.root())?.is_none() {
        return Ok(());
    }
    Err(Error::input(
        "this is a student's repository: it holds no answers of ours, no known mistakes, and \
         nothing that renders goldens or builds the book",
        "run this in a checkout of the course",
    ))
}

/// The submission in the folder a user named, or else in the current one, or else in
/// `fallback`.
fn submission(
    named: Option<&PathBuf>,
    assignment: &Assignment,
    fallback: PathBuf,
) -> Result<Submission> {
    if let Some(folder) = named {
        return Submission::find(folder, assignment);
    }
    Submission::find(Path::new("."), assignment)
        .or_else(|_| Submission::find(&fallback, assignment))
}

/// The scene a user means: a file, or one of the assignment's by name. With it comes
/// its golden film's path, if one is committed.
fn scene(
    named: &str,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<(Scene, Option<PathBuf>)> {
    let path = scene_file(named, assignment)?;
    let golden = path.file_stem().map(|stem| {
        checkout
            .golden(&assignment.name)
            .join(stem)
            .with_extension("exr")
    });
    let is_own = path
        .canonicalize()
        .ok()
        .and_then(|path| Some(path.parent()?.to_owned()))
        == assignment.folder.join("scenes").canonicalize().ok();
    Ok((
        Scene::read(&path)?,
        golden.filter(|golden| is_own && golden.is_file()),
    ))
}

/// Where the scene lies that a user means.
fn scene_file(named: &str, assignment: &Assignment) -> Result<PathBuf> {
    let file = Path::new(named);
    let own = assignment.scene(named);
    match (file.is_file(), own.is_file()) {
        (true, _) => Ok(file.into()),
        (false, true) => Ok(own),
        (false, false) => {
            let names: Vec<&str> = assignment
                .scenes
                .iter()
                .map(|scene| scene.name.as_str())
                .collect();
            Err(Error::input(
                format!("there is no scene {named}"),
                format!("name a TOML file, or one of: {}", names.join(", ")),
            ))
        }
    }
}
