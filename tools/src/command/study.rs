//! `pinhole study` and `pinhole render --exact`: a package of its own, compiled when it is
//! first asked for.

mod submission;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use pinhole::Film;
use serde_json::Value;

use super::Outcome;
use super::render::Cast;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::{Render, Study};
use crate::error::{Error, Result};

/// The study's own program, by way of cargo, which compiles it if need be.
fn program(checkout: &Checkout) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["run", "--release", "--package", "pinhole-study"]);
    let manifest = checkout.root().join("Cargo.toml");
    cargo.arg("--manifest-path").arg(manifest).arg("--");
    cargo
}

fn cannot_start(error: std::io::Error) -> Error {
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

/// A film by the study's exact caster, by way of a file.
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
    if let Some(resolution) = arguments.resolution {
        let (n_x, n_y) = (resolution.n_x.to_string(), resolution.n_y.to_string());
        cargo.args(["--resolution", &n_x, &n_y]);
    }
    let output = cargo.stderr(Stdio::inherit()).output();
    let output = output.map_err(cannot_start)?;
    let report: Option<Value> = serde_json::from_slice(&output.stdout).ok();
    let Some(report) = report.filter(|_| output.status.success()) else {
        return Err(Error::environment(
            "nothing was cast",
            "see the study's message above",
        ));
    };
    let count = |name: &str| report[name].as_u64().unwrap_or(0);
    Ok(Cast {
        film: Film::read(path)?,
        by: format!(
            "the exact caster: {} of {} tests and {} comparisons needed exact arithmetic",
            count("fallbacks"),
            count("tests"),
            count("close_calls")
        ),
        seconds: report["seconds"].as_f64().unwrap_or(0.0),
        problem: None,
        printed: String::new(),
        exact: Some(report),
    })
}
