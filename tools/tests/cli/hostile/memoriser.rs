//! An answer that has learnt the public goldens by heart.

use std::collections::BTreeSet;

use super::{examine, scratch, walls};
use crate::check::{lost, task, with_body};
use crate::course::{pinhole, submission};

/// What an answer can learn of a question: one number of its ray tells it from others.
const NUMBER: &str =
    "(ray.origin + ray.direction * 1.7 + self.point * 0.3).dot(pinhole_salt()).to_bits()";
const SALT: &str = "fn pinhole_salt() -> glam::DVec3 { glam::DVec3::new(0.31, 0.77, 1.13) }";

#[test]
fn what_was_learnt_by_heart_is_worth_nothing_on_fresh_questions() {
    // The first hand-in says what it is asked; a course that shows its output is an oracle.
    let listens = with_body("plane", &format!("eprintln!(\"asked {{}}\", {NUMBER});"));
    let folder = submission(
        &std::env::temp_dir(),
        "listener",
        &[("plane.rs", &(listens + SALT))],
    );
    let heard = examine(&folder, &walls());
    let printed = heard["printed"].as_str().expect("text");
    let numbers = printed
        .lines()
        .filter_map(|line| line.strip_prefix("asked ")?.parse::<u64>().ok());
    let known: BTreeSet<u64> = numbers.collect();
    assert!(known.len() > 20, "it heard only {} questions", known.len());

    // The second is right where it knows the question, and nowhere else.
    let table: Vec<String> = known.iter().map(u64::to_string).collect();
    let knows = with_body(
        "plane",
        &format!(
            "const KNOWN: [u64; {}] = [{}]; if KNOWN.binary_search(&{NUMBER}).is_err() {{ return None; }}",
            known.len(),
            table.join(", ")
        ),
    );
    let folder = submission(
        &std::env::temp_dir(),
        "memoriser",
        &[("plane.rs", &(knows + SALT))],
    );
    let public = examine(&folder, &walls());
    assert_eq!(
        lost(&public, "plane"),
        0,
        "it has not learnt all: {public:#}"
    );

    let fresh = scratch("fresh-goldens");
    let fresh = fresh.to_str().expect("a plain name");
    pinhole(&[
        "golden",
        "render",
        "--seed",
        "4711",
        "--out",
        fresh,
        "--no-mistakes",
    ])
    .expect_code(0);
    let name = folder.to_str().expect("a plain name");
    let judged = pinhole(&[
        "check",
        name,
        "--task",
        "plane",
        "--golden",
        fresh,
        "--json",
        "--no-report",
        "--sandbox",
        &walls(),
    ]);
    let judged = judged.expect_code(1).json();
    let plane = task(&judged, "plane");
    let earned = plane["points"].as_i64().expect("a number");
    let possible = plane["possible"].as_i64().expect("a number");
    // A group whose right answers are all misses asks nothing that must be known.
    assert!(earned * 4 <= possible, "{plane:#}");
}
