//! The `pinhole` command.
//!
//! Reading order: [`cli`] for what can be asked; one file in `command` for each
//! thing it does; [`submission`], [`compile`], [`sandbox`], [`examine`] for the way
//! from a student's folder to an [`examination`]; [`table`] and [`json`] for how
//! that is shown.

mod assignment;
mod blame;
mod checkout;
mod cli;
mod command;
mod compile;
mod describe;
mod error;
mod examination;
mod examine;
mod explanation;
mod goldens;
mod harness;
mod json;
mod manifest;
mod mitsuba;
mod pictures;
mod progress;
mod questions;
mod sandbox;
mod second_judge;
mod stubs;
mod submission;
mod table;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    match command::run(cli::Cli::parse()) {
        Ok(command::Outcome::Well) => ExitCode::SUCCESS,
        Ok(command::Outcome::JudgedWrong) => ExitCode::from(1),
        Err(error) => {
            anstream::eprintln!("pinhole: {error}");
            error.exit_code()
        }
    }
}
