//! `pinhole completions SHELL`: a script that completes subcommands and options.

use std::io;

use clap::CommandFactory;
use clap_complete::generate;
use pinhole_report::program::Status;

use crate::cli::{Cli, Completions};
use crate::programs;

pub fn run(arguments: &Completions) -> Status {
    // Only the names of the other programs' subcommands. Their options are unknown here.
    let others = programs::commands().map(clap::Command::new);
    let mut command = Cli::command().subcommands(others);
    generate(arguments.shell, &mut command, "pinhole", &mut io::stdout());
    Status::Well
}
