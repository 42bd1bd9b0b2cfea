//! `pinhole study`, and `pinhole render` with `--exact` or `--plan`: a package of its own,
//! compiled when it is first asked for.

mod submission;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::{env, fs};

use clap::ValueEnum;
use pinhole::{Film, Resolution};
use serde_json::Value;

use super::Outcome;
use super::render::Cast;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::{Render, Study, Wanted};
use crate::error::{Error, Result};

/// The study's own program, by way of cargo, which compiles it if need be.
pub fn program(checkout: &Checkout) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["run", "--release", "--package", "pinhole-study"]);
    let manifest = checkout.root().join("Cargo.toml");
    cargo.arg("--manifest-path").arg(manifest).arg("--");
    cargo
}

pub fn cannot_start(error: std::io::Error) -> Error {
    Error::environment(format!("cannot run cargo: {error}"), "install Rust")
}

pub fn run(checkout: &Checkout, arguments: &Study) -> Result<Outcome> {
    let mut cargo = program(checkout);
    cargo.arg("--out").arg(&arguments.out);
    let is_quick = arguments.quick || arguments.submission.is_some();
    cargo.args(is_quick.then_some("--quick"));
    let theirs = arguments.submission.as_ref();
    let answers = theirs.map(|folder| submission::answers(checkout, arguments, folder));
    let answers = answers.transpose()?;
    if let Some(file) = &answers {
        cargo.arg("--answers").arg(file);
    }
    cargo.args(arguments.json.then_some("--json"));
    if let Some(family) = &arguments.only {
        cargo.args(["--only", family]);
    }
    // Its progress and its results go where ours would.
    let status = cargo.status().map_err(cannot_start)?;
    if let Some(file) = answers {
        let _swept_away_some_day = fs::remove_file(file);
    }
    match status.code() {
        Some(0) => Ok(Outcome::Well),
        Some(1) => Ok(Outcome::JudgedWrong),
        Some(2) => Err(Error::input(
            "the study was not made",
            "see its message above",
        )),
        _ => Err(Error::environment(
            "the study was not made",
            "see its message above",
        )),
    }
}

/// A part of the study's program that writes a file and has nothing to say.
fn run_quietly(checkout: &Checkout, part: &str, file: &Path) -> Result<()> {
    let mut cargo = program(checkout);
    let status = cargo.arg(part).arg(file).status().map_err(cannot_start)?;
    match status.success() {
        true => Ok(()),
        false => Err(Error::environment(
            "the study has no questions",
            "see its message above",
        )),
    }
}

/// A file of this process alone.
fn scratch(checkout: &Checkout, what: &str) -> Result<PathBuf> {
    let folder = checkout.scratch().join("study");
    fs::create_dir_all(&folder).map_err(|error| {
        Error::environment(
            format!("cannot make {}: {error}", folder.display()),
            "make room on the disk",
        )
    })?;
    Ok(folder.join(format!("{what}.{}", std::process::id())))
}

/// A film by the study's caster, exact or as planned, by way of a file.
pub fn film(
    checkout: &Checkout,
    assignment: &Assignment,
    arguments: &Render,
    path: &Path,
) -> Result<Cast> {
    let mut cargo = program(checkout);
    cargo.arg("film");
    cargo.arg(super::scene_file(&arguments.scene, assignment)?);
    cargo.arg(path);
    at_resolution(&mut cargo, arguments.resolution);
    if let Some(accuracy) = arguments.plan {
        cargo.arg("--plan").arg(accuracy.to_string());
        cargo.args(arguments.wanted.told());
    }
    let output = cargo.stderr(Stdio::inherit()).output();
    let output = output.map_err(cannot_start)?;
    let report: Option<Value> = serde_json::from_slice(&output.stdout).ok();
    let Some(report) = report.filter(|_| output.status.success()) else {
        return Err(not_done(output.status, "nothing was cast"));
    };
    let count = |name: &str| report.pointer(name).and_then(Value::as_u64).unwrap_or(0);
    let by = match arguments.plan {
        None => format!(
            "the exact caster: {} of {} tests and {} comparisons needed exact arithmetic",
            count("/fallbacks"),
            count("/tests"),
            count("/close_calls")
        ),
        Some(accuracy) => format!(
            "the plan for {accuracy:e}: {} pixels were cast again in f64, {} exactly; why: \
             cargo run --release -- plan {} --accuracy {accuracy:e}",
            count("/spent/again_in_f64"),
            count("/spent/again_exactly"),
            arguments.scene
        ),
    };
    let is_planned = arguments.plan.is_some();
    Ok(Cast {
        film: Film::read(path)?,
        by,
        seconds: report["seconds"].as_f64().unwrap_or(0.0),
        problem: None,
        printed: String::new(),
        exact: (!is_planned).then(|| report.clone()),
        planned: is_planned.then_some(report),
    })
}

/// The study has told why on standard error.
pub fn not_done(status: ExitStatus, what: &str) -> Error {
    let remedy = "see the study's message above";
    match status.code() {
        Some(2) => Error::input(what, remedy),
        _ => Error::environment(what, remedy),
    }
}

/// Not at the scene's own.
pub fn at_resolution(study: &mut Command, resolution: Option<Resolution>) {
    if let Some(resolution) = resolution {
        let (n_x, n_y) = (resolution.n_x.to_string(), resolution.n_y.to_string());
        study.args(["--resolution", &n_x, &n_y]);
    }
}

impl Wanted {
    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.ids.is_none() && self.outputs.is_empty()
    }

    /// As the study understands it.
    pub fn told(&self) -> Vec<String> {
        let outputs: Vec<String> = self.outputs.iter().map(word).collect();
        let mut told = Vec::new();
        told.extend(self.ids.map(|ids| format!("--ids={}", word(&ids))));
        if !outputs.is_empty() {
            told.push(format!("--outputs={}", outputs.join(",")));
        }
        told
    }
}

/// As a user types it.
fn word(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value().expect("none is hidden");
    value.get_name().to_owned()
}
