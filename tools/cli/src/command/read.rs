//! `--read`: opens the page of the book that helps. If the book is not built yet, asks whether
//! to build it.

use std::io::{IsTerminal, Write, stderr, stdin};
use std::process::Command;

use pinhole_course::checkout::Checkout;
use pinhole_report::escape::printable;
use pinhole_report::passage::{self, Passage};

/// Opens a passage, and says whether that worked.
pub fn open(passage: &Passage, checkout: &Checkout) {
    let root = checkout.root();
    if passage::built(root).is_none() && passage::has_sources(root) && is_wanted() {
        // If the build fails, the program that builds the book has already said why.
        let _built_or_not = std::env::current_exe()
            .and_then(|pinhole| Command::new(pinhole).args(["book", "build"]).status());
    }
    anstream::println!("\n{}", printable(&passage.open(root)));
}

/// Asks the user, if there is one at a terminal.
fn is_wanted() -> bool {
    if !stdin().is_terminal() || !stderr().is_terminal() {
        return false;
    }
    eprint!("\nThe book is not built yet. Building it takes a minute or two. Build it now? [Y/n] ");
    let mut answer = String::new();
    let asked = stderr()
        .flush()
        .and_then(|()| stdin().read_line(&mut answer));
    let answer = answer.trim().to_lowercase();
    asked.is_ok() && (answer.is_empty() || answer.starts_with('y'))
}
