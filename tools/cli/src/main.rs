//! The `pinhole` command, as students have it.
//!
//! Reading order: [`cli`] is the command line; `command` has a file for each subcommand;
//! [`watch`] judges answers at every save; [`programs`] passes on the subcommands that other
//! programs of the course have; [`version`] is for `--version`.

mod cli;
mod command;
mod programs;
mod version;
mod watch;

use std::process::ExitCode;

use clap::Parser;
use pinhole_course::sandbox;
use pinhole_report::program;

fn main() -> ExitCode {
    // This must come first, because inside a sandbox there is no checkout.
    if let Some(code) = sandbox::become_confined() {
        return code;
    }
    if let Some(code) = programs::pass_on() {
        return code;
    }
    if let Some(version) = version::asked() {
        anstream::println!("{version}");
        return ExitCode::SUCCESS;
    }
    let cli = cli::Cli::parse();
    program::run(cli.command.wants_json(), || command::run(cli))
}
