//! `pinhole plan` explains how to cast a scene, and why. `pinhole render --exact` and `--plan` cast
//! its film.

use std::path::PathBuf;
use std::time::Instant;

use pinhole::{Resolution, Scene};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::shell::PINHOLE;
use pinhole_report::cast::Cast;
use pinhole_report::program::Status;
use pinhole_study::plan::casting::{PlannedCaster, film};
use pinhole_study::plan::{EXACT_FILM, plan};
use pinhole_study::scenes;
use pinhole_study::summary::description;
use serde_json::json;

use crate::cli::{Plan, Render};

pub fn explain(checkout: &Checkout, arguments: &Plan) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let (scene, file, _) = scene(&arguments.scene, arguments.resolution, &assignment)?;
    let casting = PlannedCaster::new(&scene, arguments.accuracy).map_err(unplannable)?;
    let plan = plan(&casting);
    match arguments.json {
        true => anstream::println!("{:#}", json!(plan)),
        false => {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            anstream::print!("{}", description(&plan, &name));
        }
    }
    Ok(Status::Well)
}

/// Finds a scene by name or file. Returns the scene, at another resolution if one is given, its
/// file, and its golden if one is committed.
fn scene(
    named: &str,
    resolution: Option<Resolution>,
    assignment: &Assignment,
) -> Result<(Scene, PathBuf, Option<PathBuf>)> {
    let (_, golden) = assignment.find_scene(named)?;
    let file = assignment.find_scene_file(named)?;
    let mut scene = scenes::read(&file)?;
    scene.resolution = resolution.unwrap_or(scene.resolution);
    Ok((scene, file, golden))
}

/// Turns the study's message into an error.
fn unplannable(problem: String) -> Error {
    Error::input(problem, "use smaller numbers for the camera")
}

pub fn render(checkout: &Checkout, arguments: &Render) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let (scene, _, golden) = scene(&arguments.scene, arguments.resolution, &assignment)?;
    let start = Instant::now();
    let casting =
        PlannedCaster::new(&scene, arguments.plan.unwrap_or(EXACT_FILM)).map_err(unplannable)?;
    let plan = plan(&casting);
    let planning_seconds = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let (hits, tally) = casting.hits();
    let seconds = start.elapsed().as_secs_f64();
    let report = json!({
        // Wall times of casting, and of planning, which includes building the tree.
        "seconds": seconds,
        "planning_seconds": planning_seconds,
        // Tests of a ray against a part, and those that no filter could decide.
        "tests": tally.tests,
        "fallbacks": tally.exact,
        // Comparisons of two t that were decided exactly.
        "close_calls": tally.close_calls,
        // Pixels whose t and normal had to be computed exactly.
        "exact_hits": tally.exact_hits,
        "plan": plan,
    });
    let spent = format!(
        "{} of {} tests, {} comparisons, and t and normals of {} pixels needed exact arithmetic",
        tally.exact, tally.tests, tally.close_calls, tally.exact_hits
    );
    let (by, exact, planned) = match arguments.plan {
        None => (format!("the exact caster: {spent}"), Some(report), None),
        Some(accuracy) => {
            let why = format!(
                "why: {PINHOLE} plan {} --accuracy {accuracy:e}",
                arguments.scene
            );
            let by = format!("the plan for {accuracy:e}: {spent}; {why}");
            (by, None, Some(report))
        }
    };
    let cast = Cast {
        tests: None,
        expected_tests: None,
        scene: arguments.scene.clone(),
        film: film(scene.resolution, hits),
        by,
        seconds,
        problem: None,
        printed: String::new(),
        exact,
        planned,
        shares: None,
    };
    let depth_per_t = scene.camera.depth_per_t();
    cast.deliver(&arguments.out, golden, depth_per_t, arguments.json)
}
