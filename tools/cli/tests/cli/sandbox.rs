//! What untrusted code can't reach, read or pass off as its own.

use crate::check::{check, lost, task, with_body};
use pinhole_testing::{fresh, pinhole, root, submission, trusted};

#[cfg(target_os = "linux")]
#[test]
fn code_outside_the_checkout_sees_no_golden_while_compiling_or_running() {
    let golden = root().join("golden/ray_casting/manifest.toml");
    let compile = format!("const _: &[u8] = include_bytes!({golden:?});");
    let run = with_body(
        "sphere",
        &format!("if std::fs::metadata({golden:?}).is_ok() {{ return None; }}"),
    );
    // A server listens on this machine; the sandbox can't reach it.
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    let run_network = with_body(
        "triangle",
        &format!("if std::net::TcpStream::connect(\"{address}\").is_ok() {{ return None; }}"),
    );
    let files = [
        ("plane.rs", compile.as_str()),
        ("sphere.rs", &run),
        ("triangle.rs", &run_network),
    ];
    let outside = submission(&std::env::temp_dir(), "walls", &files);
    let examination = check(&outside, &[]).expect_code(1).json();
    assert_eq!(
        task(&examination, "plane")["file"]["state"],
        "does not compile"
    );
    assert_eq!(
        lost(&examination, "sphere"),
        0,
        "the code could see the golden"
    );
    assert_eq!(
        lost(&examination, "triangle"),
        0,
        "the code could see the network"
    );

    // Inside the checkout, the same code is trusted and does see the golden.
    let inside = submission(&trusted(), "no-walls", &files);
    let examination = check(&inside, &[]).expect_code(1).json();
    for task in ["sphere", "triangle"] {
        assert!(
            lost(&examination, task) > 0,
            "the check of {task} above cannot fail"
        );
    }
    std::fs::remove_dir_all(outside).expect("it was made");
}

#[cfg(target_os = "linux")]
#[test]
fn files_that_the_shell_has_open_are_closed_inside_the_sandbox() {
    let scratch = fresh(&trusted(), "open-files");
    let grades = scratch.join("grades.csv");
    std::fs::write(&grades, "ada,100\n").expect("it can be written");
    let body = with_body(
        "sphere",
        "if let Ok(mut file) = std::fs::OpenOptions::new().append(true).open(\"/proc/self/fd/8\") {
            std::io::Write::write_all(&mut file, b\"mallory,100\").ok();
        }",
    );
    let outside = submission(&std::env::temp_dir(), "open-files", &[("sphere.rs", &body)]);
    let line = format!(
        "exec 8>>{grades:?}; exec {:?} check {outside:?} --task sphere",
        env!("CARGO_BIN_EXE_pinhole")
    );
    let mut bash = std::process::Command::new("bash");
    bash.args(["-c", &line])
        .current_dir(root())
        .stdout(std::process::Stdio::null());
    assert!(
        bash.status().expect("bash runs").success(),
        "the answer is right"
    );
    let grades = std::fs::read_to_string(&grades).expect("it is there");
    assert!(
        grades
            == "ada,100
",
        "an answer wrote to a file that the shell had open"
    );
    std::fs::remove_dir_all(outside).expect("it was made");
}

#[cfg(unix)]
#[test]
fn a_link_in_place_of_an_answer_is_refused() {
    let folder = submission(&trusted(), "link", &[]);
    let reference = root().join("assignments/ray_casting/reference/src/sphere.rs");
    std::fs::remove_file(folder.join("sphere.rs")).expect("the copy has it");
    std::os::unix::fs::symlink(reference, folder.join("sphere.rs")).expect("links can be made");
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(task(&examination, "sphere")["file"]["state"], "refused");
}

#[cfg(unix)]
#[test]
fn a_link_in_place_of_the_source_folder_is_not_followed() {
    let folder = fresh(&trusted(), "linked-src");
    let reference = root().join("assignments/ray_casting/reference/src");
    std::os::unix::fs::symlink(reference, folder.join("src")).expect("links can be made");
    let folder = folder.to_str().expect("a plain name");
    pinhole(&["check", folder])
        .expect_code(2)
        .expect_err("holds no answer file");
}
