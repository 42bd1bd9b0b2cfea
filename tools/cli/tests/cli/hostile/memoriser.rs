//! An answer that knows the public goldens by heart.

use std::collections::BTreeSet;

use super::{examine, walls};
use crate::check::{lost, task, with_body};
use pinhole_testing::{fresh_goldens, pinhole, submission};

/// The key by which an answer recognises a question: one short number of its ray, so that all
/// keys fit into the output that is kept.
const NUMBER: &str = "pinhole_short(ray.origin + ray.direction * 1.7 + self.point * 0.3)";
const SHORT: &str = "fn pinhole_short(at: glam::DVec3) -> u32 { \
     let bits = at.dot(glam::DVec3::new(0.31, 0.77, 1.13)).to_bits(); (bits ^ (bits >> 29)) as u32 }";

#[test]
fn memorised_answers_earn_nothing_on_fresh_questions() {
    // The first submission prints the questions. A course that shows this output gives them away.
    let listens = with_body("plane", &format!("eprintln!(\"?{{:x}}\", {NUMBER});"));
    let folder = submission(
        &std::env::temp_dir(),
        "listener",
        &[("plane.rs", &(listens + SHORT))],
    );
    let heard = examine(&folder, &walls());
    let printed = heard["printed"].as_str().expect("text");
    let numbers = printed
        .lines()
        .filter_map(|line| u32::from_str_radix(line.strip_prefix('?')?, 16).ok());
    let known: BTreeSet<u32> = numbers.collect();
    assert!(known.len() > 20, "it heard only {} questions", known.len());

    // The second submission is right only about the questions that it knows.
    let table: Vec<String> = known.iter().map(u32::to_string).collect();
    let knows = with_body(
        "plane",
        &format!(
            "const KNOWN: [u32; {}] = [{}]; if KNOWN.binary_search(&{NUMBER}).is_err() {{ return None; }}",
            known.len(),
            table.join(", ")
        ),
    );
    let folder = submission(
        &std::env::temp_dir(),
        "memoriser",
        &[("plane.rs", &(knows + SHORT))],
    );
    let public = examine(&folder, &walls());
    assert_eq!(
        lost(&public, "plane"),
        0,
        "it has not learnt all: {public:#}"
    );

    let fresh = fresh_goldens();
    let fresh = fresh.to_str().expect("a plain name");
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
    // A group whose right answers are all misses can be answered without memory.
    assert!(earned * 4 <= possible, "{plane:#}");
}
