//! A student's answers among the study's kernels.

use std::fs;

use serde_json::Value;

use pinhole_testing::{fresh, pinhole, root, submission, trusted};

#[test]
fn a_students_answers_stand_among_the_kernels_and_what_they_leave_open_is_told() {
    let mistake = root().join("assignments/ray_casting/mistakes/sphere_near_root_only/sphere.rs");
    let near_root = fs::read_to_string(mistake).expect("the mistake is there");
    let stub = root().join("assignments/ray_casting/handout/src/triangle.rs");
    let stub = fs::read_to_string(stub).expect("the handout is there");
    // Outside the checkout: behind walls.
    let theirs = submission(
        &std::env::temp_dir(),
        "study",
        &[("sphere.rs", &near_root), ("triangle.rs", &stub)],
    );
    let plane = theirs.join("plane.rs");
    let text = fs::read_to_string(&plane).expect("the reference has a plane");
    let start = "-> Option<Intersection> {\n";
    let panics = format!("{start}if min_t > 0.0 {{ panic!(\"never above zero\"); }}\n");
    fs::write(&plane, text.replacen(start, &panics, 1)).expect("it can be written");

    let out = fresh(&trusted(), "study-out");
    let told = pinhole(&[
        "study",
        "--submission",
        theirs.to_str().expect("plain"),
        "--only",
        "surface",
        "--out",
        out.to_str().expect("plain"),
        "--json",
    ]);
    let study = told.json();
    let near = wrong_share(&study, "yours");
    let textbook = wrong_share(&study, "textbook");
    assert!(near > 0.3 && textbook < 0.05, "{near} {textbook}");
    let problems = study["problems"].to_string();
    for problem in [
        "never above zero",
        "unanswered (triangle, corners of closed meshes; ",
    ] {
        assert!(problems.contains(problem), "no {problem:?} in {problems}");
    }
    let plot = fs::read_to_string(out.join("sphere-surface.svg")).expect("it is drawn");
    assert!(plot.contains("yours"), "the plot does not show them");
    let page = fs::read_to_string(out.join("summary.md")).expect("it is written");
    assert!(page.contains("## Where yours stands"), "{page}");
    let _done = fs::remove_dir_all(theirs);
}

/// Of a kernel's decisions in `f64`, over the whole sweep.
fn wrong_share(study: &Value, kernel: &str) -> f64 {
    let all = study["breaking"].as_array().expect("a list");
    let of_it = all
        .iter()
        .find(|b| b["kernel"] == kernel && b["numbers"] == "f64" && b["family"] == "surface");
    let of_it = of_it.unwrap_or_else(|| panic!("no {kernel} in {all:?}"));
    let number = |name: &str| of_it[name].as_f64().expect("a number");
    number("wrong") / number("asked")
}
