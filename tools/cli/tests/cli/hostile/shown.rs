//! Text from attacks, in every place where people read it.

use std::fs;

use super::{scratch, walls};
use crate::check::with_body;
use pinhole_testing::{pinhole, root, submission};

const EVIL: &str = "<script>alert(1)</script><img src=x onerror=alert(2)>\u{1b}[2J\u{1b}]0;owned\u{7}\u{202e}\r\n=HYPERLINK(1)";

/// Checks that `text` contains nothing that a terminal or a browser would obey.
#[track_caller]
fn is_tame(text: &str, what: &str) {
    for order in ["\u{1b}[2J", "\u{1b}]0;", "\u{7}", "\u{202e}"] {
        assert!(!text.contains(order), "{what} holds {order:?}");
    }
}

#[track_caller]
fn is_tame_page(page: &str) {
    for order in ["<script>alert", "<img src=x"] {
        assert!(!page.contains(order), "the page holds {order:?}");
    }
    is_tame(page, "the page");
}

#[test]
fn answer_output_cannot_control_a_terminal_or_a_browser() {
    let panics = with_body(
        "plane",
        &format!("eprintln!({EVIL:?}); println!({EVIL:?}); panic!({EVIL:?});"),
    );
    let refuses = format!("compile_error!({EVIL:?});");
    let named = format!("fn f() {{ let a: {} = 1; }}", "u\u{202e}8");
    for text in [panics, refuses, named] {
        let folder = submission(
            &std::env::temp_dir(),
            "hostile-words",
            &[("plane.rs", &text)],
        );
        let report = scratch("hostile-report").join("report.html");
        let (name, page) = (
            folder.to_str().expect("plain"),
            report.to_str().expect("plain"),
        );
        let ran = pinhole(&[
            "check",
            name,
            "--task",
            "plane",
            "--sandbox",
            &walls(),
            "--report",
            page,
        ]);
        let ran = ran.expect_code(1);
        is_tame(&ran.out, "the table");
        is_tame(&ran.err, "standard error");
        is_tame_page(&fs::read_to_string(&report).expect("a report was written"));
        fs::remove_dir_all(folder).expect("it was made");
    }
}

#[test]
fn folder_name_cannot_control_a_terminal_or_a_browser() {
    for name in [
        "$(touch owned); `id` & | > 'x' \"y\"",
        "<script>alert(1)<",
        "=1+1,@SUM(A1)",
        "-rf",
        "--trust",
        "new\nline\u{1b}[2J\u{202e}",
        "ünïcödé 学生",
    ] {
        let plain = submission(&std::env::temp_dir(), "hostile-name", &[]);
        let folder = scratch("hostile-names").join(name);
        fs::rename(&plain, &folder).expect("it can be renamed");
        let report = scratch("hostile-report-name").join("report.html");
        let (path, page) = (
            folder.to_str().expect("UTF-8"),
            report.to_str().expect("plain"),
        );
        let ran = pinhole(&[
            "check",
            path,
            "--task",
            "plane",
            "--sandbox",
            &walls(),
            "--report",
            page,
        ]);
        let ran = ran.expect_code(0);
        is_tame(&ran.out, "the table");
        is_tame_page(&fs::read_to_string(&report).expect("a report was written"));
        let json = pinhole(&["check", path, "--task", "plane", "--json", "--no-report"]);
        assert_eq!(json.expect_code(0).json()["submission"], path);
    }
}

#[test]
fn compiler_names_no_folder_of_the_graders_machine() {
    // The notes of these errors point into glam and the harness.
    let wrong = "fn f() { let _ = glam::DVec3::new(1, 2); \
                 let _ = pinhole::Sphere::nothing(); let _ = pinhole::ray::Ray::clone(7); }";
    let text = with_body("plane", "") + wrong;
    let folder = submission(
        &std::env::temp_dir(),
        "hostile-paths",
        &[("plane.rs", &text)],
    );
    let examination = super::examine(&folder, &walls());
    let said = crate::check::task(&examination, "plane")["file"]["compiler"].to_string();
    assert!(said.contains("/glam-"), "no note points into glam: {said}");
    let home = std::env::var("HOME").expect("HOME is set");
    for place in [root().display().to_string(), home + "/.cargo"] {
        assert!(!said.contains(&place), "{place} was shown: {said}");
    }
    fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn suspicious_code_is_flagged_and_costs_nothing() {
    let text = with_body(
        "plane",
        "let _ = std::env::var(\"HOME\"); // unsafe\nlet _ = std::fs::read(\"unsafe\");",
    );
    let folder = submission(
        &std::env::temp_dir(),
        "hostile-flags",
        &[("plane.rs", &text)],
    );
    let examination = super::examine(&folder, &walls());
    assert_eq!(crate::check::lost(&examination, "plane"), 0);
    let flags = examination["flags"].as_array().expect("a list");
    let whats: Vec<&str> = flags
        .iter()
        .map(|flag| flag["what"].as_str().expect("text"))
        .collect();
    assert_eq!(whats, ["std::env", "std::fs"]);
    let line = text
        .lines()
        .position(|line| line.contains("std::fs"))
        .expect("it is there")
        + 1;
    assert_eq!(flags[1]["line"], line);
    fs::remove_dir_all(folder).expect("it was made");
}
