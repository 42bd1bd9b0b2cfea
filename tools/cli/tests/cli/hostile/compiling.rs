//! Attacks on the compiler, and through it.

use super::Fate::{self, File, Harmless, Walled};
use super::{
    SECRET, every_attack_fails_in_every_mode, every_attack_has_its_expected_outcome, file, walls,
};
use crate::modes;
use pinhole_testing::root;

const NO: Fate = File("does not compile");

#[test]
fn the_compiler_reads_no_file_and_knows_no_environment() {
    let golden = root().join("golden/ray_casting/manifest.toml");
    let reads = |text: &str| text.replace("%GOLDEN%", golden.to_str().expect("a plain name"));
    let attacks = [
        file(
            "include-golden",
            NO,
            &reads("const _: &str = include_str!(\"%GOLDEN%\");"),
        ),
        file(
            "tell-golden",
            NO,
            &reads("compile_error!(include_str!(\"%GOLDEN%\"));"),
        ),
        file(
            "tell-golden-by-macro",
            NO,
            &reads(
                "macro_rules! tell { ($a:expr) => { compile_error!($a); } } tell!(include_str!(\"%GOLDEN%\"));",
            ),
        ),
        file(
            "tell-users",
            NO,
            "compile_error!(include_str!(\"/etc/passwd\"));",
        ),
        file(
            "tell-environment",
            NO,
            "compile_error!(include_str!(\"/proc/self/environ\"));",
        ),
        file("golden-as-code", NO, &reads("include!(\"%GOLDEN%\");")),
        file(
            "users-as-module",
            NO,
            "#[path = \"/etc/passwd\"] mod users;",
        ),
        file(
            "golden-in-a-panic",
            NO,
            &reads("const _: () = panic!(\"{}\", include_str!(\"%GOLDEN%\"));"),
        ),
        file(
            "environment",
            NO,
            &format!("const _: &str = env!(\"{}\");", SECRET.0),
        ),
        file("home", NO, "const _: &str = env!(\"HOME\");"),
        file(
            "endless-file",
            NO,
            "const _: &[u8] = include_bytes!(\"/dev/zero\");",
        ),
        file(
            "own-folder-of-another",
            NO,
            "const _: &str = include_str!(\"../../plane.rs\");",
        ),
        file(
            "unsafe",
            NO,
            "fn f() { unsafe { *std::ptr::null_mut() = 1 } }",
        ),
        file(
            "assembly",
            NO,
            "fn f() { unsafe { std::arch::asm!(\"syscall\") } }",
        ),
        file(
            "foreign",
            NO,
            "unsafe extern \"C\" { fn kill(pid: i32, signal: i32) -> i32; }",
        ),
        file(
            "symbol",
            NO,
            "#[unsafe(no_mangle)] pub extern \"C\" fn malloc(_: usize) -> usize { 0 }",
        ),
        file(
            "allows-itself-unsafe",
            NO,
            "#[allow(unsafe_code)] fn f() { unsafe { *std::ptr::null_mut() = 1 } }",
        ),
        file(
            "linker",
            NO,
            "#[link(name = \"c\", kind = \"static\")] unsafe extern \"C\" {}",
        ),
        file(
            "feature",
            NO,
            "#![feature(rustc_attrs)] #[rustc_on_unimplemented] trait A {}",
        ),
        file(
            "takes-the-tests-part",
            NO,
            "impl IntersectRay for pinhole::Sphere { fn intersect_ray(&self, _: &Ray, _: f64) -> Option<Intersection> { None } }",
        ),
        file("harness-internals", Harmless, "use pinhole::job::Job as _;"),
    ];
    // File modes alone let every user read the list of users.
    every_attack_fails_in_every_mode(&attacks, |mode, attack| {
        mode == modes::WITHOUT_LANDLOCK && ["tell-users", "users-as-module"].contains(&attack)
    });
}

#[test]
fn a_compiler_that_would_never_end_is_killed() {
    let deep = |n: usize, open: &str, close: &str| {
        format!("const N: i32 = {}1{};", open.repeat(n), close.repeat(n))
    };
    let attacks = [
        file(
            "endless-constant",
            NO,
            "#[allow(long_running_const_eval)] const N: u64 = { let mut n = 0; loop { n += 1; if n == 0 { break n; } } };",
        ),
        file(
            "macro-recursion",
            NO,
            "#![recursion_limit = \"1000000\"] macro_rules! more { ($($a:tt)*) => { more!($($a)* $($a)*); } } more!(a);",
        ),
        file(
            "type-recursion",
            NO,
            "trait Deep { fn go(); } impl<T> Deep for T where (T, T): Deep { fn go() { <(T, T)>::go() } } fn f() { <u8 as Deep>::go(); }",
        ),
        file(
            "generic-recursion",
            NO,
            "fn deeper<T>(n: u32) { if n > 0 { deeper::<(T, T)>(n - 1); } } #[used] static F: fn(u32) = deeper::<u8>;",
        ),
        file(
            "huge-static",
            NO,
            "#[used] static HUGE: [u8; 1 << 46] = [1; 1 << 46];",
        ),
        file(
            "huge-constant",
            NO,
            "#[used] static HUGE: [u64; 1 << 33] = [7; 1 << 33];",
        ),
        file(
            "large-program",
            NO,
            "#[used] static LARGE: [u8; 200 << 20] = [1; 200 << 20];",
        ),
        file("deep-brackets", NO, &deep(50_000, "(", ")")),
        file("deep-signs", NO, &deep(120_000, "-", "")),
        // It is all on one line, which every error shows, so the messages take 30 MB.
        file("many-errors", NO, &"const N: A = b; ".repeat(400)),
        file(
            "one-long-error",
            NO,
            &format!("fn f() {{ let {}: u8 = \"\"; }}", "x".repeat(200_000)),
        ),
    ];
    every_attack_has_its_expected_outcome(&attacks, &walls());
}

#[test]
fn without_a_sandbox_the_compiler_sees_files_and_environment() {
    let golden = root().join("golden/ray_casting/manifest.toml");
    let golden = golden.to_str().expect("a plain name");
    // A constant that exists only if the file or the variable does.
    let text = |condition: &str| {
        let statements = format!("if {condition} {{ return None; }}");
        super::attack("seen-by-the-compiler", Walled, &statements)
    };
    let attacks = [text(&format!("option_env!(\"{}\").is_some()", SECRET.0))];
    every_attack_has_its_expected_outcome(&attacks, &walls());
    every_attack_has_its_expected_outcome(&attacks, "none");
    let reads = [file(
        "golden-compiled-in",
        Harmless,
        &format!("const _: &str = include_str!({golden:?});"),
    )];
    every_attack_has_its_expected_outcome(&reads, "none");
}
