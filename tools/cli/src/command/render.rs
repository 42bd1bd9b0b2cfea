//! `pinhole render`: casts a film and draws its pictures. The golden film fills in for missing
//! answers.

use std::path::Path;
use std::time::Instant;

use pinhole::ask::{Ending, Reply};
use pinhole::job::Job;
use pinhole::preview::{Preview, TaskKind};
use pinhole::{Film, Resolution, Scene};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::CompiledSubmission;
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::goldens::tests_beside;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Limits;
use pinhole_report::cast::{Cast, Shares};
use pinhole_report::program::Status;
use pinhole_report::terminal;

use crate::cli::Render;

pub fn run(checkout: &Checkout, arguments: &Render) -> Result<Status> {
    let named = arguments.submission.as_deref();
    let assignment = arguments.assignment.find(checkout, named)?;
    let (mut scene, golden) = assignment.find_scene(&arguments.scene)?;
    scene.resolution = arguments.resolution.unwrap_or(scene.resolution);
    let (resolution, depth_per_t) = (scene.resolution, scene.camera.depth_per_t());
    let whole = CompiledSubmission::build(checkout, &assignment, named, &arguments.run)?;
    let progress = Progress::new();
    let pixels = resolution.pixels() as f64;
    let limits = Limits::of_own_answers(arguments.run.wall());
    let mut ask = |job: &Job| {
        examine::run(&whole.program, &whole.sandbox, &limits, job, &mut |done| {
            progress.show("casting", done as f64 / pixels);
        })
    };
    let start = Instant::now();
    let job = Job::Film(scene);
    let reply = ask(&job)?;
    let preview = match (&reply.ending, &golden, &job) {
        (Ending::Panicked(panic), Some(golden), Job::Film(scene)) if panic.is_unanswered() => {
            preview(scene, golden, &mut ask)?
        }
        _ => None,
    };
    let seconds = start.elapsed().as_secs_f64();
    progress.clear();
    let problem = examine::failure(&reply, &whole.program, None);
    let (film, shares) = match preview {
        Some(preview) => (preview.film.clone(), Some(shares(preview, &assignment))),
        None => (reply.film(resolution), None),
    };
    let tests = reply.own_tests(resolution);
    let cast = Cast {
        tests,
        expected_tests: expected_tests(golden.as_deref(), resolution)?,
        scene: arguments.scene.clone(),
        film,
        by: whole.submission.folder.display().to_string(),
        seconds,
        problem: problem.as_ref().map(terminal::outcome),
        printed: reply.printed,
        exact: None,
        planned: None,
        shares,
    };
    cast.deliver(&arguments.out, golden, depth_per_t, arguments.json)
}

/// How many tests our answers take for each pixel, if that is known for this size.
fn expected_tests(golden: Option<&Path>, resolution: Resolution) -> Result<Option<Film>> {
    let path = golden.map(tests_beside).filter(|path| path.is_file());
    let film = path.map(|path| Film::read(&path)).transpose()?;
    Ok(film.filter(|film| film.resolution() == resolution))
}

/// As much of the scene as can be cast. `None` if its golden films are missing or have another
/// size.
fn preview(
    scene: &Scene,
    golden: &Path,
    ask: &mut dyn FnMut(&Job) -> Result<Reply>,
) -> Result<Option<Preview>> {
    let rays = golden.with_extension("rays.exr");
    if !rays.is_file() {
        return Ok(None);
    }
    let (golden, rays) = (Film::read(golden)?, Film::read(&rays)?);
    if [&golden, &rays].map(Film::resolution) != [scene.resolution; 2] {
        return Ok(None);
    }
    let mut ask = |job: &Job| {
        let reply = ask(job)?;
        Ok((reply.ending == Ending::Complete).then_some(reply))
    };
    Preview::new(scene, &golden, &rays, &mut ask).map(Some)
}

fn shares(preview: Preview, assignment: &Assignment) -> Shares {
    let names = |asked: Vec<TaskKind>| {
        let tasks = asked.into_iter();
        let tasks = tasks.filter_map(|(kind, shape)| assignment.task_of_kind(kind, shape));
        tasks.map(|task| task.name.clone()).collect()
    };
    Shares {
        yours: names(preview.answered),
        golden: names(preview.missing),
        copied: preview.copied,
    }
}
