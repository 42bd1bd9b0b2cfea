//! Files that are not regular answer files, and files that must not count.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use super::{examine, scratch, walls};
use crate::check::{lost, task};
use pinhole_testing::{pinhole, root, submission};

/// Puts something in the place of `plane.rs`, and returns its outcome.
fn state_of(name: &str, make: impl FnOnce(&Path)) -> String {
    let folder = submission(&std::env::temp_dir(), &format!("hostile-{name}"), &[]);
    let plane = folder.join("plane.rs");
    fs::remove_file(&plane).expect("the copy has it");
    make(&plane);
    let examination = examine(&folder, &walls());
    assert_eq!(lost(&examination, "sphere"), 0, "{name}");
    let plane = task(&examination, "plane");
    let state = plane["file"]["state"].as_str().expect("a word").to_owned();
    if state != "compiled" {
        assert_eq!(plane["points"], 0, "{name}");
    } else {
        assert_eq!(lost(&examination, "plane"), 0, "{name}");
    }
    fs::remove_dir_all(folder).expect("it was made");
    state
}

fn reference() -> String {
    let path = root().join("assignments/ray_casting/reference/src/plane.rs");
    fs::read_to_string(path).expect("it is there")
}

fn write(bytes: impl AsRef<[u8]>) -> impl FnOnce(&Path) {
    move |path| fs::write(path, bytes).expect("it can be written")
}

#[test]
fn only_regular_text_of_ordinary_size_counts() {
    let golden = root().join("golden/ray_casting/manifest.toml");
    let other = root().join("assignments/ray_casting/reference/src/plane.rs");
    for target in [
        Path::new("/etc/passwd"),
        Path::new("/dev/zero"),
        Path::new("plane.rs"),
        &golden,
        &other,
    ] {
        assert_eq!(
            state_of("link", |path| symlink(target, path).expect("a link")),
            "refused"
        );
    }
    let pipe = |path: &Path| {
        assert!(
            Command::new("mkfifo")
                .arg(path)
                .status()
                .is_ok_and(|it| it.success())
        )
    };
    assert_eq!(state_of("pipe", pipe), "refused");
    assert_eq!(
        state_of("folder", |path| fs::create_dir(path).expect("a folder")),
        "refused"
    );
    let socket =
        |path: &Path| drop(std::os::unix::net::UnixListener::bind(path).expect("a socket"));
    assert_eq!(state_of("socket", socket), "refused");
    assert_eq!(state_of("nothing", |_| ()), "missing");
    assert_eq!(state_of("large", write(" ".repeat(300_000))), "refused");
    let sparse = |path: &Path| {
        fs::File::create(path)
            .expect("a file")
            .set_len(1 << 40)
            .expect("it is sparse")
    };
    assert_eq!(state_of("a-terabyte", sparse), "refused");
    assert_eq!(state_of("latin-1", write(b"// caf\xe9\n")), "refused");
    assert_eq!(state_of("utf-16", write(b"\xff\xfe/\0/\0")), "refused");
    assert_eq!(state_of("empty", write("")), "does not compile");
    assert_eq!(
        state_of("nul", write(reference().replacen("use", "\0use", 1))),
        "does not compile"
    );
}

#[test]
fn byte_order_marks_and_windows_line_ends_are_accepted() {
    assert_eq!(
        state_of("mark", write(format!("\u{feff}{}", reference()))),
        "compiled"
    );
    assert_eq!(
        state_of("crlf", write(reference().replace('\n', "\r\n"))),
        "compiled"
    );
    let spaced = reference() + &"\n".repeat(10_000);
    assert_eq!(state_of("long-tail", write(spaced)), "compiled");
}

#[test]
fn only_the_answer_files_are_taken() {
    let mark = scratch("hostile-mark").join("owned");
    let owned = mark.to_str().expect("a plain name");
    let build = format!("fn main() {{ std::fs::write({owned:?}, \"\").unwrap(); }}");
    let cargo = format!(
        "[build]\nrustc-wrapper = \"/usr/bin/touch {owned}\"\nrustflags = [\"--cfg\", \"owned\"]\n[target.'cfg(all())']\nrunner = \"true\"\n[env]\nINSTA_UPDATE = \"always\"\n"
    );
    let files = [
        ("build.rs", build.as_str()),
        (".cargo/config.toml", &cargo),
        ("rust-toolchain.toml", "[toolchain]\nchannel = \"none\"\n"),
        ("rust-toolchain", "none"),
        (".insta.yaml", "behavior:\n  force_pass: true\n"),
        (
            "Cargo.toml",
            "[package]\nname = \"owned\"\nbuild = \"build.rs\"\n",
        ),
        ("Cargo.lock", "owned"),
        ("main.rs", "compile_error!(\"owned\");"),
        ("src/plane.rs", "compile_error!(\"another place\");"),
        ("intersect_ray.rs", "compile_error!(\"owned\");"),
        ("clippy.toml", "owned"),
        ("rustc", "#!/bin/sh\ntouch owned"),
        ("golden/ray_casting/manifest.toml", "owned"),
        ("assignments/ray_casting/assignment.toml", "owned"),
        ("results.json", "{\"points\": 100}"),
    ];
    let folder = submission(&std::env::temp_dir(), "hostile-luggage", &[]);
    for (name, text) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("it has one")).expect("a folder");
        fs::write(path, text).expect("it can be written");
    }
    let examination = examine(&folder, &walls());
    assert_eq!(
        (lost(&examination, "plane"), lost(&examination, "sphere")),
        (0, 0),
        "{examination:#}"
    );
    assert!(!mark.exists(), "something in the folder was run");
    fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn an_archive_counts_as_the_folder_it_holds() {
    let folder = submission(&std::env::temp_dir(), "hostile-zip", &[]);
    let archive = scratch("hostile-archive").join("answers =1+1;$(id).zip");
    // Packed as course systems pack it, with other files beside the answers.
    let zipped = Command::new("python3")
        .args(["-m", "zipfile", "-c"])
        .arg(&archive)
        .arg(&folder)
        .status();
    assert!(
        zipped.is_ok_and(|status| status.success()),
        "python makes archives"
    );
    let examination = examine(&archive, &walls());
    assert_eq!(
        (lost(&examination, "plane"), lost(&examination, "sphere")),
        (0, 0)
    );
    assert_eq!(examination["sandbox"], expected_name());

    fs::write(&archive, b"PK no archive").expect("it can be written");
    let name = archive.to_str().expect("a plain name");
    pinhole(&["check", name])
        .expect_code(2)
        .expect_err("not a ZIP file");
    fs::remove_dir_all(folder).expect("it was made");
}

fn expected_name() -> String {
    match walls().as_str() {
        "container" => "container (another user, Landlock)".into(),
        walls => walls.to_owned(),
    }
}
