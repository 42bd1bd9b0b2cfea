//! The subcommands of `pinhole` that measure speed and accuracy.

mod cli;
mod plan;
mod record;
mod render;
mod study;

use std::process::ExitCode;

use clap::Parser;
use cli::{Cli, Command};
use pinhole_course::checkout::Checkout;
use pinhole_report::program::{self, Status};
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::{classes, instructions, scenes};

fn main() -> ExitCode {
    let cli = Cli::parse();
    program::run(cli.command.wants_json(), || match cli.command {
        Command::Study(arguments) => study::run(&arguments),
        Command::Plan(arguments) => plan::run(&Checkout::find()?, &arguments),
        Command::Render(arguments) => render::run(&Checkout::find()?, &arguments),
        Command::Record(arguments) => Ok(record::run(&arguments)),
        Command::Cast {
            shape,
            kernel,
            casts,
        } => {
            let _is_known = scenes::cast(&shape, kernel, casts)
                || classes::cast::<Sphere<f64>>(&shape, kernel, casts)
                || classes::cast::<Plane<f64>>(&shape, kernel, casts)
                || classes::cast::<Triangle<f64>>(&shape, kernel, casts);
            anstream::print!("{}", instructions::DONE);
            Ok(Status::Well)
        }
    })
}
