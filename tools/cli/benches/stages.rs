//! The stages of a check beside a stored baseline: `cargo bench -p pinhole-cli --bench stages`.
//!
//! Runs the real `check --timings` on a wrong answer to each task, new in each round, so that every
//! stage has work to do. Each time is divided by that of the compiler in the same round, which
//! makes machines comparable. The last column divides this ratio by the baseline's. With
//! `-- --save`, the ratios become the baseline.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// How many checks are made without oiiotool. The table shows medians.
const ROUNDS: usize = 9;

/// How many more are judged by oiiotool too, if it is installed.
const ROUNDS_OF_OIIOTOOL: usize = 3;

/// The stage whose time is the unit.
const UNIT: &str = "rustc";

/// A wrong answer to each task.
const MISTAKES: [&str; 6] = [
    "viewing_ray_normalised",
    "sphere_near_root_only",
    "plane_ignores_min_t",
    "triangle_ignores_min_t",
    "triangle_soup_skips_one",
    "first_hit_last_wins",
];

/// Seconds, or ratios, by stage.
type Stages = BTreeMap<String, f64>;

fn main() {
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stages-bench");
    if check(&folder, &[]).is_none() {
        return println!("No stage can be compared: `check --sandbox bubblewrap` fails here.");
    }
    let rounds = (0..ROUNDS).filter_map(|_| check(&folder, &[]));
    // It takes longer than all else together.
    let judged_twice = (0..ROUNDS_OF_OIIOTOOL).map_while(|_| check(&folder, &["--oiiotool"]));
    let rounds: Vec<Stages> = rounds.chain(judged_twice).collect();
    let median = |of: &dyn Fn(&Stages) -> Option<f64>| {
        let mut all: Vec<f64> = rounds.iter().filter_map(of).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let compiler = rustc_version();
    let (known_compiler, baseline) = read_baseline();
    if known_compiler != compiler {
        println!("The baseline is that of {known_compiler}, so don't compare it with {compiler}.");
    }
    println!(
        "{:<34}{:>10}{:>12}{:>10}{:>12}",
        "stage", "seconds", "/ compiler", "baseline", "new / old"
    );
    let mut new = Stages::new();
    let mut names: Vec<&String> = rounds
        .iter()
        .chain([&baseline])
        .flat_map(Stages::keys)
        .collect();
    names.sort();
    names.dedup();
    for name in names {
        let seconds = median(&|round| round.get(name).copied());
        let ratio = median(&|round| Some(round.get(name)? / round.get(UNIT)?));
        let (Some(seconds), Some(ratio)) = (seconds, ratio) else {
            println!("{name:<34} not measured here, so it can't be compared");
            continue;
        };
        new.insert(name.clone(), ratio);
        print!("{name:<34}{seconds:>10.4}{ratio:>12.4}");
        match baseline.get(name) {
            Some(_) if name == UNIT => println!("   the unit of the others"),
            Some(old) => println!("{old:>10.4}{:>12.2}", ratio / old),
            None => println!("   not in the baseline, so it can't be compared"),
        }
    }
    if std::env::args().any(|argument| argument == "--save") {
        write_baseline(&compiler, &new);
    }
}

/// Checks answers that were never compiled before. `None` if that is impossible here.
fn check(folder: &Path, options: &[&str]) -> Option<Stages> {
    hand_in(folder);
    let output = Command::new(env!("CARGO_BIN_EXE_pinhole"))
        .args(["check", "--timings", "--json", "--sandbox", "bubblewrap"])
        .args(options)
        .arg(folder)
        .output()
        .expect("pinhole starts");
    // The answers are wrong, so 1 is success.
    if output.status.code() != Some(1) {
        print!("{}", String::from_utf8_lossy(&output.stderr));
        return None;
    }
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("it is JSON");
    let is_in = |list: &str, name: &str| {
        let items = result[list].as_array().expect("it is a list").iter();
        items.into_iter().any(|item| item["name"] == name)
    };
    let mut stages = Stages::new();
    for stage in result["timings"].as_array().expect("it is a list") {
        let name = stage["name"].as_str().expect("it is text");
        let name = match name.strip_prefix("ask ") {
            Some(what) if is_in("tasks", what) => "ask all tasks",
            Some(what) if is_in("scenes", what) => "cast all scenes",
            _ => name,
        };
        *stages.entry(name.to_owned()).or_default() += stage["seconds"].as_f64()?;
    }
    Some(stages)
}

/// Writes answers that differ from all earlier ones.
fn hand_in(folder: &Path) {
    let now = SystemTime::UNIX_EPOCH.elapsed().expect("it is past 1970");
    fs::create_dir_all(folder).expect("a folder can be made");
    for mistake in MISTAKES {
        let mistake = root()
            .join("assignments/ray_casting/mistakes")
            .join(mistake);
        for file in fs::read_dir(mistake).expect("the mistake is committed") {
            let file = file.expect("it can be read").path();
            if file.extension().is_some_and(|it| it == "rs") {
                let text = fs::read_to_string(&file).expect("it is text");
                let copy = folder.join(file.file_name().expect("it has a name"));
                fs::write(copy, format!("{text}\n// {now:?}\n")).expect("it can be written");
            }
        }
    }
}

fn read_baseline() -> (String, Stages) {
    let text = fs::read_to_string(baseline_file()).unwrap_or_default();
    let mut lines = text.lines();
    let compiler = lines
        .next()
        .unwrap_or("# no compiler")
        .trim_start_matches("# ");
    let stages = lines.collect::<Vec<_>>().join("\n");
    let stages = toml::from_str(&stages).expect("the baseline is TOML");
    (compiler.to_owned(), stages)
}

fn write_baseline(compiler: &str, stages: &Stages) {
    let rounded = stages
        .iter()
        .map(|(name, ratio)| (name, format!("{ratio:.4}")));
    let lines: String = rounded
        .map(|(name, ratio)| format!("{name:?} = {ratio}\n"))
        .collect();
    fs::write(baseline_file(), format!("# {compiler}\n{lines}")).expect("it can be written");
}

fn baseline_file() -> PathBuf {
    root().join("tools/cli/benches/stages.toml")
}

fn rustc_version() -> String {
    let output = Command::new("rustc").arg("--version").output();
    let output = output.expect("rustc starts").stdout;
    String::from_utf8_lossy(&output).trim().to_owned()
}

fn root() -> &'static Path {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package
        .ancestors()
        .nth(2)
        .expect("tools/cli is in the checkout")
}
