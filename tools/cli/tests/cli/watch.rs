//! `pinhole check --watch` in a pipe.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::check::with_body;
use pinhole_testing::{pinhole, root, submission, trusted};

/// Far longer than anything here takes, even on a busy machine.
pub const LONG: Duration = Duration::from_secs(120);

/// A watch that writes into a pipe.
struct PipedWatch {
    child: Child,
    stdin: Option<ChildStdin>,
    lines: Receiver<String>,
}

/// Watches a folder, and only the task `plane` unless `more` says otherwise.
fn watch(folder: &Path, more: &[&str]) -> PipedWatch {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pinhole"))
        .current_dir(root())
        .args(["check", "--watch"])
        .arg(folder)
        .args(more)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("pinhole starts");
    let (send, lines) = mpsc::channel();
    let out = BufReader::new(child.stdout.take().expect("it is piped"));
    thread::spawn(move || {
        for line in out.lines().map_while(Result::ok) {
            let _ = send.send(line);
        }
    });
    let stdin = child.stdin.take();
    PipedWatch {
        child,
        stdin,
        lines,
    }
}

impl PipedWatch {
    /// All lines up to the first that contains `text`.
    #[track_caller]
    fn read_to(&self, text: &str) -> Vec<String> {
        let end = Instant::now() + LONG;
        let mut read: Vec<String> = Vec::new();
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let Ok(line) = self.lines.recv_timeout(left) else {
                panic!("no {text:?} in:\n{}", read.join("\n"));
            };
            read.push(line);
            if read.last().is_some_and(|line| line.contains(text)) {
                return read;
            }
        }
    }

    /// The next line as JSON.
    #[track_caller]
    fn document(&self) -> Value {
        let line = self.lines.recv_timeout(LONG).expect("there is a line");
        serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}"))
    }

    /// Closes standard input. Returns how the watch ends, and what it still prints.
    fn close(mut self) -> (ExitStatus, Vec<String>) {
        self.stdin.take();
        let status = self.child.wait().expect("it ends");
        (status, self.lines.iter().collect())
    }
}

impl Drop for PipedWatch {
    fn drop(&mut self) {
        let _ended_already = self.child.kill();
    }
}

/// A plane that is right unless the ray comes from behind.
fn one_sided_plane() -> String {
    with_body(
        "plane",
        "if ray.direction.dot(self.normal) > 0.0 { return None; }",
    )
}

fn reference(task: &str) -> String {
    let path = root().join("assignments/ray_casting/reference/src");
    fs::read_to_string(path.join(task).with_extension("rs")).expect("the reference has it")
}

/// Right answers except for a plane, in a folder of their own.
pub fn with_plane(name: &str, text: &str) -> PathBuf {
    submission(&trusted(), name, &[("plane.rs", text)])
}

#[test]
fn each_save_is_answered_by_a_block_of_plain_lines() {
    let folder = with_plane("watch-pipe", &one_sided_plane());
    let watch = watch(&folder, &["--task", "plane", "--task", "sphere"]);
    let first = watch.read_to("✓ sphere").join("\n");
    assert!(
        first.contains("watching") && first.contains("read: section"),
        "{first}"
    );
    assert!(
        first.contains("✗ plane") && first.contains("expected "),
        "{first}"
    );

    fs::write(folder.join("plane.rs"), reference("plane")).expect("it can be saved");
    let second = watch.read_to("after you saved").join("\n");
    assert!(
        second.contains("✓ plane ") && second.contains("12 / 12"),
        "{second}"
    );
    assert!(
        !second.contains("sphere"),
        "only what was saved is asked:\n{second}"
    );

    fs::write(folder.join("plane.rs"), "fn broken( {").expect("it can be saved");
    let third = watch.read_to("after you saved").join("\n");
    assert!(third.contains("does not compile"), "{third}");
    assert!(third.contains("/plane.rs:1:13"), "{third}");

    for said in [first, second, third] {
        assert!(!said.contains('\u{1b}'), "an escape code in {said:?}");
    }
    let (status, rest) = watch.close();
    assert!(status.success() && rest.is_empty(), "{status} {rest:?}");
}

#[test]
fn with_json_every_verdict_is_a_document_on_a_line() {
    let folder = with_plane("watch-json", "");
    let watch = watch(&folder, &["--task", "plane", "--json"]);
    let first = watch.document();
    assert_eq!(first["tasks"][0]["file"]["state"], "does not compile");
    assert_eq!(first["seconds_after_save"], Value::Null);
    fs::write(folder.join("plane.rs"), reference("plane")).expect("it can be saved");
    let second = watch.document();
    assert_eq!(second["points"], 12, "{second:#}");
    assert!(second["seconds_after_save"].is_f64(), "{second:#}");
}

