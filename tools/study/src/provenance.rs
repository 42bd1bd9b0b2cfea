//! Records where, when and how a study was made.

use std::fs;
use std::process::Command;

use pinhole_course::shell::PINHOLE;

use crate::extent::Extent;
use crate::result::Provenance;

/// The provenance of this run.
pub fn provenance(extent: &Extent) -> Provenance {
    Provenance {
        machine: machine(),
        date: jiff::Timestamp::now().strftime("%F").to_string(),
        commit: commit(),
        command: command(),
        mode: extent.name.into(),
        seed: extent.seed,
        features: if cfg!(target_feature = "fma") {
            "built for processors with fma"
        } else {
            "built without fma, so mul_add is a call"
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
    let output = Command::new("git")
        .args([
            "describe",
            "--always",
            "--exclude=*",
            "--abbrev=12",
            "--dirty=+",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    let hash = output.map_or(Vec::new(), |output| output.stdout);
    String::from_utf8_lossy(&hash).trim().to_owned()
}
