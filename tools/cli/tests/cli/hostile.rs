//! Submissions that attack their grader, each with its expected outcome.
//!
//! An attack is a `plane.rs` beside right answers to all other tasks. Whatever it does, its
//! neighbour `sphere` keeps every point, no secret shows in any output, no process and no file
//! is left behind, and it ends in time. An attack that *reaches* for something answers wrongly
//! if it gets it. So it must earn full points in the sandbox and lose some without it;
//! otherwise the case proves nothing.

mod answering;
mod compiling;
mod files;
mod memoriser;
mod reaching;
mod shown;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::check::{lost, task, with_body};
use crate::modes;
use pinhole_testing::{fresh, ran, root, submission};

/// The expected outcome of an attack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// It looks for something that the sandbox hides. It gets full points, but only in the
    /// sandbox.
    Walled,
    /// It gets full points with or without a sandbox, because it is harmless or fails by
    /// itself.
    Harmless,
    /// It gets no points, and each group has this kind of outcome.
    Outcome(&'static str),
    /// It gets no points, because its file has this state.
    File(&'static str),
}

/// One attack.
pub struct Attack {
    pub name: &'static str,
    /// The text of `plane.rs`.
    pub text: String,
    pub fate: Fate,
}

/// An attack by statements at the beginning of the reference's answer.
pub fn attack(name: &'static str, fate: Fate, statements: &str) -> Attack {
    Attack {
        name,
        fate,
        text: with_body("plane", statements),
    }
}

/// An attack by an expression that is true if the code can reach something that it must not.
/// It is evaluated once.
pub fn reach(name: &'static str, expression: &str) -> Attack {
    let statements = format!(
        "static REACHED: std::sync::LazyLock<bool> = std::sync::LazyLock::new(|| {{ {expression} }});
         if *REACHED {{ return None; }}"
    );
    attack(name, Fate::Walled, &statements)
}

/// An attack by lines at the top of the reference's file.
pub fn file(name: &'static str, fate: Fate, top: &str) -> Attack {
    Attack {
        name,
        fate,
        text: with_body("plane", "").replacen("use pinhole::", &format!("{top}\nuse pinhole::"), 1),
    }
}

/// A variable in the grader's environment.
pub const SECRET: (&str, &str) = ("PINHOLE_HOSTILE", "a-secret-of-the-instructor");

/// Words that must not appear in any output.
fn secrets() -> Vec<String> {
    let manifest = std::fs::read_to_string(root().join("golden/ray_casting/manifest.toml"));
    let manifest = manifest.expect("goldens are committed");
    let hash = manifest.split('"').find(|text| text.len() == 64);
    let passwd = std::fs::read_to_string("/etc/passwd").expect("every system has one");
    vec![
        SECRET.1.into(),
        hash.expect("the manifest holds hashes").into(),
        passwd.lines().next().expect("somebody is there").into(),
    ]
}

/// No attack may take longer, however slow the machine: its limits and a margin.
const MOST_SECONDS: u64 = 150;

/// The sandbox that the whole suite uses: bubblewrap, unless another of [`modes`] is chosen.
pub fn walls() -> String {
    std::env::var("PINHOLE_HOSTILE_WALLS").unwrap_or_else(|_| "bubblewrap".into())
}

/// Checks the two tasks of a folder or archive in this sandbox.
pub fn examine(path: &Path, walls: &str) -> Value {
    examine_for(path, walls, "4")
}

fn examine_for(path: &Path, walls: &str, seconds: &str) -> Value {
    let path = path.to_str().expect("a plain name");
    let checked = modes::run(
        walls,
        &[SECRET],
        &[
            "check",
            path,
            "--task",
            "plane",
            "--task",
            "sphere",
            "--json",
            "--no-report",
            // The sandbox must hold without the allow list.
            "--allow-everything",
            "--timeout",
            seconds,
            "--sandbox",
            modes::sandbox(walls),
        ],
    );
    let ran = ran(checked);
    assert!(
        [0, 1].contains(&ran.code),
        "{path}: exit code {}\n{}",
        ran.code,
        ran.err
    );
    for secret in secrets() {
        let told = ran.out.contains(&secret) || ran.err.contains(&secret);
        assert!(
            !told || walls == "none",
            "{path} brought {secret:?} to light"
        );
    }
    ran.json()
}

/// How an attack's outcome differs from the expected one; empty if it doesn't.
fn problems(attack: &Attack, walls: &str) -> Vec<String> {
    let name = format!("hostile-{}-{walls}", attack.name.replace(' ', "-"));
    let folder = submission(&std::env::temp_dir(), &name, &[("plane.rs", &attack.text)]);
    let before = listing(&folder);
    let start = Instant::now();
    // The memory limit must end these, however long a busy machine takes to provide the
    // memory.
    let seconds = match attack.fate {
        Fate::Outcome("out of memory") => "120",
        _ => "4",
    };
    let examination = examine_for(&folder, walls, seconds);
    let mut problems = Vec::new();
    let mut expect = |right: bool, what: String| {
        if !right {
            problems.push(format!("{} behind {walls}: {what}", attack.name));
        }
    };
    let took = start.elapsed();
    expect(
        took < Duration::from_secs(MOST_SECONDS),
        format!("took {took:?}"),
    );
    expect(
        lost(&examination, "sphere") == 0,
        "its neighbour lost points".into(),
    );
    let plane = task(&examination, "plane");
    let shown = || format!("{plane:#}");
    match attack.fate {
        Fate::Walled if walls == "none" => {
            expect(
                lost(&examination, "plane") > 0,
                "it does no harm without a sandbox either".into(),
            );
        }
        Fate::Walled | Fate::Harmless => expect(lost(&examination, "plane") == 0, shown()),
        Fate::Outcome(kind) => {
            let groups = plane["groups"].as_array().expect("a list");
            let all = groups.iter().all(|group| group["outcome"]["kind"] == kind);
            expect(all && plane["points"] == 0, shown());
        }
        Fate::File(state) => {
            expect(
                plane["file"]["state"] == state && plane["points"] == 0,
                shown(),
            );
        }
    }
    expect(
        listing(&folder) == before,
        "it left a file in its folder".into(),
    );
    let printed = examination["printed"].as_str().expect("text").len();
    expect(
        printed <= 1 << 20,
        format!("{printed} bytes of its output were kept"),
    );
    std::fs::remove_dir_all(folder).expect("it was made");
    problems
}

fn listing(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("it is there").flatten();
    let mut names: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    names.sort();
    names
}

/// Tries all attacks, two at a time as a grader would.
#[track_caller]
pub fn every_attack_has_its_expected_outcome(attacks: &[Attack], walls: &str) {
    let next = AtomicUsize::new(0);
    let problems = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(attack) = attacks.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let start = Instant::now();
                    let found = self::problems(attack, walls);
                    eprintln!("{:>6.1} s  {}", start.elapsed().as_secs_f64(), attack.name);
                    problems.lock().expect("nobody panics here").extend(found);
                }
            });
        }
    });
    let mut problems = problems.into_inner().expect("nobody panics here");
    problems.extend(left_behind());
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Processes and files of the users that attacks run as. Those of other tests, which attack at
/// the same time, disappear by themselves. Those that an attack leaves behind stay.
fn left_behind() -> Vec<String> {
    let mut left = strays();
    let start = Instant::now();
    while !left.is_empty() && start.elapsed() < Duration::from_secs(MOST_SECONDS) {
        std::thread::sleep(Duration::from_millis(100));
        let still = strays();
        left.retain(|stray| still.contains(stray));
    }
    left
}

fn strays() -> Vec<String> {
    let find = |arguments: &[&str]| {
        let output = Command::new("find")
            .args(arguments)
            .output()
            .expect("there is `find`");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let temp = std::env::temp_dir();
    let temp = temp.to_str().expect("a plain name");
    let theirs = ["-maxdepth", "1", "-uid", "+60705", "-uid", "-61184"];
    let places = [temp, "/proc", "/dev/shm", "/var/tmp"];
    places
        .iter()
        .flat_map(|place| {
            let found = find(&[&[*place][..], &theirs].concat());
            found
                .lines()
                .map(|line| format!("left behind: {line}"))
                .collect::<Vec<_>>()
        })
        .collect()
}

/// A folder for what one of these tests makes itself.
pub fn scratch(name: &str) -> PathBuf {
    fresh(&std::env::temp_dir(), name)
}
