//! `pinhole study`: a package of its own, compiled when it is first asked for.

use std::env;
use std::process::Command;

use super::Outcome;
use crate::checkout::Checkout;
use crate::cli::Study;
use crate::error::{Error, Result};

pub fn run(checkout: &Checkout, arguments: &Study) -> Result<Outcome> {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args([
        "run",
        "--release",
        "--package",
        "pinhole-study",
        "--manifest-path",
    ]);
    cargo.arg(checkout.root().join("Cargo.toml")).arg("--");
    cargo.arg("--out").arg(&arguments.out);
    cargo.args(arguments.quick.then_some("--quick"));
    cargo.args(arguments.json.then_some("--json"));
    if let Some(family) = &arguments.only {
        cargo.args(["--only", family]);
    }
    // Its progress and its results go where ours would.
    let status = cargo.status().map_err(|error| {
        Error::environment(format!("cannot run cargo: {error}"), "install Rust")
    })?;
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
