//! Your answers against Mitsuba's: one test for each task alone, one for each scene. They
//! judge as `cargo pinhole check` does, by the same code.
//!
//! The golden films decide, whatever insta is told: accepting a snapshot or setting
//! `INSTA_UPDATE` or `INSTA_FORCE_PASS` never turns a wrong film green, and nothing here
//! writes to `golden/`. The committed snapshots hold the verdict of a perfect film.

use std::env;
use std::path::Path;
use std::time::Duration;

use insta::{Comparator, Settings, Snapshot, assert_snapshot};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Program;
use pinhole_course::error::Result;
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::{Examination, FilmOutcome};
use pinhole_course::sandbox::Sandbox;
use pinhole_course::second_judge::SecondJudge;
use pinhole_course::submission::Submission;
use pinhole_report::terminal;

#[test]
fn viewing_ray_agrees_with_mitsuba() {
    assert_task("viewing_ray");
}

#[test]
fn sphere_agrees_with_mitsuba() {
    assert_task("sphere");
}

#[test]
fn plane_agrees_with_mitsuba() {
    assert_task("plane");
}

#[test]
fn triangle_agrees_with_mitsuba() {
    assert_task("triangle");
}

#[test]
fn triangle_soup_agrees_with_mitsuba() {
    assert_task("triangle_soup");
}

#[test]
fn first_hit_agrees_with_mitsuba() {
    assert_task("first_hit");
}

#[test]
fn sphere_and_plane_is_cast_right() {
    assert_scene("sphere_and_plane");
}

#[test]
fn two_spheres_and_plane_is_cast_right() {
    assert_scene("two_spheres_and_plane");
}

#[test]
fn slide_example_is_cast_right() {
    assert_scene("slide_example");
}

#[test]
fn lone_triangle_is_cast_right() {
    assert_scene("lone_triangle");
}

#[test]
fn inside_a_box_is_cast_right() {
    assert_scene("inside_a_box");
}

#[test]
fn inside_a_sphere_is_cast_right() {
    assert_scene("inside_a_sphere");
}

#[test]
fn tilted_camera_is_cast_right() {
    assert_scene("tilted_camera");
}

#[test]
fn in_front_of_the_image_plane_is_cast_right() {
    assert_scene("in_front_of_the_image_plane");
}

#[test]
fn soup_order_is_cast_right() {
    assert_scene("soup_order");
}

#[test]
fn sphere_packing_is_cast_right() {
    assert_scene("sphere_packing");
}

#[test]
fn teapot_orthographic_is_cast_right() {
    assert_scene("teapot_orthographic");
}

#[test]
fn bunny_is_cast_right() {
    assert_scene("bunny");
}

/// Longer than any answer should take, even in a build without optimisation.
const WALL: Duration = Duration::from_secs(120);

/// Asks one answer every question of its task.
#[track_caller]
fn assert_task(name: &str) {
    let examination = examined(Selection {
        tasks: vec![name.into()],
        scenes: Vec::new(),
    });
    let groups = examination
        .outcome
        .tasks
        .iter()
        .flat_map(|task| &task.groups);
    let lines: Vec<String> = groups
        .map(|group| format!("{} {}", group.name, said(&group.outcome, "questions")))
        .collect();
    assert_passes(name, &examination, &lines.join("\n"), "task");
}

/// Casts a scene and compares its film with the golden.
#[track_caller]
fn assert_scene(name: &str) {
    let examination = examined(Selection {
        tasks: Vec::new(),
        scenes: vec![name.into()],
    });
    let scenes = examination.outcome.scenes.iter();
    let lines: Vec<String> = scenes.map(|scene| said(&scene.outcome, "pixels")).collect();
    assert_passes(name, &examination, &lines.join("\n"), "scene");
}

fn said(outcome: &FilmOutcome, what: &str) -> String {
    match outcome {
        FilmOutcome::Unanswered => "is unanswered".into(),
        outcome => terminal::outcome_of(outcome, what),
    }
}

fn examined(selection: Selection) -> Examination {
    examine(&selection).unwrap_or_else(|error| panic!("{error}"))
}

/// Judges the program that cargo built from the answers beside this test's manifest.
fn examine(selection: &Selection) -> Result<Examination> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = package.parent().expect("the package is in an assignment");
    let checkout = Checkout::find()?;
    let assignment = Assignment::find(&checkout, None, folder)?;
    // What people believe who answer so is for `check` to say.
    let goldens = Goldens::read(&assignment.golden(), &assignment)?.without_known();
    let executable = option_env!("CARGO_BIN_EXE_ray-casting-handout")
        .or(option_env!("CARGO_BIN_EXE_ray-casting-reference"))
        .expect("cargo builds the answers before their tests");
    let program = Program {
        executable: executable.into(),
        replaced: Default::default(),
        warnings: Default::default(),
        stop: Default::default(),
    };
    let second_judge = second_judge(&checkout);
    let examiner = Examiner {
        assignment: &assignment,
        goldens: &goldens,
        program: &program,
        sandbox: &Sandbox::Trusted,
        wall: WALL,
        interactive: true,
        second_judge: second_judge.as_ref(),
        clock: None,
        known: None,
        progress: &|_, _| {},
    };
    let submission = Submission::find(package, &assignment)?;
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

/// Fails in the words of `cargo pinhole check`, before insta could advise to accept what is
/// wrong.
#[track_caller]
fn assert_passes(name: &str, examination: &Examination, words: &str, kind: &str) {
    let passes = examination.outcome.passes;
    let task = examination.outcome.tasks.first();
    let told = match task {
        Some(task) if task.is_unanswered() => "unanswered\n".into(),
        Some(task) => terminal::task(task, name.len() + 2),
        None => terminal::scenes(examination),
    };
    let told = terminal::plain(&told);
    assert!(
        passes,
        "{name} is not right yet\n{told}to see more: cargo pinhole check --{kind} {name}\n"
    );
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(GoldenDecides { passes }));
    settings.bind(|| assert_snapshot!(name, words));
}

/// Matches if the golden says so, whatever text was accepted as a snapshot.
#[derive(Clone)]
struct GoldenDecides {
    passes: bool,
}

impl Comparator for GoldenDecides {
    fn matches(&self, _: &Snapshot, _: &Snapshot) -> bool {
        self.passes
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}