#[test]
fn a_file_that_is_renamed_over_is_a_save_like_any_other() {
    let folder = with_plane("watch-rename", "");
    let watch = watch(&folder, &["--task", "plane"]);
    watch.read_to("does not compile");
    // Save as vim does: write the new file under another name, move the old file away, and
    // rename the new one.
    let (new, file) = (folder.join("plane.rs.new"), folder.join("plane.rs"));
    for text in [one_sided_plane(), reference("plane"), one_sided_plane()] {
        let expected = match text == reference("plane") {
            true => "✓ plane",
            false => "✗ plane",
        };
        fs::write(&new, &text).expect("it can be written");
        fs::rename(&file, folder.join("plane.rs~")).expect("it can be moved");
        fs::rename(&new, &file).expect("it can be moved");
        watch.read_to(expected);
        watch.read_to("after you saved");
    }
}

#[test]
fn empty_file_during_a_save_is_not_judged() {
    let folder = with_plane("watch-empty", &reference("plane"));
    let watch = watch(&folder, &["--task", "plane"]);
    watch.read_to("✓ plane");
    let file = folder.join("plane.rs");
    let said_after = |text: String| {
        thread::sleep(Duration::from_millis(100));
        fs::write(&file, text).expect("it can be written");
        watch.read_to("after you saved").join("\n")
    };
    fs::remove_file(&file).expect("it can be removed");
    let said = said_after(one_sided_plane());
    assert!(
        said.contains("✗ plane") && !said.contains("no such"),
        "{said}"
    );
    fs::write(&file, "").expect("it can be truncated");
    let said = said_after(reference("plane"));
    assert!(
        said.contains("✓ plane") && !said.contains("compile"),
        "{said}"
    );
}

#[test]
fn watch_reports_a_missing_file_or_folder_and_its_return() {
    let folder = with_plane("watch-gone", &reference("plane"));
    let watch = watch(&folder, &["--task", "plane"]);
    watch.read_to("✓ plane");
    fs::remove_file(folder.join("plane.rs")).expect("it is there");
    watch.read_to(".rs is missing");

    let elsewhere = folder.with_extension("elsewhere");
    let _from_an_earlier_run = fs::remove_dir_all(&elsewhere);
    fs::rename(&folder, &elsewhere).expect("it can be moved");
    watch.read_to("there is no folder");

    fs::write(elsewhere.join("plane.rs"), one_sided_plane()).expect("it can be saved");
    fs::rename(&elsewhere, &folder).expect("it can be moved back");
    watch.read_to("✗ plane");
    watch.read_to("read: section");
    fs::write(folder.join("plane.rs"), reference("plane")).expect("it can be saved");
    watch.read_to("✓ plane");
}

#[test]
fn the_newest_save_wins_even_over_an_endless_loop() {
    let endless = with_body("plane", "loop { std::hint::black_box(0); }");
    let folder = with_plane("watch-endless", &endless);
    let watch = watch(&folder, &["--task", "plane", "--timeout", "600"]);
    watch.read_to("watching");
    // Long enough to be in the loop, on most machines.
    thread::sleep(Duration::from_secs(2));
    fs::write(folder.join("plane.rs"), reference("plane")).expect("it can be saved");
    let said = watch.read_to("after you saved").join("\n");
    assert!(said.contains("✓ plane") && !said.contains('✗'), "{said}");
}

#[test]
fn when_every_task_passes_the_scenes_are_judged() {
    let folder = with_plane("watch-scenes", &one_sided_plane());
    let watch = watch(&folder, &[]);
    watch.read_to("✗ plane");
    watch.read_to("✓ first_hit");
    fs::write(folder.join("plane.rs"), reference("plane")).expect("it can be saved");
    watch.read_to("✓ plane");
    watch.read_to("✓ bunny");
}

#[test]
fn the_current_verdict_is_printed_before_a_closed_pipe_ends_the_watch() {
    let folder = with_plane("watch-closed", &one_sided_plane());
    let (status, lines) = watch(&folder, &["--task", "plane"]).close();
    let lines = lines.join("\n");
    assert!(
        status.success() && lines.contains("✗ plane"),
        "{status}\n{lines}"
    );
}

#[test]
fn a_watch_refuses_single_scenes_and_the_second_judge() {
    for other in [["--scene", "bunny"].as_slice(), &["--oiiotool"]] {
        pinhole(&[&["check", "--watch"], other].concat())
            .expect_code(2)
            .expect_err("cannot be used with");
    }
}
