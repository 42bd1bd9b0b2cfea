//! `pinhole handout`: stubs from the reference.

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Handout;
use crate::error::Result;
use crate::stubs;

pub fn run(checkout: &Checkout, arguments: &Handout) -> Result<Outcome> {
    let assignment = Assignment::read(checkout, &arguments.assignment)?;
    let package = stubs::generate(&assignment)?;
    let stale = stubs::out_of_step(&package, &assignment.handout());
    if !arguments.check {
        stubs::write(&package, &assignment.handout())?;
        anstream::println!(
            "{} of {} files were out of step",
            stale.len(),
            package.len()
        );
        return Ok(Outcome::Well);
    }
    for path in &stale {
        anstream::println!("out of step with the reference: {}", path.display());
    }
    match stale.as_slice() {
        [] => {
            anstream::println!("the handout is in step with the reference");
            Ok(Outcome::Well)
        }
        _ => {
            anstream::println!(
                "mend it: cargo run --release -- handout {}",
                arguments.assignment
            );
            Ok(Outcome::JudgedWrong)
        }
    }
}
