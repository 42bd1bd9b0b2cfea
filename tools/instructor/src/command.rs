//! The subcommands, each in a file of its own.

mod dispute;
mod grade;
mod handout;
mod merge;
mod validate;

use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_report::program::Status;

use crate::cli::{Cli, Command};
use crate::golden;

/// Runs the subcommand that the user chose.
pub fn run(cli: Cli) -> Result<Status> {
    let checkout = Checkout::find()?;
    match cli.command {
        Command::Golden(arguments) => golden::run(&checkout, &arguments),
        Command::Grade(arguments) => grade::run(&checkout, &arguments),
        Command::Dispute(arguments) => dispute::run(&arguments),
        Command::Merge(arguments) => merge::run(&checkout, &arguments),
        Command::Handout(arguments) => handout::run(&checkout, &arguments),
        Command::Validate(arguments) => validate::run(&checkout, &arguments),
    }
}
