//! `pinhole render`: a film and its pictures.

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::time::{Duration, Instant};

use pinhole::job::Job;
use pinhole::report::number;
use pinhole::{Film, Resolution, Scene, false_colour};
use serde_json::{Value, json};

use super::Outcome;
use super::built::built;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Render;
use crate::describe::printable;
use crate::error::{Error, Result};
use crate::examine;
use crate::progress::Progress;
use crate::sandbox::Limits;
use crate::{pictures, table};

/// What was cast, by whom.
pub struct Cast {
    pub film: Film,
    pub by: String,
    pub seconds: f64,
    /// Why the film is not complete.
    pub problem: Option<String>,
    /// What a student's code printed.
    pub printed: String,
    /// What exact casting took, as the study tells it.
    pub exact: Option<Value>,
    /// What planned casting took, and the plan.
    pub planned: Option<Value>,
}

impl Cast {
    fn is_by_submission(&self) -> bool {
        self.exact.is_none() && self.planned.is_none()
    }
}

pub fn run(checkout: &Checkout, arguments: &Render) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, arguments.submission.as_ref().unwrap_or(&here))?;
    let (mut scene, golden) = super::scene(&arguments.scene, &assignment, checkout)?;
    scene.resolution = arguments.resolution.unwrap_or(scene.resolution);
    let (resolution, depth_per_t) = (scene.resolution, scene.camera.depth_per_t());
    let cannot = |error: std::io::Error| {
        let problem = format!("cannot write to {}: {error}", arguments.out.display());
        Error::input(problem, "name a folder you may write to with --out")
    };
    fs::create_dir_all(&arguments.out).map_err(cannot)?;
    let path = arguments.out.join("film.exr");
    let cast = cast(checkout, &assignment, arguments, scene, &path)?;
    cast.film.write(&path)?;

    let range = match &golden {
        Some(golden) => false_colour::depth_range(&Film::read(golden)?, depth_per_t),
        None => false_colour::depth_range(&cast.film, depth_per_t),
    };
    let mut written = vec![path.display().to_string()];
    written.extend(pictures::write(
        &arguments.out,
        "",
        &cast.film,
        depth_per_t,
        range.clone(),
    )?);
    let is_complete = cast.problem.is_none();
    tell(arguments, &cast, resolution, &range, &written);
    Ok(if is_complete {
        Outcome::Well
    } else {
        Outcome::JudgedWrong
    })
}

/// By the study's caster, exactly or as planned, if that is wanted.
#[cfg(feature = "study")]
fn cast(
    checkout: &Checkout,
    assignment: &Assignment,
    arguments: &Render,
    scene: Scene,
    path: &Path,
) -> Result<Cast> {
    let is_planned = arguments.plan.is_some();
    if !is_planned && !arguments.wanted.is_empty() {
        return Err(Error::input(
            "--ids and --outputs say what a plan is for",
            "say how accurate it is to be with --plan X",
        ));
    }
    match arguments.exact || is_planned {
        true => super::study::film(checkout, assignment, arguments, path),
        false => by_submission(checkout, assignment, arguments, scene),
    }
}

#[cfg(not(feature = "study"))]
fn cast(
    checkout: &Checkout,
    assignment: &Assignment,
    arguments: &Render,
    scene: Scene,
    _: &Path,
) -> Result<Cast> {
    by_submission(checkout, assignment, arguments, scene)
}

fn by_submission(
    checkout: &Checkout,
    assignment: &Assignment,
    arguments: &Render,
    scene: Scene,
) -> Result<Cast> {
    let built = built(
        checkout,
        assignment,
        arguments.submission.as_ref(),
        &arguments.run,
    )?;
    let progress = Progress::new();
    let resolution = scene.resolution;
    let pixels = resolution.pixels() as f64;
    let wall = Duration::from_secs(arguments.run.timeout);
    let start = Instant::now();
    let reply = examine::run(
        &built.program,
        &built.sandbox,
        &Limits::of_answers(wall),
        &Job::Film(scene),
        &mut |done| {
            progress.show("casting", done as f64 / pixels);
        },
    )?;
    let seconds = start.elapsed().as_secs_f64();
    progress.clear();
    let problem = examine::failure(&reply.ending, assignment, None);
    Ok(Cast {
        film: reply.film(resolution),
        by: built.submission.folder.display().to_string(),
        seconds,
        problem: problem.as_ref().map(table::outcome),
        printed: reply.printed,
        exact: None,
        planned: None,
    })
}

/// Says what came of it.
fn tell(
    arguments: &Render,
    cast: &Cast,
    resolution: Resolution,
    range: &Range<f64>,
    written: &[String],
) {
    let hits = cast
        .film
        .channel("id")
        .unwrap_or_default()
        .iter()
        .filter(|id| **id >= 0.0)
        .count();
    if arguments.json {
        anstream::println!(
            "{:#}",
            json!({
                "scene": arguments.scene,
                "submission": cast.is_by_submission().then_some(&cast.by),
                "exact": cast.exact,
                "planned": cast.planned,
                "resolution": [resolution.n_x, resolution.n_y],
                "hits": hits,
                "depth_range": [range.start, range.end],
                "seconds": cast.seconds,
                "files": written,
                "problem": cast.problem,
            })
        );
    } else {
        anstream::println!(
            "{resolution} pixels in {:.2} s, {hits} of them hit something, by {}",
            cast.seconds,
            printable(&cast.by)
        );
        if hits == 0 && cast.problem.is_none() {
            anstream::println!(
                "every ray missed; see one of them: cargo run --release -- explain {} {} {}",
                arguments.scene,
                resolution.n_x / 2,
                resolution.n_y / 2
            );
        }
        let (near, far) = (number(range.start, 4), number(range.end, 4));
        anstream::println!("depth.png spans {near} (bright) to {far} (dark) scene units");
        for file in written {
            anstream::println!("wrote {file}");
        }
        if !cast.printed.is_empty() {
            anstream::eprintln!("your code printed:");
            for line in cast.printed.lines() {
                anstream::eprintln!("  {}", printable(line));
            }
        }
        if let Some(problem) = &cast.problem {
            anstream::println!("the film is not complete: {problem}");
        }
    }
}
