//! Submissions that attack their grader, each with its expected outcome.
//!
//! A submission holds up to three attacks, each in its own task's file, because most of the time
//! goes into compiling. Every other answer is right. Whatever the attacks do, `viewing_ray`,
//! their neighbour, keeps every point; none of the secrets below appears; no process and no file
//! is left behind; and the check ends in time. An attack that *reaches* for something answers
//! wrongly if it gets it. So in the sandbox it earns full points. Without a sandbox it must lose
//! some, or the case proves nothing.

mod answering;
mod compiling;
mod files;
mod memoriser;
mod reaching;
mod shown;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::check::{lost, task, with_body};
use crate::modes;
use pinhole_testing::{fresh, ran, root, small_assignment, submission, trusted};

/// The expected outcome of an attack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// It looks for something that the sandbox hides. It gets full points in the sandbox, and
    /// only there.
    Walled,
    /// It gets full points with or without a sandbox, because it is harmless or fails by
    /// itself.
    Harmless,
    /// It gets no points, and each group has this kind of outcome.
    Outcome(&'static str),
    /// It gets no points, because it uses too much memory. Where many threads reserve addresses, it
    /// may abort before the watchdog sees that.
    Hungry,
    /// It gets no points, because its file has this state.
    File(&'static str),
}

/// One attack.
pub struct Attack {
    pub name: &'static str,
    pub fate: Fate,
    part: Part,
}

/// What an attack adds to a right answer.
enum Part {
    /// Statements before the reference's own.
    Statements(String),
    /// Lines in front of the whole file.
    Top(String),
}

/// The tasks whose files hold attacks.
const PLACES: [&str; 3] = ["plane", "sphere", "triangle"];

/// A task that is not attacked.
const NEIGHBOUR: &str = "viewing_ray";

impl Attack {
    /// Whether a memory limit should end it.
    fn is_hungry(&self) -> bool {
        self.fate == Fate::Hungry
    }

    /// The file of its task.
    fn text(&self, task: &str) -> String {
        match &self.part {
            Part::Statements(statements) => with_body(task, statements),
            Part::Top(top) => {
                let file = with_body(task, "");
                file.replacen("use pinhole::", &format!("{top}\nuse pinhole::"), 1)
            }
        }
    }
}

/// An attack by statements at the beginning of the reference's answer.
pub fn attack(name: &'static str, fate: Fate, statements: &str) -> Attack {
    let part = Part::Statements(statements.into());
    Attack { name, fate, part }
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

/// An attack by lines before the reference's file.
pub fn file(name: &'static str, fate: Fate, top: &str) -> Attack {
    let part = Part::Top(top.into());
    Attack { name, fate, part }
}

/// The assignment with two groups of questions for each of these tasks and no scene, because an
/// attack does the same whatever it is asked.
fn assignment() -> &'static str {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let assignment = small_assignment(&fresh(&trusted(), "hostile-course"));
        let file = assignment.join("assignment.toml");
        let text = std::fs::read_to_string(&file).expect("it was copied");
        let mut course: toml::Table = text.parse().expect("it is TOML");
        let tasks = course["task"].as_array_mut().expect("a list");
        for task in tasks {
            task["points"].as_array_mut().expect("a list").truncate(2);
        }
        std::fs::write(&file, course.to_string()).expect("it can be written");
        assignment
    });
    folder.to_str().expect("a plain name")
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
        passwd.lines().next().expect("it has a line").into(),
    ]
}

/// No attack may take longer, however slow the machine. On a slow one, the compiler is stopped twice
/// after 60 s, and after 12 s whenever it is tried again with fewer answers. The rest is a margin.
const MOST_SECONDS: u64 = 300;

/// The sandbox that the whole suite uses: bubblewrap, unless one of [`modes`] is chosen.
pub fn walls() -> String {
    std::env::var("PINHOLE_HOSTILE_WALLS").unwrap_or_else(|_| "bubblewrap".into())
}

/// Checks the attacked tasks and their neighbour, in a folder or archive, in this sandbox.
pub fn examine(path: &Path, walls: &str) -> Value {
    examine_for(path, walls, "4")
}

