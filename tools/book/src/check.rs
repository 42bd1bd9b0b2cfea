//! Checks the built pages for everything that could be wrong in the book.

mod headings;
mod images;
mod links;
mod pages;
mod reading;
mod solutions;
mod spelling;
mod stray_directives;

use clap::ValueEnum as _;
use pinhole_course::checkout::Checkout;
use pinhole_course::mistake;

use crate::build::BuiltEdition;
use crate::course::assignments;
use crate::edition::Edition;
use crate::error::{Problem, Result};
use crate::{figures, gallery, interactive, run};

/// A part of the check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Part {
    /// The built pages: links, anchors, images, solutions, hints
    Pages,
    /// Whether commands still print what the book shows
    Runs,
    /// Whether the programs still draw the figures that the book shows
    Figures,
    /// Whether code with each known mistake still renders the pictures in the galleries
    Galleries,
    /// The interactive figures: whether the types in their code fit, and their mathematics (needs
    /// Node.js)
    Interactive,
    /// Spelling (needs Node.js)
    Spelling,
}

impl Part {
    /// All parts.
    pub const ALL: [Part; 6] = [
        Part::Pages,
        Part::Runs,
        Part::Figures,
        Part::Galleries,
        Part::Interactive,
        Part::Spelling,
    ];

    fn name(self) -> String {
        let value = self.to_possible_value().expect("none is hidden");
        value.get_name().to_owned()
    }
}

/// Everything that these parts of the check find wrong.
pub fn check(built: &[BuiltEdition], parts: &[Part], checkout: &Checkout) -> Result<Vec<Problem>> {
    let mut problems: Vec<Problem> = Vec::new();
    for (step, part) in (1..).zip(parts) {
        eprintln!("check {step} of {}: {}", parts.len(), part.name());
        match part {
            Part::Pages => {
                for edition in built {
                    problems.extend(self::built(edition, checkout)?);
                }
            }
            Part::Runs => problems.extend(run::check(checkout)?),
            Part::Figures => problems.extend(figures::check(checkout)?),
            Part::Galleries => problems.extend(gallery::check(checkout)?),
            Part::Interactive => problems.extend(interactive::check(checkout)?),
            Part::Spelling => problems.extend(spelling::check(checkout)?),
        }
    }
    // Both editions consist of the same pages, so report each problem once.
    let mut told: Vec<Problem> = Vec::new();
    for problem in problems {
        if !told.contains(&problem) {
            told.push(problem);
        }
    }
    Ok(told)
}

fn built(built: &BuiltEdition, checkout: &Checkout) -> Result<Vec<Problem>> {
    let pages = pages::read(&built.folder)?;
    let mut problems = built.problems.clone();
    problems.extend(links::dead(&pages, &built.folder, built.edition));
    problems.extend(links::vague(&pages, built.edition));
    problems.extend(images::silent(&pages));
    problems.extend(stray_directives::stray_directives(&pages));
    if built.edition == Edition::Student {
        print!("{}", reading::grades(&pages));
        problems.extend(reading::hard(&pages));
        for assignment in assignments(checkout)? {
            let mistakes = mistake::read_all(&assignment)?;
            problems.extend(headings::missing(&pages, &assignment, &mistakes, checkout));
            let answers = solutions::answers(&assignment, checkout)?;
            problems.extend(solutions::shown(&answers, &built.folder)?);
        }
    }
    Ok(problems)
}
