//! `validate` reports every kind of wrong verdict.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use pinhole_testing::{RunResult, fresh, pinhole, root, small_assignment, trusted};

/// A small assignment that belongs to one test.
fn assignment(name: &str) -> PathBuf {
    small_assignment(&fresh(&trusted(), name))
}

fn write(folder: &Path, file: &str, text: &str) {
    let path = folder.join(file);
    fs::create_dir_all(path.parent().expect("it is in a folder")).expect("it can be made");
    fs::write(path, text).expect("it can be written");
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join("assignments/ray_casting").join(file)).expect("it is there")
}

fn validate(assignment: &Path, arguments: &[&str]) -> RunResult {
    let folder = assignment.to_str().expect("a plain name");
    pinhole(&[&["validate", folder], arguments].concat())
}

/// Writes a combined mistake of these, which has no answer file of its own. Also writes the
/// mistakes; each uses its own files as its rewrite.
fn write_compound(course: &Path, beliefs: &[&str]) {
    let mut tasks = Vec::new();
    for slug in beliefs {
        let (task, _) = slug.split_once('_').expect("its name begins with the task");
        let (folder, file) = (format!("mistakes/{slug}"), format!("{task}.rs"));
        let wrong = read(&format!("{folder}/{file}"));
        write(course, &format!("{folder}/{file}"), &wrong);
        write(course, &format!("{folder}/rewrite/{file}"), &wrong);
        let toml = read(&format!("{folder}/mistake.toml"));
        write(course, &format!("{folder}/mistake.toml"), &toml);
        tasks.push(task);
    }
    let toml = read("mistakes/plane_tests_zero/mistake.toml");
    let lists = format!("beliefs = {beliefs:?}\nfails = {tasks:?}");
    let toml = toml.replace("fails = [\"plane\"]", &lists);
    write(course, "mistakes/compound/mistake.toml", &toml);
}

/// The output of `validate` for a course in which everything that can be wrong is wrong.
fn wrong_verdicts() -> &'static RunResult {
    static RAN: OnceLock<RunResult> = OnceLock::new();
    RAN.get_or_init(|| {
        let course = assignment("wrong-verdicts");
        let (right, wrong) = (
            read("reference/src/plane.rs"),
            read("mistakes/plane_tests_zero/plane.rs"),
        );
        let toml = read("mistakes/plane_tests_zero/mistake.toml");
        let elsewhere = toml.replace("fails = [\"plane\"]", "fails = [\"sphere\"]");
        assert_ne!(toml, elsewhere, "`fails` is written as this test expects");

        write(&course, "mistakes/plane_harmless/plane.rs", &right);
        write(&course, "mistakes/plane_harmless/mistake.toml", &toml);
        write(&course, "mistakes/plane_elsewhere/plane.rs", &wrong);
        write(&course, "mistakes/plane_elsewhere/mistake.toml", &elsewhere);
        write(&course, "mistakes/plane_broken/plane.rs", "impl Broken");
        write(&course, "mistakes/plane_broken/mistake.toml", &toml);
        write(&course, "mistakes/plane_known/plane.rs", &wrong);
        write(&course, "mistakes/plane_known/mistake.toml", &toml);
        write(&course, "mistakes/plane_known/rewrite/plane.rs", &wrong);
        write(&course, "mistakes/plane_rewritten/plane.rs", &wrong);
        write(&course, "mistakes/plane_rewritten/mistake.toml", &toml);
        write(&course, "mistakes/plane_rewritten/rewrite/plane.rs", &right);
        write_compound(&course, &["plane_tests_zero", "sphere_tests_zero"]);
        write(&course, "variants/plane_wrong/plane.rs", &wrong);
        write(&course, "variants/plane_right/plane.rs", &right);
        validate(&course, &["--only", "mistakes", "--only", "variants"])
    })
}

#[track_caller]
fn is_named(fault: &str) {
    let RunResult { code, out, err } = wrong_verdicts();
    assert_eq!(*code, 1, "{out}\n{err}");
    assert!(out.contains(fault), "no {fault:?} in:\n{out}\n{err}");
}

/// Held by tests that judge the same mutants, because each removes their programs at the end.
static MUTANTS: Mutex<()> = Mutex::new(());

#[test]
fn a_mistake_that_passes_everything_is_missed() {
    is_named("✗ missed: mistakes/plane_harmless passes everything\n");
}

