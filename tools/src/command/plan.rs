//! `pinhole plan`: the study plans, and tells.

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Plan;
use crate::error::Result;

use super::Outcome;
use super::study::{at_resolution, cannot_start, not_done, program};

pub fn run(checkout: &Checkout, arguments: &Plan) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, &here)?;
    let mut cargo = program(checkout);
    cargo.arg("plan");
    cargo.arg(super::scene_file(&arguments.scene, &assignment)?);
    cargo.arg("--accuracy").arg(arguments.accuracy.to_string());
    cargo.args(arguments.wanted.told());
    at_resolution(&mut cargo, arguments.resolution);
    cargo.args(arguments.json.then_some("--json"));
    let status = cargo.status().map_err(cannot_start)?;
    match status.success() {
        true => Ok(Outcome::Well),
        false => Err(not_done(status, "nothing was planned")),
    }
}
