//! The checkout's own programs, built and started.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Result};

/// What cargo says of a file it has made.
#[derive(Deserialize)]
struct Artifact {
    executable: Option<PathBuf>,
}

/// Builds a program of the workspace; gives where it is.
pub fn build(package: &str, checkout: &Checkout) -> Result<PathBuf> {
    let remedy = format!("run `cargo build --release -p {package}` and mend what it says");
    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let output = Command::new(cargo)
        .current_dir(checkout.root())
        .args(["build", "--release", "--quiet", "-p", package])
        .arg("--message-format=json-render-diagnostics")
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| Error::environment(format!("cargo does not start: {error}"), &remedy))?;
    let said = String::from_utf8_lossy(&output.stdout);
    let mut executables = said
        .lines()
        .filter_map(|line| serde_json::from_str::<Artifact>(line).ok())
        .filter_map(|artifact| artifact.executable);
    match executables.next_back().filter(|_| output.status.success()) {
        Some(path) => Ok(path),
        None => Err(Error::environment(
            format!("{package} does not build"),
            remedy,
        )),
    }
}
