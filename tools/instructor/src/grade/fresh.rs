//! Questions that nobody has seen, the same for the whole class.
//!
//! Whoever has the public goldens could write them into the answer files. Probes and
//! scenes from a fresh seed cannot be known before they are made.

use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::path::Path;

use crate::golden;
use crate::golden::arguments::GoldenRender;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba;
use pinhole_course::run_options::AssignmentOption;

/// The fresh goldens in `folder`, made if they are not there; `None` if there is no
/// Mitsuba to make them.
pub fn find_or_make(
    folder: &Path,
    seed: Option<u64>,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<Option<(Goldens, u64)>> {
    let kept = Manifest::read(folder)
        .ok()
        .and_then(|manifest| manifest.probe_seed);
    let same = kept.filter(|kept| seed.is_none_or(|seed| seed == *kept));
    if let Some(seed) = same {
        return Ok(Some((Goldens::read(folder, assignment)?, seed)));
    }
    if !mitsuba::is_there(checkout) {
        return match seed {
            Some(_) => Err(Error::environment(
                "there is no Mitsuba here to make fresh questions with",
                "make its environment: cargo pinhole golden setup, or pass --no-fresh",
            )),
            None => Ok(None),
        };
    }
    let seed = seed.unwrap_or_else(chosen);
    anstream::eprintln!("making fresh questions with Mitsuba, seed {seed} …");
    // Complete or not there at all, whenever we are killed.
    let beside = folder.with_extension("new");
    let _left_behind = fs::remove_dir_all(&beside);
    let request = GoldenRender {
        assignment: AssignmentOption::default(),
        scenes: Vec::new(),
        out: Some(beside.clone()),
        seed: Some(seed),
        no_mistakes: true,
    };
    golden::make(assignment, checkout, &request)?;
    let _of_another_seed = fs::remove_dir_all(folder);
    fs::rename(&beside, folder).map_err(|error| {
        let problem = format!(
            "cannot keep fresh questions in {}: {error}",
            folder.display()
        );
        Error::environment(problem, "check that the folder can be written")
    })?;
    Ok(Some((Goldens::read(folder, assignment)?, seed)))
}

/// A seed that nobody can guess: the system's own randomness.
fn chosen() -> u64 {
    RandomState::new().hash_one(std::process::id()) >> 33
}
