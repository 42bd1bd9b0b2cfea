//! `pinhole render`: a film and its pictures.

use std::time::Instant;

use pinhole::job::Job;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Whole;
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Limits;
use pinhole_report::cast::Cast;
use pinhole_report::program::Status;
use pinhole_report::terminal;

use crate::cli::Render;

pub fn run(checkout: &Checkout, arguments: &Render) -> Result<Status> {
    let named = arguments.submission.as_deref();
    let assignment = arguments.assignment.find(checkout, named)?;
    let (mut scene, golden) = assignment.find_scene(&arguments.scene)?;
    scene.resolution = arguments.resolution.unwrap_or(scene.resolution);
    let (resolution, depth_per_t) = (scene.resolution, scene.camera.depth_per_t());
    let whole = Whole::build(checkout, &assignment, named, &arguments.run)?;
    let progress = Progress::new();
    let pixels = resolution.pixels() as f64;
    let start = Instant::now();
    let reply = examine::run(
        &whole.program,
        &whole.sandbox,
        &Limits::of_answers(arguments.run.wall()),
        &Job::Film(scene),
        &mut |done| progress.show("casting", done as f64 / pixels),
    )?;
    let seconds = start.elapsed().as_secs_f64();
    progress.clear();
    let problem = examine::failure(&reply.ending, &assignment, None);
    let cast = Cast {
        scene: arguments.scene.clone(),
        film: reply.film(resolution),
        by: whole.submission.folder.display().to_string(),
        seconds,
        problem: problem.as_ref().map(terminal::outcome),
        printed: reply.printed,
        exact: None,
        planned: None,
    };
    cast.deliver(&arguments.out, golden, depth_per_t, arguments.json)
}
