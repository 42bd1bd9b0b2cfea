//! What is asked of goldens.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use pinhole_course::run_options::AssignmentOption;

#[derive(Subcommand)]
pub enum Golden {
    /// Make the Python environment with the pinned Mitsuba and oiiotool
    Setup,
    /// Render goldens with Mitsuba
    Render(GoldenRender),
    /// Cast the known mistakes on goldens that are there, for diagnoses
    Mistakes(GoldenMistakes),
    /// Check that goldens, scenes, scripts and manifest belong together
    Verify(GoldenVerify),
}

/// Render goldens with Mitsuba: a film and a tolerance film for each scene, the same
/// for its viewing rays, and a manifest of what they were made from. Then the known
/// mistakes cast the same, and what each does to every film is kept for diagnoses.
///
/// Without scenes, all of the assignment's are made, its probes, and the exact ties that
/// `validate --mutants` asks about, into `golden/`.
/// A scene is refused if a pixel centre lies on an edge, or if a ray meets a plane
/// too far out: shift its camera a little.
#[derive(Args)]
pub struct GoldenRender {
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// Scene files, or names of the assignment's scenes
    pub scenes: Vec<String>,
    /// Where to write [default: golden/ASSIGNMENT for the assignment's own scenes]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Make fresh probes and random scenes from this seed instead; needs --out
    #[arg(long, value_name = "N", conflicts_with = "scenes", requires = "out")]
    pub seed: Option<u64>,
    /// Leave out the known mistakes' films: sooner done, but nothing will be diagnosed
    #[arg(long)]
    pub no_mistakes: bool,
}

/// Cast the known mistakes on goldens that are there, and keep beside them what each
/// does to every film: by that, `check` and `diff` know a mistake when they see it.
///
/// `golden render` does the same; this is for when only a mistake has changed. Needs no
/// Mitsuba.
#[derive(Args)]
pub struct GoldenMistakes {
    #[command(flatten)]
    pub assignment: AssignmentOption,
    /// The folder of goldens [default: golden/ASSIGNMENT]
    pub dir: Option<PathBuf>,
}

/// Check that goldens, scenes, scripts and manifest belong together.
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