#[test]
fn a_mistake_that_fails_in_another_task_than_it_declares_is_named() {
    is_named("✗ mistakes/plane_elsewhere is declared to fail in sphere, but fails in plane\n");
}

#[test]
fn mistake_that_does_not_compile_is_a_fault() {
    is_named("✗ mistakes/plane_broken does not compile: plane\n");
}

#[test]
fn a_rewrite_of_a_mistake_must_fail_as_well() {
    is_named("✗ missed: mistakes/plane_rewritten/rewrite passes everything\n");
}

#[test]
fn a_compound_is_composed_of_its_beliefs_answers_and_of_their_rewrites() {
    let out = &wrong_verdicts().out;
    assert!(out.contains("; combined mistakes: 1"), "{out}");
    let table = out.split("\n  several known mistakes at once").nth(1);
    let table = table.expect("it counts");
    let tasks = table.lines().nth(1).expect("a row for tasks");
    let words: Vec<&str> = tasks.split_whitespace().collect();
    assert_eq!(words, ["tasks", "2", "2", "0", "0", "0"], "{out}");
}

#[test]
fn a_compound_within_one_task_needs_an_answer_of_its_own() {
    let course = assignment("within-one-task");
    write_compound(&course, &["plane_tests_zero", "plane_normal_not_unit"]);
    let ran = validate(&course, &["--only", "mistakes"]).expect_code(2);
    ran.expect_err("compound: two of its beliefs are about plane");
}

#[test]
fn a_variant_that_loses_a_point_is_a_false_fail() {
    is_named("✗ false fail: variants/plane_wrong fails plane.");
}

#[test]
fn right_verdict_is_not_a_fault() {
    let out = &wrong_verdicts().out;
    let faults: Vec<&str> = out
        .lines()
        .take_while(|line| !line.starts_with("✓"))
        .collect();
    let faults = faults.join("\n");
    assert!(!faults.contains("plane_right"), "{faults}");
    assert!(!faults.contains("mistakes/plane_known "), "{faults}");
    assert!(!faults.contains("plane_known/rewrite"), "{faults}");
    assert!(!faults.contains("compound"), "{faults}");
    // There are five wrong verdicts, and no belief is named in tasks or in scenes.
    assert!(out.contains("7 targets are missed"), "{out}");
}

#[test]
fn a_reference_that_mitsuba_contradicts_is_a_false_fail() {
    let course = assignment("wrong-reference");
    let right = read("reference/src/plane.rs");
    let wrong = right.replace("t >= min_t", "t >= 0.0");
    assert_ne!(right, wrong, "the reference compares as this test expects");
    write(&course, "reference/src/plane.rs", &wrong);
    validate(&course, &["--only", "variants"])
        .expect_code(1)
        .expect_out("✗ false fail: the reference fails plane.min_t\n");
}

/// The line of the sphere that has three mutants without an effect. One is never true; with
/// `<=` or `==`, the others are also true for tangent rays, which are ties.
const DISCRIMINANT: &str = "if discriminant < 0.0 {";

/// The name of a mutant that changes this line.
fn of_the_discriminant() -> String {
    let text = read("reference/src/sphere.rs");
    let line = text.lines().position(|line| line.trim() == DISCRIMINANT);
    format!("sphere.rs:{}:", line.expect("the line is there") + 1)
}

fn listed(becomes: &str, differs: &str) -> String {
    format!(
        "[[mutant]]\ntask = \"sphere\"\nwas = \"{DISCRIMINANT}\"\nbecomes = \"{becomes}\"\n\
         differs = \"{differs}\"\nwhy = \"…\"\n"
    )
}

#[test]
fn escaped_mutant_is_a_fault_unless_listed_as_equivalent() {
    let _alone = MUTANTS.lock().unwrap_or_else(PoisonError::into_inner);
    let course = assignment("escaped");
    let only_these = ["--only", "mutants", "--named", &of_the_discriminant()];
    let never = listed("if false {", "nowhere");
    let ties = listed("if discriminant <= 0.0 {", "ties");

    write(&course, "equivalent.toml", &never);
    let ran = validate(&course, &only_these).expect_code(1);
    let ran = ran.expect_out("  - if discriminant < 0.0 {\n  + if discriminant <= 0.0 {\n");
    let ran = ran.expect_out("answers differ on 0 of ");
    ran.expect_out("2 targets are missed");

    let wrongly = listed("if discriminant == 0.0 {", "nowhere");
    write(&course, "equivalent.toml", &[never, ties, wrongly].concat());
    let ran = validate(&course, &only_these).expect_code(1);
    let ran =
        ran.expect_out("✗ listed in equivalent.toml, which claims other differences: sphere.rs:");
    ran.expect_out("1 target is missed");
}

