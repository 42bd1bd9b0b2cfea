//! `pinhole render`: a film and its pictures.

use std::fs;
use std::time::{Duration, Instant};

use pinhole::job::Job;
use pinhole::report::number;
use pinhole::{Film, false_colour};
use serde_json::json;

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Render;
use crate::compile::{Replaced, compile};
use crate::describe::{printable, printable_coloured};
use crate::error::{Error, Result};
use crate::examine;
use crate::progress::Progress;
use crate::sandbox::{Limits, Sandbox};
use crate::{pictures, table};

pub fn run(checkout: &Checkout, arguments: &Render) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, arguments.submission.as_ref().unwrap_or(&here))?;
    let (mut scene, golden) = super::scene(&arguments.scene, &assignment, checkout)?;
    scene.resolution = arguments.resolution.unwrap_or(scene.resolution);
    let submission = super::submission(
        arguments.submission.as_ref(),
        &assignment,
        assignment.own_answers(),
    )?;
    let sandbox = Sandbox::around(&submission.folder, checkout, arguments.run.walls(), &[])?;

    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, &assignment, checkout, &sandbox)?;
    for (task, why) in &program.replaced {
        if let Replaced::DoesNotCompile(diagnostics) = why {
            progress.clear();
            anstream::eprintln!("{}", printable_coloured(diagnostics.trim_end()));
            return Err(Error::input(
                format!("{task}.rs does not compile"),
                "mend it and try again",
            ));
        }
    }
    let (resolution, depth_per_t) = (scene.resolution, scene.camera.depth_per_t());
    let pixels = resolution.pixels() as f64;
    let wall = Duration::from_secs(arguments.run.timeout);
    let start = Instant::now();
    let reply = examine::run(
        &program,
        &sandbox,
        &Limits::of_answers(wall),
        &Job::Film(scene),
        &mut |done| {
            progress.show("casting", done as f64 / pixels);
        },
    )?;
    let seconds = start.elapsed().as_secs_f64();
    progress.clear();

    let film = reply.film(resolution);
    let cannot = |error: std::io::Error| {
        let problem = format!("cannot write to {}: {error}", arguments.out.display());
        Error::input(problem, "name a folder you may write to with --out")
    };
    fs::create_dir_all(&arguments.out).map_err(cannot)?;
    let path = arguments.out.join("film.exr");
    film.write(&path)?;
    let range = match &golden {
        Some(golden) => false_colour::depth_range(&Film::read(golden)?, depth_per_t),
        None => false_colour::depth_range(&film, depth_per_t),
    };
    let mut written = vec![path.display().to_string()];
    written.extend(pictures::write(
        &arguments.out,
        "",
        &film,
        depth_per_t,
        range.clone(),
    )?);

    let hits = film
        .channel("id")
        .unwrap_or_default()
        .iter()
        .filter(|id| **id >= 0.0)
        .count();
    let problem = examine::failure(&reply.ending, &assignment, None);
    let problem = problem.as_ref().map(table::outcome);
    if arguments.json {
        anstream::println!(
            "{:#}",
            json!({
                "scene": arguments.scene,
                "submission": submission.folder.display().to_string(),
                "resolution": [resolution.n_x, resolution.n_y],
                "hits": hits,
                "depth_range": [range.start, range.end],
                "seconds": seconds,
                "files": written,
                "problem": problem,
            })
        );
    } else {
        anstream::println!(
            "{resolution} pixels in {seconds:.2} s, {hits} of them hit something, by {}",
            printable(&submission.folder.display().to_string())
        );
        if hits == 0 && problem.is_none() {
            anstream::println!(
                "every ray missed; see one of them: cargo run --release -- explain {} {} {}",
                arguments.scene,
                resolution.n_x / 2,
                resolution.n_y / 2
            );
        }
        let (near, far) = (number(range.start, 4), number(range.end, 4));
        anstream::println!("depth.png spans {near} (bright) to {far} (dark) scene units");
        for file in &written {
            anstream::println!("wrote {file}");
        }
        if !reply.printed.is_empty() {
            anstream::eprintln!("your code printed:");
            for line in reply.printed.lines() {
                anstream::eprintln!("  {}", printable(line));
            }
        }
        if let Some(problem) = &problem {
            anstream::println!("the film is not complete: {problem}");
        }
    }
    Ok(if problem.is_none() {
        Outcome::Well
    } else {
        Outcome::JudgedWrong
    })
}
