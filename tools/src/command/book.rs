//! `pinhole book`: starts the package that builds the book, which this one does not need.

use std::env;
use std::process::Command;

use super::Outcome;
use crate::checkout::Checkout;
use crate::cli::Book;
use crate::error::{Error, Result};

/// Hands everything on, and takes its exit code for ours.
pub fn run(checkout: &Checkout, arguments: &Book) -> Result<Outcome> {
    let remedy = "run `cargo build --release -p pinhole-book` and mend what it says";
    let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
    // Not from the checkout's top folder: `--out` is relative to where its user stands.
    let status = Command::new(cargo)
        .args(["run", "--release", "--quiet", "--manifest-path"])
        .arg(checkout.root().join("tools/book/Cargo.toml"))
        .arg("--")
        .args(&arguments.arguments)
        .status()
        .map_err(|error| Error::environment(format!("cargo does not start: {error}"), remedy))?;
    match status.code() {
        Some(0) => Ok(Outcome::Well),
        Some(1) => Ok(Outcome::JudgedWrong),
        Some(2) => Err(Error::input(
            "the book's sources are wrong",
            "mend what is named above",
        )),
        _ => Err(Error::environment("the book could not be built", remedy)),
    }
}
