//! `pinhole doctor` on this machine, and on one that lacks everything.

use pinhole_testing::{fresh, pinhole, pinhole_in, pinhole_with, trusted};
use serde_json::Value;

fn finding<'a>(document: &'a Value, name: &str) -> &'a Value {
    let findings = document["findings"].as_array().expect("a list");
    let named = |finding: &&Value| finding["name"] == name;
    findings.iter().find(named).expect("it is looked for")
}

#[test]
fn the_doctor_finds_what_these_tests_use() {
    let document = pinhole(&["doctor", "--json"]).expect_code(0).json();
    for name in [
        "Rust", "linker", "space", "sandbox", "Landlock", "seccomp", "Mitsuba", "oiiotool",
    ] {
        let finding = finding(&document, name);
        assert_eq!(finding["is_there"], true, "{finding}");
        assert_eq!(finding["remedy"], Value::Null, "{finding}");
    }
}

#[test]
fn the_doctor_runs_no_python_of_the_current_folder() {
    let folder = fresh(&trusted(), "doctor");
    let module = "open('ran', 'w')";
    std::fs::write(folder.join("importlib.py"), module).expect("there is room");
    std::fs::write(folder.join("random.py"), module).expect("there is room");
    let document = pinhole_in(&folder, &["doctor", "--json"]).json();
    assert_eq!(finding(&document, "Mitsuba")["is_there"], true);
    assert!(!folder.join("ran").exists());
}

#[test]
fn the_doctor_says_what_is_missing_what_it_is_for_and_how_to_get_it() {
    // Programs are searched for in `PATH`, and this one has none.
    let nowhere = [("PATH", "/nowhere"), ("RUSTC", "/nowhere/rustc")];
    let document = pinhole_with(&nowhere, &["doctor", "--json"])
        .expect_code(3)
        .json();
    for name in ["Rust", "linker"] {
        let finding = finding(&document, name);
        assert_eq!(finding["is_there"], false, "{finding}");
        assert!(finding["remedy"].is_string(), "{finding}");
    }
    // The sandbox is not to blame for the missing compiler.
    let sandbox = finding(&document, "sandbox");
    assert_eq!(sandbox["found"], "cannot ask rustc for its folder");
    assert_eq!(sandbox["remedy"], "install Rust from rustup.rs");
    let ran = pinhole_with(&nowhere, &["doctor"]).expect_code(3);
    assert!(
        ran.out.contains("missing  linker    cannot start cc"),
        "{}",
        ran.out
    );
    assert!(
        ran.out.contains("required: used to compile answers"),
        "{}",
        ran.out
    );
}
