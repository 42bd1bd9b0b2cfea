//! Where, when and how a study was made.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use pinhole_course::shell::PINHOLE;

use crate::result::Provenance;

/// Of this run.
pub fn provenance(mode: &str, seed: u64) -> Provenance {
    Provenance {
        machine: machine(),
        date: date(),
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

/// What to type for the same; where it is written changes no figure.
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

/// Today, by the civil calendar (Hinnant, "chrono-Compatible Low-Level Date Algorithms").
fn date() -> String {
    let seconds = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |since| since.as_secs());
    let days = (seconds / 86_400) as i64 + 719_468;
    let (era, day_of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 {
        from_march + 3
    } else {
        from_march - 9
    };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}
