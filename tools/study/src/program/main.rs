//! The subcommands of `pinhole` that measure speed and accuracy.

mod cli;
mod render;
mod study;

use std::process::ExitCode;

use clap::Parser;
use cli::{Cli, Command, Record};
use pinhole_course::checkout::Checkout;
use pinhole_report::program::{self, Status};
use pinhole_study::judge::rule_of_three;
use pinhole_study::record::record;
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::{classes, scenes, speed};

fn main() -> ExitCode {
    let cli = Cli::parse();
    program::run(cli.command.wants_json(), || match cli.command {
        Command::Study(arguments) => study::run(&arguments),
        Command::Plan(arguments) => render::explain(&Checkout::find()?, &arguments),
        Command::Render(arguments) => render::render(&Checkout::find()?, &arguments),
        Command::Record(arguments) => Ok(run_rounds(&arguments)),
        Command::Cast {
            shape,
            kernel,
            casts,
        } => {
            let _is_known = scenes::cast(&shape, kernel, casts)
                || classes::cast::<Sphere<f64>>(&shape, kernel, casts)
                || classes::cast::<Plane<f64>>(&shape, kernel, casts)
                || classes::cast::<Triangle<f64>>(&shape, kernel, casts);
            anstream::print!("{}", speed::DONE);
            Ok(Status::Well)
        }
    })
}

/// Runs all rounds of [`record`], and fails if any answer is wrong.
fn run_rounds(arguments: &Record) -> Status {
    let end = arguments.from + arguments.rounds;
    let (mut from, mut is_well) = (arguments.from, true);
    while from < end {
        // Report every thousand rounds, so that a crash loses at most a thousand.
        let to = end.min(from + 1_000);
        let count = record(arguments.kind, from..to, arguments.seed);
        let (asked, wrong) = (count.asked, count.wrong);
        let bound = match wrong {
            0 => format!("below {:.1e} with 95 % confidence", rule_of_three(asked)),
            _ => format!("in rounds {:?}", count.broken),
        };
        anstream::println!(
            "rounds {from} to {}: {wrong} wrong of {asked} ({bound}); {} hits, {} exact",
            to - 1,
            count.hits,
            count.exact
        );
        is_well &= wrong == 0;
        from = to;
    }
    match is_well {
        true => Status::Well,
        false => Status::JudgedWrong,
    }
}
