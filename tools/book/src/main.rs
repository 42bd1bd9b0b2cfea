//! `pinhole book`: builds or checks the book.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::{Args, Parser, Subcommand};
use pinhole_book::build::{BuiltEdition, build};
use pinhole_book::check::{Part, check};
use pinhole_book::edition::Edition;
use pinhole_book::error::{Error, Problem, Result};
use pinhole_book::expand::Sources;
use pinhole_book::{figures, gallery, interactive, run, worked};
use pinhole_course::checkout::Checkout;

#[derive(Parser)]
#[command(name = "pinhole", bin_name = "pinhole", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    program: Program,
}

#[derive(Subcommand)]
enum Program {
    /// Build or check the book
    ///
    /// Exit codes: 0 if everything is right; 1 if figures or output in the book are out of date; 2
    /// if a page has an error; 3 if something is missing on this machine, or Pinhole has a bug.
    #[command(subcommand)]
    Book(Command),
}

#[derive(Subcommand)]
enum Command {
    /// Build the book
    Build {
        #[command(flatten)]
        which: BuildOptions,
        /// Build even if something is missing or wrong, and mark it in the pages
        #[arg(long)]
        draft: bool,
    },
    /// Build the book, and check everything in it
    Check {
        #[command(flatten)]
        which: BuildOptions,
        /// Check only this part (repeatable)
        #[arg(long, value_enum, value_name = "PART")]
        only: Vec<Part>,
    },
    /// Run the commands in book/commands.toml, and save what they print
    Capture {
        /// The names of the commands [default: all]
        ids: Vec<String>,
    },
    /// Make the gallery: for each known mistake, save the picture that distinguishes it from the
    /// others
    Gallery,
    /// Bundle and save the script of the interactive figures (needs Node.js)
    Bundle,
    /// Draw and save the figures
    Figures {
        /// The names of the figures [default: all]
        names: Vec<String>,
    },
}

#[derive(Args)]
struct BuildOptions {
    /// Build only this edition
    #[arg(long, value_enum)]
    edition: Option<Edition>,
    /// Write each edition to a subfolder of this folder [default: book/build]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    let Program::Book(command) = Cli::parse().program;
    match run_command(command) {
        Ok(problems) if problems.is_empty() => ExitCode::SUCCESS,
        Ok(problems) => {
            eprintln!("{}", Error::Sources(problems));
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("{error}");
            error.exit_code()
        }
    }
}

fn run_command(command: Command) -> Result<Vec<Problem>> {
    let checkout = Checkout::find()?;
    match command {
        Command::Build { which, draft } => {
            let built = editions(&which, &checkout)?;
            let problems: Vec<Problem> =
                built.into_iter().flat_map(|built| built.problems).collect();
            match (problems.is_empty(), draft) {
                (true, _) => Ok(Vec::new()),
                (false, true) => {
                    eprintln!("{}", Error::Sources(problems));
                    Ok(Vec::new())
                }
                (false, false) => Err(Error::Sources(problems)),
            }
        }
        Command::Check { which, only } => {
            let parts = match only.is_empty() {
                true => Part::ALL.to_vec(),
                false => only,
            };
            check(&editions(&which, &checkout)?, &parts, &checkout)
        }
        Command::Capture { ids } => run::capture(&ids, &checkout).map(|()| Vec::new()),
        Command::Gallery => gallery::keep(&checkout).map(|()| Vec::new()),
        Command::Bundle => interactive::bundle(&checkout).map(|()| Vec::new()),
        Command::Figures { names } => figures::keep(&names, &checkout).map(|()| Vec::new()),
    }
}

fn editions(which: &BuildOptions, checkout: &Checkout) -> Result<Vec<BuiltEdition>> {
    let here = std::env::current_dir().unwrap_or_default();
    let out = match &which.out {
        Some(out) => here.join(out),
        None => checkout.book().join("build"),
    };
    let mut wanted = Edition::ALL.to_vec();
    wanted.retain(|own| which.edition.is_none_or(|one| one == *own));
    let steps = 1 + wanted.len();
    eprintln!("1 of {steps}: the numbers of the worked examples");
    let sources = Arc::new(Sources::read(worked::values(checkout)?, checkout)?);
    let mut all = Vec::new();
    for (step, edition) in (2..).zip(wanted) {
        eprintln!(
            "{step} of {steps}: the edition in the folder `{}`",
            edition.name()
        );
        let built = build(&sources, edition, &out.join(edition.name()), checkout)?;
        println!("{}", built.folder.join("index.html").display());
        all.push(built);
    }
    Ok(all)
}
