//! `pinhole check --watch` in a real pseudo-terminal, read as the grid of letters that
//! a person sees.

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, ExitStatus};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use pty_process::Size;
use pty_process::blocking::{Command, Pts, Pty, open};
use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::{Termios, tcgetattr};

use crate::check::with_body;
use crate::watch::{LONG, with_plane};
use pinhole_testing::root;

/// A watch in a terminal of its own.
struct Screen {
    child: Child,
    pty: Arc<Pty>,
    /// Held open, so that the terminal outlives the watch.
    _pts: Pts,
    /// Everything that was sent to the terminal, and the screen that results.
    seen: Arc<Mutex<(Vec<u8>, vt100::Parser)>>,
    before: Termios,
}

fn watch(folder: &Path, more: &[&str]) -> Screen {
    let (pty, pts) = open().expect("there are pseudo-terminals");
    pty.resize(Size::new(24, 80)).expect("it can be resized");
    let before = tcgetattr(&pty).expect("it is a terminal");
    let child = Command::new(env!("CARGO_BIN_EXE_pinhole"))
        .current_dir(root())
        .args(["check", "--watch"])
        .arg(folder)
        .args(more)
        .env("TERM", "xterm-256color")
        .env("SSH_CONNECTION", "192.0.2.1 50000 192.0.2.2 22")
        .env_remove("NO_COLOR")
        .spawn_borrowed(&pts)
        .expect("pinhole starts");
    let pty = Arc::new(pty);
    let parser = vt100::Parser::new(24, 80, 0);
    let seen = Arc::new(Mutex::new((Vec::new(), parser)));
    let (reader, shown) = (Arc::clone(&pty), Arc::clone(&seen));
    thread::spawn(move || {
        let mut bytes = [0; 4096];
        while let Ok(count) = (&*reader).read(&mut bytes) {
            let mut shown = shown.lock().expect("no thread panics while holding it");
            shown.0.extend_from_slice(&bytes[..count]);
            shown.1.process(&bytes[..count]);
        }
    });
    Screen {
        child,
        pty,
        _pts: pts,
        seen,
        before,
    }
}

impl Screen {
    /// What a person sees.
    fn text(&self) -> String {
        let seen = self.seen.lock().expect("no thread panics while holding it");
        seen.1.screen().contents()
    }

    /// Waits until the screen is as it should be.
    #[track_caller]
    fn expect(&self, what: &str, is_there: impl Fn(&str) -> bool) -> String {
        let end = Instant::now() + LONG;
        loop {
            let text = self.text();
            if is_there(&text) {
                return text;
            }
            assert!(Instant::now() < end, "{what} is not seen in:\n{text}");
            thread::sleep(Duration::from_millis(20));
        }
    }

    #[track_caller]
    fn expect_text(&self, text: &str) -> String {
        self.expect(text, |seen| seen.contains(text))
    }

    fn press(&self, keys: &str) {
        let mut pty = &*self.pty;
        pty.write_all(keys.as_bytes()).expect("it can be typed on");
    }

    fn resize(&self, rows: u16, columns: u16) {
        let mut seen = self.seen.lock().expect("no thread panics while holding it");
        seen.1.screen_mut().set_size(rows, columns);
        self.pty
            .resize(Size::new(rows, columns))
            .expect("it can be resized");
    }

    /// Waits until the watch ends, and checks that the terminal is as it was before.
    #[track_caller]
    fn expect_end(&mut self) -> ExitStatus {
        let end = Instant::now() + LONG;
        let status = loop {
            if let Some(status) = self.child.try_wait().expect("it is our child") {
                break status;
            }
            assert!(Instant::now() < end, "it lives on:\n{}", self.text());
            thread::sleep(Duration::from_millis(20));
        };
        let after = tcgetattr(&*self.pty).expect("it is a terminal");
        assert_eq!(format!("{after:?}"), format!("{:?}", self.before));
        let seen = self.seen.lock().expect("no thread panics while holding it");
        let screen = seen.1.screen();
        assert!(!screen.hide_cursor() && !screen.alternate_screen());
        status
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ended_already = self.child.kill();
        let _reaped_already = self.child.wait();
    }
}

fn one_sided_plane() -> String {
    with_body(
        "plane",
        "if ray.direction.dot(self.normal) > 0.0 { return None; }",
    )
}

#[test]
fn a_student_goes_from_the_first_wrong_task_to_the_scenes() {
    let folder = with_plane("screen-walk", &one_sided_plane());
    let mut screen = watch(&folder, &[]);
    // The first task is the one that the assignment starts with.
    let text = screen.expect_text("✗ plane");
    assert!(
        text.contains("expected") && text.contains("q:quit"),
        "{text}"
    );
    screen.expect_text("5 / 6 tasks");

    assert!(!text.contains("look: "), "a hint nobody asked for:\n{text}");
    screen.press("h");
    screen.expect_text("look: ");
    screen.press("h");
    screen.expect_text("think: ");
    screen.press("h");
    screen.expect_text("read: ");

    screen.press("n");
    screen.expect_text("✓ viewing_ray   14 / 14");
    screen.press("p");
    let text = screen.expect_text("✗ plane   ");
    assert!(!text.contains("think: "), "hints start over:\n{text}");

    screen.press("?");
    screen.expect_text("quit (or press Ctrl-C)");
    screen.press("?");
    screen.expect_text("✗ plane   ");

    let right = root().join("assignments/ray_casting/reference/src/plane.rs");
    fs::copy(right, folder.join("plane.rs")).expect("it can be saved");
    screen.expect_text("every task passes; now the scenes");
    let text = screen.expect_text("12 / 12 scenes");
    assert!(text.contains("100 / 100 points"), "{text}");
    assert!(text.contains("read next: "), "{text}");
    screen.expect("no more to do", |seen| !seen.contains("now the scenes"));

    screen.press("a");
    screen.expect_text("viewing_ray");
    screen.press("q");
    assert!(screen.expect_end().success());
}

