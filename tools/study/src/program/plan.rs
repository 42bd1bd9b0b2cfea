//! `pinhole plan`: explains how to cast a scene, and why.

use std::path::PathBuf;

use pinhole::{Resolution, Scene};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_report::program::Status;
use pinhole_study::plan::casting::PlannedCaster;
use pinhole_study::plan::plan;
use pinhole_study::scenes;
use pinhole_study::summary::description;
use serde_json::json;

use crate::cli::Plan;

pub fn run(checkout: &Checkout, arguments: &Plan) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let (scene, file, _) = scene(&arguments.scene, arguments.resolution, &assignment)?;
    let wish = arguments.wanted.wish(arguments.accuracy);
    let plan = plan(&PlannedCaster::new(&scene, wish).map_err(unplannable)?);
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
pub fn scene(
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
pub fn unplannable(problem: String) -> Error {
    Error::input(problem, "use smaller numbers for the camera")
}
