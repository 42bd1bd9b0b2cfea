//! Records where, when and how a study was made.

use std::fs;
use std::path::Path;
use std::process::Command;

use pinhole_course::shell::PINHOLE;

use crate::result::Provenance;

/// The provenance of this run.
pub fn provenance(mode: &str, seed: u64) -> Provenance {
    Provenance {
        machine: machine(),
        date: jiff::Timestamp::now().strftime("%F").to_string(),
        commit: commit(),
        command: command(),
        mode: mode.into(),
        seed,
        features: if cfg!(target_feature = "fma") {
            "fma"
        } else {
            "no fma: mul_add is a call"
        }
        .into(),
    }
}

/// The command that repeats the run, without `--out`, which changes no result.
fn command() -> String {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut words = vec![PINHOLE];
    for (at, word) in arguments.iter().enumerate() {
        if word != "--out" && at.checked_sub(1).is_none_or(|at| arguments[at] != "--out") {
            words.push(word);
        }
    }
    words.join(" ")
}

fn machine() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let name = model.map_or(std::env::consts::ARCH, |(_, name)| name);
    format!("{name}, {cores} cores, {}", std::env::consts::OS)
}

fn commit() -> String {
    let git = |arguments: &[&str]| {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let output = Command::new("git")
            .args(arguments)
            .current_dir(here)
            .output();
        output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let hash = git(&["rev-parse", "--short=12", "HEAD"]).unwrap_or_default();
    let changed = git(&["status", "--porcelain", "--untracked-files=no"]).unwrap_or_default();
    format!("{hash}{}", if changed.is_empty() { "" } else { "+" })
}
