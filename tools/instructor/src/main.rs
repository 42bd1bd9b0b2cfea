//! The subcommands of `pinhole` for instructors.
//!
//! Reading order: [`cli`] is the command line; [`grade`] grades a class of submissions;
//! [`handout`] makes what students get; [`golden`] makes goldens and the films of known
//! mistakes; [`validate`] tests the grading.

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
    // This must come first, because inside a sandbox there is no checkout.
    if let Some(code) = sandbox::become_confined() {
        return code;
    }
    let cli = cli::Cli::parse();
    program::run(cli.command.wants_json(), || command::run(cli))
}
