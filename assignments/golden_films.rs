//! Your answers against Mitsuba's: one test for each task alone, one for each scene, as
//! `assignment.toml` lists them. They judge as `cargo pinhole check` does, by the same code.
//!
//! The golden films decide first, whatever insta is told: accepting a snapshot or setting
//! `INSTA_UPDATE` or `INSTA_FORCE_PASS` never turns a wrong film green, and nothing here
//! writes to `golden/`. The committed snapshots list the verdicts of a right answer.

use std::env;
use std::path::Path;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use insta::{Settings, assert_snapshot};
use libtest_mimic::{Arguments, Failed, Trial};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Program;
use pinhole_course::error::Result;
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::{Examination, Status};
use pinhole_course::run_options::RunOptions;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::second_judge::SecondJudge;
use pinhole_course::submission::Submission;
use pinhole_report::escape::printable_word;
use pinhole_report::terminal;

/// The tasks that have timed out so far. A scene that needs one of them would time out too.
static LATE: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn main() -> ExitCode {
    let (_, assignment) = find().unwrap_or_else(|error| panic!("{error}"));
    let test = |kind: &'static str, name: &str| {
        let selected = vec![name.to_owned()];
        let (tasks, scenes) = match kind {
            "task" => (selected, Vec::new()),
            _ => (Vec::new(), selected),
        };
        let name = name.to_owned();
        let selection = Selection { tasks, scenes };
        Trial::test(name.clone(), move || passes(kind, &name, &selection)).with_kind(kind)
    };
    let tasks = assignment.tasks.iter().map(|task| test("task", &task.name));
    let scenes = assignment
        .scenes
        .iter()
        .map(|scene| test("scene", &scene.name));
    libtest_mimic::run(&Arguments::from_args(), tasks.chain(scenes).collect()).exit_code()
}

/// The assignment around the package of the answers.
fn find() -> Result<(Checkout, Assignment)> {
    let checkout = Checkout::find()?;
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let assignment = Assignment::find(&checkout, None, package)?;
    Ok((checkout, assignment))
}

/// Asks one answer every question of its task, or casts a scene. Fails in the words of
/// `cargo pinhole check`, before insta could advise the reader to accept a wrong verdict.
fn passes(kind: &str, name: &str, selection: &Selection) -> std::result::Result<(), Failed> {
    let (checkout, assignment) = find()?;
    if let Some(task) = late_task(&assignment, selection)? {
        return Err(format!("{name} is not cast, because `{task}` timed out\n").into());
    }
    let examination = examine(&checkout, &assignment, selection)?;
    let outcome = &examination.outcome;
    let tasks = outcome.tasks.iter();
    let late = tasks.filter(|task| {
        let mut groups = task.groups.iter();
        groups.any(|group| group.outcome.status() == Status::TimedOut)
    });
    let late = late.map(|task| task.name.clone());
    LATE.lock()
        .unwrap_or_else(PoisonError::into_inner)
        .extend(late);
    if !outcome.passes {
        let told = match outcome.tasks.first() {
            Some(task) if task.is_unanswered() => "unanswered\n".into(),
            Some(task) => terminal::task(task, name.len() + 2),
            None => terminal::scenes(&examination),
        };
        let told = terminal::plain(&told);
        let folder = match Submission::is_default(Path::new(&outcome.submission)) {
            true => String::new(),
            false => format!(" {}", printable_word(&outcome.submission)),
        };
        let more = format!("to see more: cargo pinhole check{folder} --{kind} {name}");
        return Err(format!("{name} is not right yet\n{told}{more}\n").into());
    }
    let groups = outcome.tasks.iter().flat_map(|task| &task.groups);
    let groups = groups.map(|group| (group.name.as_str(), &group.outcome));
    let scenes = outcome.scenes.iter().map(|scene| ("", &scene.outcome));
    let films = groups.chain(scenes);
    let words = films.map(|(name, film)| format!("{name} {}", terminal::outcome_of(film, "")));
    let words: Vec<String> = words.map(|line| line.trim_start().to_owned()).collect();
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(Path::new(&assignment.name).join("tests/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_snapshot!(name, words.join("\n")));
    Ok(())
}

/// A task that a selected scene needs, and that has timed out.
fn late_task(assignment: &Assignment, selection: &Selection) -> Result<Option<String>> {
    let late = LATE.lock().unwrap_or_else(PoisonError::into_inner).clone();
    for scene in &selection.scenes {
        let (scene, _) = assignment.find_scene(scene)?;
        let mut tasks = late.iter().filter_map(|name| assignment.task(name));
        if let Some(task) = tasks.find(|task| task.kind.is_needed_by(task.shape, &scene)) {
            return Ok(Some(task.name.clone()));
        }
    }
    Ok(None)
}

/// Judges the program that cargo built from the answers beside this test's manifest.
fn examine(
    checkout: &Checkout,
    assignment: &Assignment,
    selection: &Selection,
) -> Result<Examination> {
    // Diagnoses are left to `check`.
    let goldens = Goldens::read(&assignment.golden(), assignment)?.without_known();
    // Cargo builds the answers before their tests.
    let executable = env!(concat!("CARGO_BIN_EXE_", env!("CARGO_PKG_NAME")));
    let tasks = assignment.answerable().map(|task| task.name.clone());
    let program = Program {
        executable: executable.into(),
        // Cargo has not told which of them are stubs, so any may be.
        stubs: tasks.collect(),
        with_ours: Default::default(),
        replaced: Default::default(),
        warnings: Default::default(),
        stop: Default::default(),
    };
    let second_judge = second_judge(checkout);
    let examiner = Examiner {
        assignment,
        goldens: &goldens,
        program: &program,
        sandbox: &Sandbox::Trusted,
        wall: Duration::from_secs(RunOptions::TIMEOUT),
        interactive: true,
        second_judge: second_judge.as_ref(),
        clock: None,
        withheld: &[],
        known: None,
        progress: &|_, _| {},
    };
    let submission = Submission::find(Path::new(env!("CARGO_MANIFEST_DIR")), assignment)?;
    examiner.examine(&submission, selection)
}

/// Oiiotool, if it is installed. Students need not have it; the course's own CI must.
fn second_judge(checkout: &Checkout) -> Option<SecondJudge> {
    let found = SecondJudge::find(checkout).ok();
    let is_students = !checkout.root().join("tools/mitsuba").is_dir();
    let may_be_absent = is_students || env::var_os("CI").is_none();
    assert!(found.is_some() || may_be_absent, "CI has no oiiotool");
    found
}