#[test]
fn a_save_replaces_the_verdict_and_the_screen_follows_the_student() {
    let folder = with_plane("screen-save", &one_sided_plane());
    let mut screen = watch(&folder, &["--task", "plane", "--task", "sphere"]);
    screen.expect_text("✗ plane");
    fs::write(folder.join("plane.rs"), "fn broken( {").expect("it can be saved");
    let text = screen.expect_text("does not compile");
    assert!(text.contains("/plane.rs:1:13"), "{text}");
    assert!(!text.contains("expected  "), "an old verdict in:\n{text}");
    assert!(screen.expect_text("after you saved").contains("judged "));

    let sphere = fs::read_to_string(folder.join("sphere.rs")).expect("it is there");
    fs::write(folder.join("sphere.rs"), sphere + "\n").expect("it can be saved");
    screen.expect_text("you saved sphere.rs");
    let text = screen.expect_text("✓ sphere");
    assert!(!text.contains("compile"), "{text}");
    screen.press("\u{3}");
    assert!(screen.expect_end().success());
}

#[test]
fn the_screen_fits_every_size() {
    let folder = with_plane("screen-size", &one_sided_plane());
    let mut screen = watch(&folder, &["--task", "plane"]);
    screen.expect_text("✗ plane");
    for (rows, columns) in [(30, 120), (24, 60), (12, 60), (24, 80)] {
        screen.resize(rows, columns);
        // Every key is still there, on the last row, and the verdict begins on the first row, once.
        screen.expect("the foot", |seen| {
            seen.lines().count() == usize::from(rows)
                && seen.starts_with("✗ plane")
                && seen.matches("✗ plane").count() == 1
                && seen.contains("h:hint")
                && seen.contains("q:quit")
        });
    }
    screen.resize(12, 80);
    let text = screen.expect("more", |seen| {
        seen.contains("more") && seen.contains("q:quit")
    });
    assert!(!text.contains("read: section"), "{text}");
    screen.press("\u{1b}[B\u{1b}[B\u{1b}[6~");
    screen.expect_text("read: section");
    screen.press("q");
    screen.expect_end();
}

#[test]
fn student_output_is_escaped_in_the_terminal() {
    let rude = r#"println!("\x1b]0;owned\x07\x1b[2J\x1b[31mrude"); eprintln!("\x1b[?1049h");"#;
    let text = with_body("plane", rude);
    let folder = with_plane("screen-rude", &text);
    let mut screen = watch(&folder, &["--task", "plane"]);
    screen.expect_text("✓ plane");
    screen.expect_text("rude");
    screen.press("q");
    screen.expect_end();
    let seen = screen
        .seen
        .lock()
        .expect("no thread panics while holding it");
    let sent = String::from_utf8_lossy(&seen.0);
    for code in ["\u{1b}]0;", "\u{1b}[31mrude", "\u{1b}[?1049h"] {
        assert!(!sent.contains(code), "{code:?} was sent");
    }
}

#[test]
fn over_ssh_the_watch_says_how_to_get_the_report() {
    let folder = with_plane("screen-report", &one_sided_plane());
    let report = folder.join("report.html");
    let path = report.to_str().expect("test folders have plain names");
    let mut screen = watch(&folder, &["--task", "plane", "--report", path]);
    screen.expect_text("✗ plane");
    screen.expect("the end of judging", |seen| !seen.contains("judging"));
    screen.press("o");
    screen.resize(24, 250);
    let text = screen.expect_text("scp ");
    assert!(text.contains("192.0.2.2:"), "{text}");
    let html = fs::read_to_string(report).expect("it was written");
    assert!(html.contains("plane"), "{html}");
    screen.press("q");
    screen.expect_end();
}

#[test]
fn a_missing_folder_is_reported_and_judged_when_it_is_back() {
    let folder = with_plane("screen-gone", &one_sided_plane());
    let mut screen = watch(&folder, &["--task", "plane"]);
    screen.expect_text("✗ plane");
    let elsewhere = folder.with_extension("elsewhere");
    let _from_an_earlier_run = fs::remove_dir_all(&elsewhere);
    fs::rename(&folder, &elsewhere).expect("it can be moved");
    screen.expect_text("there is no folder");
    fs::rename(&elsewhere, &folder).expect("it can be moved back");
    screen.expect_text("✗ plane");
    screen.press("q");
    screen.expect_end();
}

#[test]
fn a_signal_restores_the_terminal_too() {
    for signal in [Signal::TERM, Signal::HUP, Signal::INT] {
        let folder = with_plane("screen-signal", &one_sided_plane());
        let mut screen = watch(&folder, &["--task", "plane"]);
        screen.expect_text("✗ plane");
        let process = Pid::from_child(&screen.child);
        kill_process(process, signal).expect("it is there");
        assert!(screen.expect_end().success());
    }
}

#[test]
fn quitting_in_an_endless_loop_leaves_no_process_behind() {
    let endless = with_body("plane", "loop { std::hint::black_box(0); }");
    let folder = with_plane("screen-endless", &endless);
    let mut screen = watch(&folder, &["--task", "plane", "--timeout", "600"]);
    screen.expect_text("judging plane");
    thread::sleep(Duration::from_secs(2));
    let process = screen.child.id();
    screen.press("q");
    screen.expect_end();
    let started_by_it = std::process::Command::new("ps")
        .args(["--no-headers", "-o", "pid,args", "-g", &process.to_string()])
        .output()
        .expect("ps runs");
    let left = String::from_utf8_lossy(&started_by_it.stdout);
    assert!(!left.contains("submission"), "{left}");
}
