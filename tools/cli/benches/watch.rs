//! The time from a save to its verdict: `cargo bench -p pinhole-cli --bench watch`.
//!
//! Runs the real `check --watch --json` and saves right and wrong answers in turn, each a text
//! that was never compiled before. The time ends when the line of the verdict has arrived. The
//! last row saves an answer that does not compile.

use std::fs;
use std::io::{BufRead, BufReader, Lines};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

/// How often each task is saved.
const SAVES: usize = 20;

/// A task and a known mistake in it.
const TASKS: [(&str, &str); 6] = [
    ("viewing_ray", "viewing_ray_normalised"),
    ("sphere", "sphere_near_root_only"),
    ("plane", "plane_ignores_min_t"),
    ("triangle", "triangle_ignores_min_t"),
    ("triangle_soup", "triangle_soup_skips_one"),
    ("first_hit", "first_hit_last_wins"),
];

fn main() {
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let folder = answers();
    println!(
        "{:<28}{:>9}{:>9}",
        format!("{SAVES} saves"),
        "median",
        "worst"
    );
    for (task, mistake) in TASKS {
        let texts = [
            read(&course().join("reference/src"), task),
            read(&course().join("mistakes").join(mistake), task),
        ];
        row(task, &folder, task, &texts);
    }
    let broken = "fn broken( {".to_owned();
    row("sphere, does not compile", &folder, "sphere", &[broken]);
}

fn course() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assignments/ray_casting")
}

fn read(folder: &Path, task: &str) -> String {
    let path = folder.join(task).with_extension("rs");
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A copy of the reference's answers inside the checkout, where code is trusted.
fn answers() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("watch-bench");
    let _absent = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    for (task, _) in TASKS {
        let text = read(&course().join("reference/src"), task);
        fs::write(folder.join(task).with_extension("rs"), text).expect("it can be written");
    }
    folder
}

/// Saves these texts in turn, and prints how long each verdict took.
fn row(name: &str, folder: &Path, task: &str, texts: &[String]) {
    let mut watch = Watch::begin(folder, task);
    let mut times: Vec<Duration> = (0..SAVES)
        .map(|turn| {
            let now = SystemTime::UNIX_EPOCH.elapsed().expect("it is past 1970");
            let text = format!("{}\n// {now:?}\n", texts[turn % texts.len()]);
            // A student reads before saving again.
            thread::sleep(Duration::from_millis(300));
            let start = Instant::now();
            fs::write(folder.join(task).with_extension("rs"), text).expect("it can be saved");
            watch.verdict();
            start.elapsed()
        })
        .collect();
    times.sort();
    let (median, worst) = (times[SAVES / 2], times[SAVES - 1]);
    println!(
        "{name:<28}{:>7.2} s{:>7.2} s",
        median.as_secs_f64(),
        worst.as_secs_f64()
    );
}

struct Watch {
    child: Child,
    lines: Lines<BufReader<ChildStdout>>,
}

impl Watch {
    /// Starts a watch, and waits for the verdict on the answers that are there.
    fn begin(folder: &Path, task: &str) -> Watch {
        let mut child = Command::new(env!("CARGO_BIN_EXE_pinhole"))
            .args(["check", "--watch", "--json", "--task", task])
            .arg(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("pinhole starts");
        let out = child.stdout.take().expect("it is piped");
        let lines = BufReader::new(out).lines();
        let mut watch = Watch { child, lines };
        watch.verdict();
        watch
    }

    fn verdict(&mut self) {
        let line = self.lines.next().expect("the watch lives on");
        let line = line.expect("it is text");
        assert!(line.contains("\"points\""), "{line}");
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        drop(self.child.stdin.take());
        let _ended = self.child.wait();
    }
}
