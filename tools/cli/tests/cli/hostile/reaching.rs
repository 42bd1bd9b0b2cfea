//! Files that code must not reach in any sandbox, and programs that must not start because of it.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;

use super::{SECRET, examine};
use crate::check::{lost, with_body};
use crate::modes;
use pinhole_testing::{root, submission};

/// Prints which files with these names the code can read.
const LOOK: &str = r#"
fn look(path: &std::path::Path, depth: u32) -> bool {
    let inside = std::fs::read_dir(path).into_iter().flatten().flatten();
    std::fs::read(path).is_ok_and(|text| !text.is_empty())
        || depth > 0 && inside.map(|entry| entry.path()).any(|entry| look(&entry, depth - 1))
}
"#;

#[test]
fn no_kind_of_sandbox_lets_code_read_goldens_answers_or_built_programs() {
    let inside = [
        "Cargo.toml",
        "golden/ray_casting/manifest.toml",
        "assignments/ray_casting/reference/src/plane.rs",
        "target/pinhole",
        "target/release/pinhole",
    ];
    let paths: Vec<String> = inside
        .iter()
        .map(|name| format!("{:?}", root().join(name)))
        .collect();
    let body = format!(
        "static REACHED: std::sync::LazyLock<bool> = std::sync::LazyLock::new(|| {{
             let paths = [{}];
             let mut seen = paths.iter().filter(|path| look(std::path::Path::new(path), 4));
             seen.next().inspect(|path| eprintln!(\"reached {{path}}\")).is_some()
                 || std::env::var({:?}).is_ok()
         }});
         if *REACHED {{ return None; }}",
        paths.join(", "),
        SECRET.0
    );
    let text = with_body("plane", &body) + LOOK;
    let folder = submission(&std::env::temp_dir(), "reaching", &[("plane.rs", &text)]);
    for mode in modes::ALL
        .into_iter()
        .filter(|mode| modes::can_be_tried(mode))
    {
        let examination = examine(&folder, mode);
        assert_eq!(lost(&examination, "plane"), 0, "{mode}: {examination:#}");
    }
    let examination = examine(&folder, "none");
    assert!(lost(&examination, "plane") > 0, "the attack cannot succeed");
    fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn code_cannot_write_to_the_graders_terminal() {
    let body = "use std::io::Write; \
         let terminal = std::fs::OpenOptions::new().write(true).open(\"/dev/tty\"); \
         let _ = terminal.and_then(|mut it| it.write_all(b\"written by\\x20plane\"));";
    let text = with_body("plane", body);
    let folder = submission(&std::env::temp_dir(), "terminal", &[("plane.rs", &text)]);
    let name = folder.to_str().expect("a plain name");
    let shown = |mode: &str| {
        let fixed = ["check", name, "--task", "plane", "--no-report", "--sandbox"];
        let arguments = [&fixed[..], &[modes::sandbox(mode)]].concat();
        let ran = modes::run_in_a_terminal(mode, &arguments);
        let shown = String::from_utf8_lossy(&ran.stdout).into_owned();
        assert!(shown.contains("12 / 12"), "{mode}: {shown}");
        shown.contains("written by plane")
    };
    let tried = modes::ALL
        .into_iter()
        .filter(|mode| modes::can_be_tried(mode));
    for mode in tried {
        assert!(!shown(mode), "{mode}");
    }
    assert!(shown("none"), "the attack cannot succeed");
    fs::remove_dir_all(folder).expect("it was made");
}

/// Writes a program that leaves a trace and then runs another program.
fn marking_script(path: &Path, mark: &Path, program: &str) {
    let folder = path.parent().expect("it lies in a folder");
    fs::create_dir_all(folder).expect("a folder can be made");
    let text = format!("#!/bin/sh\necho \"$0 $*\" >> {mark:?}\nexec {program} \"$@\"\n");
    fs::write(path, text).expect("it can be written");
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).expect("it is ours");
}

#[test]
fn tools_that_a_students_folder_names_are_not_started() {
    let folder = submission(&std::env::temp_dir(), "own-tools", &[]);
    let mark = folder.join("OWNED");
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output();
    let sysroot = String::from_utf8(sysroot.expect("there is rustc").stdout).expect("text");
    let rustc = format!("{}/bin/rustc", sysroot.trim());
    marking_script(&folder.join("tools/bin/rustc"), &mark, &rustc);
    let cargo = format!("{}/bin/cargo", sysroot.trim());
    marking_script(&folder.join("tools/bin/cargo"), &mark, &cargo);
    let any = folder.join("any");
    marking_script(&any, &mark, "");
    let toolchain = format!("[toolchain]\npath = {:?}\n", folder.join("tools"));
    fs::write(folder.join("rust-toolchain.toml"), toolchain).expect("it can be written");
    fs::create_dir(folder.join(".cargo")).expect("a folder can be made");
    let config =
        format!("[build]\nrustc-wrapper = {any:?}\n[target.'cfg(all())']\nrunner = [{any:?}]\n");
    fs::write(folder.join(".cargo/config.toml"), config).expect("it can be written");
    for arguments in [
        &["check", ".", "--task", "plane", "--no-report"][..],
        &["merge", "--help"],
    ] {
        let mut pinhole = Command::new(env!("CARGO_BIN_EXE_pinhole"));
        for variable in ["RUSTUP_TOOLCHAIN", "CARGO", "RUSTC"] {
            pinhole.env_remove(variable);
        }
        let ran = pinhole.args(arguments).current_dir(&folder).output();
        let ran = ran.expect("pinhole starts");
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.success(), "{arguments:?}: {said}");
        let marks = fs::read_to_string(&mark).unwrap_or_default();
        assert!(marks.is_empty(), "{arguments:?} started {marks}");
    }
    fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn an_assignment_in_a_students_folder_does_not_replace_ours() {
    let folder = submission(&std::env::temp_dir(), "own-assignment", &[]);
    let theirs = folder.join("ray_casting");
    fs::create_dir(&theirs).expect("a folder can be made");
    fs::write(theirs.join("assignment.toml"), "theirs").expect("it can be written");
    let ran = Command::new(env!("CARGO_BIN_EXE_pinhole"))
        .args(["check", ".", "--assignment", "ray_casting"])
        .args(["--task", "plane", "--no-report"])
        .current_dir(&folder)
        .output()
        .expect("pinhole starts");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    fs::remove_dir_all(folder).expect("it was made");
}
