//! One file for each thing the command does.

mod check;
mod diff;
mod explain;
mod render;

use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_report::program::Status;

use crate::cli::{Cli, Command};

/// Does what was asked.
pub fn run(cli: Cli) -> Result<Status> {
    let checkout = Checkout::find()?;
    match cli.command {
        Command::Check(arguments) => check::run(&checkout, &arguments),
        Command::Render(arguments) => render::run(&checkout, &arguments),
        Command::Explain(arguments) => explain::run(&checkout, &arguments),
        Command::Diff(arguments) => diff::run(&checkout, &arguments),
    }
}
