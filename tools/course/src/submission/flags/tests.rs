use super::of_text;

fn whats(text: &str) -> Vec<String> {
    of_text("plane", text)
        .into_iter()
        .map(|flag| flag.what)
        .collect()
}

#[test]
fn each_way_out_of_an_answer_is_flagged_with_its_line() {
    let cases = [
        ("fn f() { unsafe { g() } }", "unsafe"),
        ("unsafe impl Send for A {}", "unsafe"),
        (
            "const A: &str = include_str!(\"/etc/passwd\");",
            "include_str!",
        ),
        (
            "const A: &[u8] = core::include_bytes!(\"a\");",
            "include_bytes!",
        ),
        ("compile_error!(include_str!(\"a\"));", "include_str!"),
        ("use std::include_str as i; i!(\"a\");", "i!"),
        ("const A: &str = env!(\"HOME\");", "env!"),
        (
            "const A: Option<&str> = option_env!(\"HOME\");",
            "option_env!",
        ),
        ("fn f() { core::arch::asm!(\"nop\"); }", "asm!"),
        ("fn f() { std::process::exit(0) }", "std::process"),
        ("use std::{cmp::Ordering, fs::{self, File}};", "std::fs"),
        ("use {std::net::TcpStream};", "std::net"),
        ("use ::std::env;", "std::env"),
        (
            "use std as s; fn f() { s::fs::read(\"a\"); }",
            "std by another name",
        ),
        ("extern crate std as s;", "extern"),
        ("use std::*; fn f() { fs::read(\"a\"); }", "std::*"),
        ("fn f() { std::thread::spawn(|| ()); }", "std::thread"),
        ("#[path = \"/etc/passwd\"] mod a;", "#[path]"),
        ("#[cfg_attr(all(), path = \"a\")] mod a;", "#[cfg_attr]"),
        ("thread_local! { static A: u8 = 0; }", "thread_local!"),
        ("mod a;", "mod of another file"),
        ("extern \"C\" { fn kill(a: i32, b: i32); }", "extern"),
        ("#[unsafe(no_mangle)] fn main() {}", "unsafe"),
        ("macro_rules! a { () => { include!(\"b\") } }", "include!"),
        ("macro_rules! a { () => {} }", "macro_rules!"),
        ("vec![std::fs::read(\"a\")];", "std::fs"),
        ("static mut A: u32 = 0;", "static mut"),
        (
            "fn f() { std::mem::transmute::<u32, f32>(0); }",
            "transmute",
        ),
        ("use pinhole::{Ray, job::Job};", "pinhole::job"),
    ];
    for (text, expected) in cases {
        assert!(
            whats(text).contains(&expected.to_owned()),
            "{text}: {:?}",
            whats(text)
        );
    }
    assert_eq!(of_text("plane", "\n\nuse std::fs;")[0].line, 3);
}

#[test]
fn comments_strings_and_ordinary_code_are_not_flagged() {
    for text in [
        "// unsafe { std::fs::read() }\n/* include_str!(\"a\") */",
        "const A: &str = \"unsafe std::process include!()\";",
        "const A: &str = r#\"env!(\"HOME\")\"#;",
        "use std::cmp::Ordering; use std::f64::consts::PI; use std::mem::swap;",
        "use pinhole::{Ray, Intersection, Sphere}; use glam::DVec3;",
        "fn path(env: f64) -> f64 { let fs = env * 2.0; fs }",
        "mod own { pub fn f() {} }",
        "fn f() { self.path = 3; process::go(); }",
        "#[derive(Clone)] struct A { link: u32 }",
    ] {
        assert_eq!(whats(text), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn deep_nesting_does_no_harm() {
    for text in [
        "(".repeat(100_000),
        "-".repeat(200_000),
        "use a::{".repeat(20_000),
    ] {
        of_text("plane", &text);
    }
    let closed = format!("{}1{}", "(".repeat(100_000), ")".repeat(100_000));
    of_text("plane", &format!("const A: i32 = {closed};"));
    let paths = format!(
        "use {}std::fs{};",
        "a::{".repeat(20_000),
        "}".repeat(20_000)
    );
    of_text("plane", &paths);
}

#[test]
fn a_table_of_results_is_flagged() {
    let table = "1.25, ".repeat(400);
    assert_eq!(
        whats(&format!("const A: [f64; 400] = [{table}];")),
        ["401 number literals"]
    );
}

#[test]
#[cfg(target_os = "linux")]
fn paths_behind_long_words_take_little_memory() {
    use rustix::time::ClockId;

    let most = || -> usize {
        let status = std::fs::read_to_string("/proc/self/status").expect("Linux has it");
        let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = most.and_then(|text| text.split_whitespace().next());
        kib.expect("a line of its own").parse().expect("a number")
    };
    let word = "x".repeat(30_000);
    let behind = format!("use {}", format!("{word}::").repeat(4));
    let before = most();
    let nested = "{a::".repeat(20_000) + "b" + &"}".repeat(20_000);
    of_text("plane", &format!("{behind}{nested};"));
    let listed = format!("{behind}{{{}}};", ",".repeat(100_000));
    let processor_seconds = || rustix::time::clock_gettime(ClockId::ThreadCPUTime).tv_sec;
    let start = processor_seconds();
    of_text("plane", &listed);
    // The kernel's count may be a little behind, and so fall.
    let (took, more) = (processor_seconds() - start, most().saturating_sub(before));
    assert!(more < 200 << 10, "{more} KiB");
    assert!(took < 2, "{took} s");
}
