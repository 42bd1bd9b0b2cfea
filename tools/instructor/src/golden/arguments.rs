//! The arguments of `pinhole golden`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::seed::Seed;

#[derive(Subcommand)]
pub enum Golden {
    /// Install the pinned versions of Mitsuba and oiiotool
    Setup,
    Render(GoldenRender),
    Mistakes(GoldenMistakes),
    Verify(GoldenVerify),
}

/// Render goldens with Mitsuba
///
/// For each scene, makes a film and its tolerance film, and two more films for the scene's viewing
/// rays. Also makes a manifest that says what all these films were made from. Then runs code with
/// each known mistake, and stores what the mistake changes in the films, so that `check` and `diff`
/// can recognise it.
///
/// If you name no scene, this makes everything that the assignment has in `golden/`: the films of
/// its scenes, the films of its questions, and more questions for `validate --mutants`. Many of
/// those are exact ties: to answer them, code compares two values that are equal.
///
/// A scene is refused if an edge passes through a pixel's centre, or if a pixel's centre lies
/// close to a plane's horizon. If that happens, move the camera a little.
#[derive(Args)]
pub struct GoldenRender {
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Scene files, or names of the assignment's scenes
    pub scenes: Vec<String>,
    /// Write the films to this folder [default: golden/ASSIGNMENT for the assignment's own
    /// scenes]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Make fresh questions and random scenes from this seed, instead of the assignment's own
    /// questions and scenes; `random` draws a seed that nobody can guess. Needs --out
    #[arg(long, value_name = "N", value_parser = seed, conflicts_with = "scenes", requires = "out")]
    pub seed: Option<Seed>,
    /// Replace the assignment's own films, on which every mark depends
    #[arg(long)]
    pub force: bool,
    /// Leave out the known mistakes; this is faster, but then no mistake can be recognised
    #[arg(long)]
    pub no_mistakes: bool,
}

/// Recompute how the films rendered with each known mistake differ from the existing goldens; doesn't need
/// Mitsuba
///
/// Stores beside each golden what each mistake changes in the film, so that `check` and `diff` can
/// recognise the mistake. `golden render` does this too. Use this command when you have added or
/// changed a mistake, but no scene.
#[derive(Args)]
pub struct GoldenMistakes {
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// The folder of goldens [default: golden/ASSIGNMENT]
    pub dir: Option<PathBuf>,
}

/// Check that the goldens, and the scenes and scripts that they were made from, match
/// `manifest.toml`
#[derive(Args)]
pub struct GoldenVerify {
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// The folder of goldens [default: golden/ASSIGNMENT]
    pub dir: Option<PathBuf>,
    /// Print one JSON document on standard output
    #[arg(long)]
    pub json: bool,
}

/// A number, or the word `random`.
fn seed(text: &str) -> Result<Seed, String> {
    match text {
        "random" => random_seed().map_err(|error| error.to_string()),
        digits => digits
            .parse()
            .map_err(|_| format!("`{digits}` is neither a whole number nor `random`")),
    }
}

/// A seed that nobody can guess, from the system's own randomness.
pub fn random_seed() -> Result<Seed, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(Seed(u128::from_le_bytes(bytes)))
}
