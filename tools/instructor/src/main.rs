//! The subcommands of `pinhole` that instructors have.
//!
//! Reading order: [`cli`] for the command line; [`grade`] for a class of submissions;
//! [`handout`] for what students get; [`golden`] for goldens and what they know of
//! mistakes; [`validate`] for how all of it is itself measured.

mod cli;
mod command;
mod golden;
mod grade;
mod handout;
mod scene_cap;
mod validate;

use std::process::ExitCode;

use clap::Parser;
use pinhole_course::sandbox;
use pinhole_report::program;

fn main() -> ExitCode {
    // Before anything else: inside a sandbox there is no checkout.
    if let Some(code) = sandbox::become_confined() {
        return code;
    }
    let cli = cli::Cli::parse();
    program::run(cli.command.wants_json(), || command::run(cli))
}
