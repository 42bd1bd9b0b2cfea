//! A student's repository on a machine with only Rust.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{handed_out, handed_out_with, plain};
use pinhole_testing::{RunResult, TASKS, fresh, root, trusted};

/// Cargo's cache of the registry.
fn registry() -> PathBuf {
    let home = std::env::var("HOME").expect("there is a home");
    let cargo_home = std::env::var("CARGO_HOME").unwrap_or(format!("{home}/.cargo"));
    Path::new(&cargo_home).join("registry")
}

/// Runs a command line in a student's repository, on a machine with Rust, a linker and this cache
/// of the registry, but without a network or this checkout.
fn on_a_fresh_machine(repository: &Path, registry: &Path, command_line: &str) -> RunResult {
    let asked = Command::new("rustc").args(["--print", "sysroot"]).output();
    let asked = asked.expect("rustc starts").stdout;
    let sysroot = String::from_utf8(asked).expect("a plain path");
    let sysroot = sysroot.trim();
    let place = "/home/student/pinhole";
    let cache = repository.with_file_name("cargo-home");
    fs::create_dir_all(&cache).expect("it can be made");
    let mut walled = Command::new("bwrap");
    walled.args(["--unshare-all", "--die-with-parent", "--clearenv"]);
    walled.args("--ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64".split(' '));
    walled.args("--symlink usr/bin /bin --proc /proc --dev /dev --tmpfs /tmp".split(' '));
    walled.args("--ro-bind-try /etc/alternatives /etc/alternatives".split(' '));
    walled.args(["--ro-bind", sysroot, sysroot]);
    walled.args([
        "--bind",
        plain(&cache),
        "/cargo",
        "--ro-bind",
        plain(registry),
        "/cargo/registry",
    ]);
    walled.args(["--bind", plain(repository), place, "--chdir", place]);
    walled.args("--setenv HOME /home/student --setenv CARGO_HOME /cargo".split(' '));
    walled.args([
        "--setenv",
        "CARGO_NET_OFFLINE",
        "true",
        "--setenv",
        "CI",
        "true",
    ]);
    walled.args(["--setenv", "PATH", &format!("{sysroot}/bin:/usr/bin")]);
    walled.args(["--", "sh", "-c", command_line]);
    pinhole_testing::ran(walled.output().expect("bubblewrap is installed"))
}

/// The commands that the README tells students to run.
fn commands(readme: &str) -> Vec<String> {
    let mut commands = Vec::new();
    for block in readme.split("```sh\n").skip(1) {
        let block = block.split("```").next().unwrap_or_default();
        let lines = block
            .lines()
            .map(|line| line.split('#').next().unwrap_or_default());
        commands.extend(lines.map(|line| line.trim().to_owned()));
    }
    commands.retain(|command| !command.is_empty());
    commands
}

#[test]
fn vendored_repository_has_every_dependency_without_a_network() {
    let out = handed_out_with("handout-vendored", &["--vendor"]);
    let registry = fresh(&trusted(), "handout-no-registry");
    let look_for_dependencies = || {
        let command = "cargo metadata --locked --format-version 1 >/dev/null";
        on_a_fresh_machine(&out, &registry, command)
    };
    look_for_dependencies().expect_code(0);
    fs::remove_dir_all(out.join("vendor/clap")).expect("the command needs it");
    look_for_dependencies().expect_code(101).expect_err("clap");
}

#[test]
fn with_rust_alone_every_command_works_and_tests_pass_once_the_stubs_are_filled() {
    let out = handed_out("handout-fresh");
    let registry = registry();
    let run = |command: &str| on_a_fresh_machine(&out, &registry, command);
    run("cargo run --release --locked -- check")
        .expect_code(1)
        .expect_out("unanswered");
    let red = run("cargo test --locked").expect_code(101);
    red.expect_out("unanswered").expect_out("0 passed");

    // Commands that students don't have explain that.
    for command in [
        "golden render bunny",
        "golden mistakes",
        "golden setup",
        "handout --check",
    ] {
        run(&format!("cargo run --release -- {command}"))
            .expect_code(2)
            .expect_err("this is a student's repository");
    }
    let course = "assignments/ray_casting";
    let stub = out.join(course).join("stubs/src/sphere.rs");
    let text = fs::read_to_string(&stub).expect("it was copied");
    fs::write(&stub, text.replace("todo!", "panic!")).expect("it can be written");
    run("cargo pinhole check --task sphere")
        .expect_code(2)
        .expect_err("stubs/src/sphere.rs has changed since it was handed out");
    fs::write(&stub, text).expect("it can be written");

    // An answer that does not compile stops neither the command nor the other answers.
    let answers = out.join(course).join("handout/src");
    let reference = root().join(course).join("reference/src");
    for task in TASKS {
        let name = format!("{task}.rs");
        fs::copy(reference.join(&name), answers.join(&name)).expect("it can be copied");
    }
    let sphere = fs::read_to_string(answers.join("sphere.rs")).expect("it was copied");
    fs::write(answers.join("sphere.rs"), "fn fails(").expect("it can be written");
    run("cargo run --release -- check")
        .expect_code(1)
        .expect_out("does not compile")
        .expect_out("✓ plane");

    // A test that waits stops as soon as `check` would, and the scenes that need it don't wait.
    let endless = sphere.replacen(
        "-> Option<Intersection> {",
        "-> Option<Intersection> { loop {}",
        1,
    );
    fs::write(answers.join("sphere.rs"), endless).expect("it can be written");
    run("cargo test --locked -- --test-threads 1")
        .expect_code(101)
        .expect_out("gave no answer within 2 s")
        .expect_out("sphere_packing is not cast, because `sphere` timed out");
    fs::write(answers.join("sphere.rs"), sphere).expect("it can be written");

    run("cargo test --locked").expect_code(0);
    let readme = fs::read_to_string(out.join("README.md")).expect("it was copied");
    let commands = commands(&readme);
    assert!(commands.len() >= 6, "{commands:?}");
    // `film.exr` may come from any program. Here, it comes from ours.
    run("cargo run --release -- render bunny && cp render/film.exr film.exr").expect_code(0);
    let (resets, others): (Vec<&String>, Vec<&String>) = commands
        .iter()
        .filter(|command| !command.contains("--watch"))
        .partition(|command| command.contains(" reset "));
    for command in others {
        run(command).expect_code(0);
    }
    run("cargo run --release -- golden verify")
        .expect_code(2)
        .expect_err("this is a student's repository");
    run("cd assignments/ray_casting/handout && cargo pinhole check")
        .expect_code(0)
        .expect_out("100 / 100");
    for command in resets {
        run(command).expect_code(0);
    }
    assert!(
        answers.join("plane.rs.old").is_file(),
        "it keeps what was there"
    );
}
