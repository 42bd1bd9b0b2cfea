use std::fs;
use std::path::{Path, PathBuf};

use super::{Verdict, verdict};

fn refusal(text: &str) -> Option<String> {
    match verdict("src/plane.rs", text) {
        Verdict::Refused(why) => Some(why),
        _ => None,
    }
}

#[test]
fn names_that_could_hold_machine_code_or_read_a_file_are_refused() {
    for (text, what) in [
        ("#[unsafe(naked)] extern \"C\" fn f() {}", "`#[unsafe]`"),
        (
            "#[unsafe(link_section = \".init_array\")] static A: u8 = 0;",
            "`#[unsafe]`",
        ),
        ("#[no_mangle] fn malloc() {}", "`#[no_mangle]`"),
        ("#[export_name = \"a\"] fn f() {}", "`#[export_name]`"),
        (
            "#[cfg_attr(all(), unsafe(naked))] fn f() {}",
            "`#[cfg_attr]`",
        ),
        ("#[path = \"/etc/passwd\"] mod a;", "`#[path]`"),
        ("#![feature(naked_functions)]", "`#[feature]`"),
        ("#[ unsafe /* */ (naked)] fn f() {}", "`#[unsafe]`"),
        ("#[rustfmt] fn f() {}", "`#[rustfmt]`"),
        ("#[inline::naked] fn f() {}", "`#[inline]`"),
        ("std::arch::naked_asm!(\"syscall\")", "`naked_asm!`"),
        ("core::arch::global_asm ! {\"nop\"}", "`global_asm!`"),
        ("fn f() { asm![\"nop\"] }", "`asm!`"),
        (
            "const A: &[u8] = include_bytes!(\"/dev/ptmx\");",
            "`include_bytes!`",
        ),
        ("vec![include_str!(\"/etc/passwd\")];", "`include_str!`"),
        ("#[doc = include_str!(\"a\")] fn f() {}", "`include_str!`"),
        ("include!(\"a\");", "`include!`"),
        ("const A: &str = env!(\"HOME\");", "`env!`"),
        (
            "const A: Option<&str> = option_env!(\"HOME\");",
            "`option_env!`",
        ),
        // These could put a forbidden name together from parts.
        (
            "macro_rules! a { ($a:tt $b:tt) => { $a $b } }",
            "`macro_rules!`",
        ),
        (
            "use std::arch::global_asm as println; println!(\"nop\");",
            "another meaning of `println`",
        ),
        (
            "use std::arch::{global_asm as vec}; vec!(\"nop\");",
            "another meaning of `vec`",
        ),
        (
            "use std::arch::global_asm as r#return; r#return!(\"nop\");",
            "`r#return`",
        ),
        ("#!/* \n#[unsafe(naked)] fn f() {} // */", "a first line"),
        ("\u{feff}#! /*", "a first line"),
        (
            "\n--- x\n/*\n---\n// */ include_str!(\"a\")",
            "a first line",
        ),
        ("a! { # a }", "`a!`"),
        ("vec! { # # [inline] }", "`#`"),
    ] {
        let why = refusal(text).unwrap_or_else(|| panic!("{text} is allowed"));
        let first = why.lines().next().unwrap_or_default();
        assert!(first.contains(what), "{text}: {why}");
    }
}

#[test]
fn a_refusal_names_file_line_and_remedy() {
    let why = refusal("\n\n  #[unsafe(naked)] fn f() {}").expect("it is refused");
    assert_eq!(
        why,
        "error: `#[unsafe]` is not allowed in an answer\n --> src/plane.rs:3\n  \
         = help: remove the attribute\n"
    );
}

#[test]
fn ordinary_code_is_allowed() {
    for text in [
        "//! Doc.\n#![allow(dead_code)]\n/// Doc.\n#[derive(Clone, Debug)] struct A;",
        "#[rustfmt::skip] #[must_use] fn f() -> bool { return !(a && b) }",
        "fn f() { if !(a) && b != c { while !{ d } { break !(e) } } }",
        "#[cfg(test)] mod tests { use super::*; #[test] fn f() { assert_eq!(1, 1); } }",
        "fn f(x: f64) -> usize { let a = vec![0; 3]; println!(\"{a:?}\"); x as usize }",
        "use glam::DVec3 as V; use std::fmt::Write as _; // #[unsafe(naked)] asm!()",
        "const A: &str = \"include_str!()\"; fn f() { matches!(a, Some(_)); todo!() }",
        "fn f() -> bool { 'out: loop { break 'out !{ g() } } }",
    ] {
        assert_eq!(verdict("plane", text), Verdict::Allowed, "{text}");
    }
    assert_eq!(verdict("plane", "fn f( {"), Verdict::NotTokens);
}

/// Every `.rs` file under a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path());
    let found = paths.map(|path| match path.is_dir() {
        true => sources(&path),
        false if path.extension().is_some_and(|end| end == "rs") => vec![path],
        false => Vec::new(),
    });
    found.flatten().collect()
}

#[test]
fn every_answer_of_the_course_is_allowed() {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let courses = ["../assignments", "instructor/tests/fixture/assignments"];
    let assignments = courses.map(|course| fs::read_dir(tools.join(course)).expect("a course"));
    let assignments = assignments.into_iter().flatten().flatten();
    let kinds = ["reference", "handout", "mistakes", "variants"];
    let folders = assignments.flat_map(|one| kinds.map(|kind| one.path().join(kind).to_owned()));
    let answers: Vec<PathBuf> = folders.flat_map(|folder| sources(&folder)).collect();
    assert!(answers.len() > 100, "{}", answers.len());
    for path in answers {
        // The harness's side of a program is ours, so it may use more.
        let text = fs::read_to_string(&path).expect("it is text");
        assert_eq!(verdict("a", &text), Verdict::Allowed, "{}", path.display());
    }
}

#[test]
fn deep_nesting_does_no_harm() {
    for text in ["-".repeat(200_000), "#".repeat(200_000)] {
        verdict("plane", &text);
    }
    let closed = format!("{}1{}", "(".repeat(100_000), ")".repeat(100_000));
    assert_eq!(
        verdict("plane", &format!("const A: i32 = {closed};")),
        Verdict::Allowed
    );
}

#[test]
fn a_long_word_makes_no_long_message() {
    let word = "é".repeat(100_000);
    for text in [
        format!("fn f() {{ {word}!() }}"),
        format!("#[{word}] fn f() {{}}"),
        format!("fn r#{word}() {{}}"),
    ] {
        match verdict("plane", &text) {
            Verdict::Refused(why) => assert!(why.len() < 400, "{} bytes", why.len()),
            other => panic!("{other:?}"),
        }
    }
}
