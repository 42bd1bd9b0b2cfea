//! The `pinhole` command.
//!
//! Reading order: [`cli`] for what can be asked; one file in `command` for each
//! thing it does; [`submission`], [`compile`], [`sandbox`], [`examine`] for the way
//! from a student's folder to an [`examination`]; [`table`], [`json`] and [`report`]
//! for how that is shown; [`watch`] for doing all that at every save; [`validate`] for
//! how all of it is itself measured.

// Some of what students have serves `validate` alone, which they have not.
#![cfg_attr(not(feature = "validate"), allow(dead_code))]

mod assignment;
mod blame;
mod checkout;
mod cli;
mod command;
mod compile;
mod describe;
mod desktop;
mod diagnose;
mod diagnosis;
mod error;
mod examination;
mod examine;
mod explanation;
mod goldens;
mod grade;
mod handout;
mod harness;
mod json;
mod manifest;
mod mistake;
mod mistake_films;
mod mitsuba;
mod overlay;
mod passage;
mod pictures;
mod progress;
mod questions;
mod report;
mod sandbox;
mod second_judge;
mod shell;
mod stubs;
mod submission;
mod table;
#[cfg(feature = "validate")]
mod validate;
mod watch;

use std::panic::{self, PanicHookInfo};
use std::process::ExitCode;

use clap::Parser;
use error::Error;

fn main() -> ExitCode {
    panic::set_hook(Box::new(confess));
    let cli = cli::Cli::parse();
    // Before anything else: inside the walls there is no checkout.
    #[cfg(target_os = "linux")]
    if let cli::Command::Confine(confine) = &cli.command {
        return sandbox::confine::run(confine);
    }
    let json = cli.command.wants_json();
    let ran = panic::catch_unwind(|| command::run(cli));
    match ran {
        Ok(Ok(command::Outcome::Well)) => ExitCode::SUCCESS,
        Ok(Ok(command::Outcome::JudgedWrong)) => ExitCode::from(1),
        Ok(Ok(command::Outcome::Incomplete)) => ExitCode::from(3),
        Ok(Err(error)) => {
            if json {
                let Error {
                    problem, remedy, ..
                } = &error;
                anstream::println!(
                    "{:#}",
                    serde_json::json!({ "error": problem, "remedy": remedy })
                );
            }
            anstream::eprintln!("pinhole: {error}");
            error.exit_code()
        }
        Err(_) => ExitCode::from(3),
    }
}

/// What a person reads if this program fails in a way nobody thought of.
fn confess(info: &PanicHookInfo<'_>) {
    let what = info.payload_as_str().unwrap_or("(no message)");
    // Whoever reads our output may stop reading, as `head` does.
    if !what.starts_with("failed printing to") {
        let place = info.location().map(ToString::to_string).unwrap_or_default();
        eprintln!("pinhole: a fault of its own at {place}: {what}\n  remedy: report it");
    }
}
