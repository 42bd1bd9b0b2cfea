//! The grading is graded: what has a wrong verdict is named, whatever it is.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use pinhole_testing::{Ran, fresh, pinhole, root, trusted};

/// A copy of the assignment without mistakes, variants or listed mutants.
fn assignment(name: &str) -> PathBuf {
    let own = root().join("assignments/ray_casting");
    let copy = fresh(&trusted(), name).join("ray_casting");
    for folder in ["reference/src", "scenes/meshes"] {
        fs::create_dir_all(copy.join(folder)).expect("a folder can be made");
    }
    for folder in ["", "reference", "reference/src", "scenes", "scenes/meshes"] {
        let entries = fs::read_dir(own.join(folder))
            .expect("it can be read")
            .flatten();
        for file in entries
            .map(|entry| entry.path())
            .filter(|path| path.is_file())
        {
            let name = file.file_name().expect("a file has a name");
            fs::copy(&file, copy.join(folder).join(name)).expect("it can be copied");
        }
    }
    let _had_none = fs::remove_file(copy.join("equivalent.toml"));
    copy
}

fn write(folder: &Path, file: &str, text: &str) {
    let path = folder.join(file);
    fs::create_dir_all(path.parent().expect("it is in a folder")).expect("it can be made");
    fs::write(path, text).expect("it can be written");
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join("assignments/ray_casting").join(file)).expect("it is there")
}

fn validate(assignment: &Path, arguments: &[&str]) -> Ran {
    let folder = assignment.to_str().expect("a plain name");
    pinhole(&[&["validate", folder], arguments].concat())
}

/// A course with everything in it that can be wrong with a submission.
fn wrong_verdicts() -> &'static Ran {
    static RAN: OnceLock<Ran> = OnceLock::new();
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
        write(
            &course,
            "mistakes/plane_known/anew/harmless/plane.rs",
            &right,
        );
        write(&course, "mistakes/plane_known/anew/known/plane.rs", &wrong);
        write(&course, "variants/plane_wrong/plane.rs", &wrong);
        write(&course, "variants/plane_right/plane.rs", &right);
        validate(&course, &["--only", "mistakes", "--only", "variants"])
    })
}

#[track_caller]
fn is_named(fault: &str) {
    let Ran { code, out, err } = wrong_verdicts();
    assert_eq!(*code, 1, "{out}\n{err}");
    assert!(out.contains(fault), "no {fault:?} in:\n{out}\n{err}");
}

#[test]
fn a_mistake_that_passes_everything_is_missed() {
    is_named("✗ missed: mistakes/plane_harmless passes everything\n");
}

#[test]
fn a_mistake_that_fails_in_another_task_than_it_declares_is_named() {
    is_named("✗ mistakes/plane_elsewhere is declared to fail in sphere, and fails in plane\n");
}

#[test]
fn a_mistake_that_does_not_compile_shows_nothing() {
    is_named("✗ mistakes/plane_broken does not compile: plane\n");
}

#[test]
fn a_belief_written_anew_must_fail_as_well() {
    is_named("✗ missed: mistakes/plane_known/anew/harmless passes everything\n");
}

#[test]
fn a_variant_that_loses_a_point_is_a_false_fail() {
    is_named("✗ false fail: variants/plane_wrong fails plane.");
}

#[test]
fn what_has_the_right_verdict_is_no_fault() {
    let out = &wrong_verdicts().out;
    let faults: Vec<&str> = out
        .lines()
        .take_while(|line| !line.starts_with("✓"))
        .collect();
    let faults = faults.join("\n");
    assert!(!faults.contains("plane_right"), "{faults}");
    assert!(!faults.contains("mistakes/plane_known "), "{faults}");
    assert!(!faults.contains("anew/known"), "{faults}");
    // Five wrong verdicts, and none of the beliefs gets its name.
    assert!(out.contains("6 targets are missed"), "{out}");
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

/// The line of the sphere that three mutants leave without an effect: never true, and
/// with `<=` or `==` true for tangent rays too, which are ties.
const DISCRIMINANT: &str = "if discriminant < 0.0 {";

/// The name of what is changed in that line.
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
fn a_mutant_that_escapes_is_missed_unless_it_is_listed_as_what_it_is() {
    let course = assignment("escaped");
    let only_these = ["--only", "mutants", "--named", &of_the_discriminant()];
    let never = listed("if false {", "nowhere");
    let ties = listed("if discriminant <= 0.0 {", "ties");

    write(&course, "equivalent.toml", &never);
    let ran = validate(&course, &only_these).expect_code(1);
    let ran = ran.expect_out("  - if discriminant < 0.0 {\n  + if discriminant <= 0.0 {\n");
    let ran = ran.expect_out("answers otherwise: 0 of ");
    ran.expect_out("2 targets are missed");

    let wrongly = listed("if discriminant == 0.0 {", "nowhere");
    write(&course, "equivalent.toml", &[never, ties, wrongly].concat());
    let ran = validate(&course, &only_these).expect_code(1);
    let ran = ran.expect_out("✗ listed otherwise: sphere.rs:");
    ran.expect_out("1 target is missed");
}

#[test]
fn a_list_of_mutants_that_is_out_of_step_is_named() {
    let course = assignment("out-of-step");
    let only_these = ["--only", "mutants", "--named", &of_the_discriminant()];
    let caught = listed("if discriminant > 0.0 {", "nowhere");
    let gone = listed("if discriminant < 7.0 {", "nowhere");
    let others = read("equivalent.toml");
    write(&course, "equivalent.toml", &[caught, gone, others].concat());
    let ran = validate(&course, &only_these).expect_code(1);
    let ran = ran.expect_out("✗ listed, but caught by sphere.outside");
    let ran = ran.expect_out("✗ listed, but no longer a mutant of sphere: if discriminant < 7.0 {");
    ran.expect_out("2 targets are missed");
}

#[test]
fn every_scene_detects_less_than_the_suites_that_allow_pixels_to_differ() {
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
        let ours = least[kind]["ours"].as_f64().expect("it is detected");
        let blender = least[kind]["suites"][0]
            .as_f64()
            .expect("so is a large error");
        assert!(ours < 1e-2 && ours * 2.0 < blender, "{kind}: {least:#}");
    }
    assert!(
        least["focal_length"].is_null(),
        "an orthographic camera has none"
    );
}
