//! The subcommands, each in a file of its own.

mod check;
mod completions;
mod diff;
mod doctor;
mod examples;
mod explain;
mod read;
mod render;
mod reset;

use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_report::program::Status;

use crate::cli::{Cli, Command};

/// Runs the subcommand that the user chose.
pub fn run(cli: Cli) -> Result<Status> {
    let checkout = Checkout::find()?;
    match cli.command {
        Command::Check(arguments) => check::run(&checkout, &arguments),
        Command::Render(arguments) => render::run(&checkout, &arguments),
        Command::Explain(arguments) => explain::run(&checkout, &arguments),
        Command::Examples(arguments) => examples::run(&checkout, &arguments),
        Command::Diff(arguments) => diff::run(&checkout, &arguments),
        Command::Reset(arguments) => reset::run(&checkout, &arguments),
        Command::Doctor(arguments) => doctor::run(&checkout, &arguments),
        Command::Completions(arguments) => Ok(completions::run(&arguments)),
    }
}