fn examine_for(path: &Path, walls: &str, seconds: &str) -> Value {
    let path = path.to_str().expect("a plain name");
    let tasks = PLACES.iter().chain([&NEIGHBOUR]);
    let tasks: Vec<&str> = tasks.flat_map(|task| ["--task", task]).collect();
    let options = [
        "check",
        path,
        "--assignment",
        assignment(),
        "--json",
        "--no-report",
        // The sandbox must hold without the allow list.
        "--allow-everything",
        "--timeout",
        seconds,
        "--sandbox",
        modes::sandbox(walls),
    ];
    let checked = modes::run(walls, &[SECRET], &[&options[..], &tasks].concat());
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

/// How the outcomes of a submission's attacks differ from the expected ones. Empty if they don't.
fn problems(attacks: &[&Attack], walls: &str) -> Vec<String> {
    // Two tests may have attacks of the same name.
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    let number = NEXT.fetch_add(1, Ordering::Relaxed);
    let name = format!("hostile-{number}-{}-{walls}", attacks[0].name).replace(' ', "-");
    let files = attacks.iter().zip(PLACES);
    let files = files.map(|(attack, task)| (format!("{task}.rs"), attack.text(task)));
    let files: Vec<(String, String)> = files.collect();
    let files = files.iter().map(|(file, text)| (&**file, &**text));
    let folder = submission(&std::env::temp_dir(), &name, &files.collect::<Vec<_>>());
    let before = listing(&folder);
    let start = Instant::now();
    // The memory limit must end these attacks, even on a busy machine that is slow to provide
    // memory.
    let seconds = match attacks[0].is_hungry() {
        true => "120",
        false => "4",
    };
    let examination = examine_for(&folder, walls, seconds);
    let mut problems = Vec::new();
    let names: Vec<&str> = attacks.iter().map(|attack| attack.name).collect();
    let names = names.join(", ");
    let mut expect = |right: bool, who: &str, what: String| {
        if !right {
            problems.push(format!("{who} behind {walls}: {what}"));
        }
    };
    let took = start.elapsed();
    expect(
        took < Duration::from_secs(MOST_SECONDS),
        &names,
        format!("took {took:?}"),
    );
    expect(
        lost(&examination, NEIGHBOUR) == 0,
        &names,
        "their neighbour lost points".into(),
    );
    for (attack, name) in attacks.iter().zip(PLACES) {
        let task = task(&examination, name);
        let lost = lost(&examination, name);
        let shown = || format!("{task:#}");
        let right = match attack.fate {
            Fate::Walled if walls == "none" => lost > 0,
            Fate::Walled | Fate::Harmless => lost == 0,
            Fate::Outcome(kind) => ended(task, &[kind]),
            Fate::Hungry => ended(task, &["out of memory", "died"]),
            Fate::File(state) => task["file"]["state"] == state && task["points"] == 0,
        };
        expect(right, attack.name, shown());
    }
    expect(
        listing(&folder) == before,
        &names,
        "they left a file in their folder".into(),
    );
    let printed = examination["printed"].as_str().expect("text").len();
    expect(
        printed <= 1 << 20,
        &names,
        format!("{printed} bytes of their words were kept"),
    );
    std::fs::remove_dir_all(folder).expect("it was made");
    problems
}

/// Whether a task got no points, because each group has one of these kinds of outcome.
fn ended(task: &Value, kinds: &[&str]) -> bool {
    let mut groups = task["groups"].as_array().expect("a list").iter();
    let ended = |group: &Value| kinds.iter().any(|kind| group["outcome"]["kind"] == *kind);
    groups.all(ended) && task["points"] == 0
}

fn listing(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("it is there").flatten();
    let mut names: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    names.sort();
    names
}

/// Tries all attacks in all kinds of sandbox. `succeeds` tells which attacks succeed in which
/// mode, as SECURITY.md says.
#[track_caller]
pub fn every_attack_fails_in_every_mode(attacks: &[Attack], succeeds: fn(&str, &str) -> bool) {
    for mode in modes::ALL {
        let tried = attacks.iter().filter(|attack| !succeeds(mode, attack.name));
        if modes::can_be_tried(mode) {
            try_all(&tried.collect::<Vec<_>>(), mode);
        }
    }
}

/// Tries all attacks in one kind of sandbox.
#[track_caller]
pub fn every_attack_has_its_expected_outcome(attacks: &[Attack], walls: &str) {
    try_all(&attacks.iter().collect::<Vec<_>>(), walls);
}

/// Tries two submissions at a time, as a grader would.
#[track_caller]
fn try_all(attacks: &[&Attack], walls: &str) {
    let (hungry, others): (Vec<&Attack>, Vec<&Attack>) =
        attacks.iter().partition(|attack| attack.is_hungry());
    let packs = others
        .chunks(PLACES.len())
        .chain(hungry.chunks(PLACES.len()));
    let packs: Vec<&[&Attack]> = packs.collect();
    let next = AtomicUsize::new(0);
    let problems = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(pack) = packs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let start = Instant::now();
                    let found = self::problems(pack, walls);
                    let names: Vec<&str> = pack.iter().map(|attack| attack.name).collect();
                    let seconds = start.elapsed().as_secs_f64();
                    eprintln!("{seconds:>6.1} s  {} ({walls})", names.join(", "));
                    problems
                        .lock()
                        .expect("no thread panics while holding it")
                        .extend(found);
                }
            });
        }
    });
    let mut problems = problems
        .into_inner()
        .expect("no thread panics while holding it");
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

/// A folder for files that one of these tests makes.
pub fn scratch(name: &str) -> PathBuf {
    fresh(&std::env::temp_dir(), name)
}