#[test]
fn wrong_and_outdated_entries_in_the_list_of_mutants_are_named() {
    let _alone = MUTANTS.lock().unwrap_or_else(PoisonError::into_inner);
    let course = assignment("out-of-step");
    let only_these = ["--only", "mutants", "--named", &of_the_discriminant()];
    let caught = listed("if discriminant > 0.0 {", "nowhere");
    let gone = listed("if discriminant < 7.0 {", "nowhere");
    let others = read("equivalent.toml");
    write(&course, "equivalent.toml", &[caught, gone, others].concat());
    let ran = validate(&course, &only_these).expect_code(1);
    let ran = ran.expect_out("✗ listed in equivalent.toml, but caught by sphere.outside");
    let gone =
        "✗ listed in equivalent.toml, but no longer a mutant of sphere: if discriminant < 7.0 {";
    let ran = ran.expect_out(gone);
    ran.expect_out("2 targets are missed");
}

/// A belief about the plane as one edit of the reference.
fn edit(mistake: &str, was: &str, becomes: &str) -> String {
    let task = mistake.split('_').next().expect("it begins with the task");
    format!(
        "[[belief]]\ntask = {task:?}\nmistake = {mistake:?}\nedits = [[{was:?}, {becomes:?}]]\n"
    )
}

#[test]
fn two_beliefs_in_one_answer_are_both_named_and_their_edits_must_fit() {
    let course = assignment("pairs");
    let only_these = ["--only", "pairs", "--json", "--named", "plane"];
    let long = edit(
        "plane_normal_not_unit",
        "self.normal.normalize()",
        "self.normal",
    );
    let near = edit("plane_ignores_min_t", "(t >= min_t)", "true");
    write(&course, "pairs.toml", &[long.as_str(), &near].concat());
    let pairs = &validate(&course, &only_these).expect_code(0).json()["pairs"];
    assert_eq!(pairs["both"], 1, "{pairs:#}");
    assert_eq!(pairs["sentences"]["told"], 1, "{pairs:#}");

    // These edits don't do what the name says.
    let misnamed = edit("plane_one_sided", "(t >= min_t)", "true");
    write(&course, "pairs.toml", &[long.as_str(), &misnamed].concat());
    let ran = validate(&course, &["--only", "pairs"]).expect_code(1);
    ran.expect_out("✗ false name: ");

    // Names of beliefs that give the same answers are right, if the file lists them.
    let least = edit(
        "triangle_min_t_as_distance",
        "(t >= min_t)",
        "(t * ray.direction.length() >= min_t)",
    );
    let distance = edit(
        "triangle_t_is_distance",
        "t,\n            normal",
        "t: t * ray.direction.length(),\n normal",
    );
    let same_as = |other: &str| {
        let pair = format!("beliefs = [\"triangle_min_t_as_distance\", \"{other}\"]");
        format!("[[pair]]\n{pair}\nsame_as = [\"triangle_direction_normalised\"]\n")
    };
    let both = least + &distance;
    for (text, code) in [
        (both.clone(), 1),
        (both.clone() + &same_as("triangle_t_is_distance"), 0),
        (both + &same_as("triangle_one_sided"), 2),
    ] {
        write(&course, "pairs.toml", &text);
        validate(&course, &["--only", "pairs"]).expect_code(code);
    }

    let gone = edit("plane_tests_zero", "(t >= maximum)", "(t >= 0.0)");
    write(&course, "pairs.toml", &[long, gone].concat());
    let ran = validate(&course, &only_these).expect_code(2);
    assert!(
        ran.out.contains("does not contain this exactly once"),
        "{}",
        ran.out
    );
}

#[test]
fn a_scene_detects_small_errors_of_every_kind_that_it_can_have() {
    let ran = pinhole(&[
        "validate",
        "--only",
        "sensitivity",
        "--named",
        "lone",
        "--json",
    ]);
    let document = ran.expect_code(0).json();
    let least = &document["sensitivity"][0]["least"];
    for kind in ["camera_shift", "t", "normal_tilt"] {
        let smallest = least[kind].as_f64().expect("it is detected");
        assert!(smallest < 1e-2, "{kind}: {least:#}");
    }
    assert!(
        least.get("focal_length").is_none(),
        "an orthographic camera has none"
    );
}
