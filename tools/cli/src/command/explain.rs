//! `pinhole explain`: one pixel in words.

use pinhole::words::{self, number, ray};
use pinhole::{Camera, Hit, Kind, Pixel, Projection, Resolution, Scene};
use serde_json::{Value, json};

use crate::cli::Explain;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::compile;
use pinhole_course::error::{Error, Result};
use pinhole_course::explanation::{Explanation, Mitsuba, Said, Witness};
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::submission::Submission;
use pinhole_report::escape;
use pinhole_report::passage::Passage;
use pinhole_report::program::Status;
use pinhole_report::terminal;

/// Enough digits to follow a computation by hand.
const DIGITS: usize = 6;

/// Nobody reads a longer list of candidates, so the ones that miss are left out of it.
const MOST_MISSES: usize = 12;

pub fn run(checkout: &Checkout, arguments: &Explain) -> Result<Status> {
    let named = arguments.submission.as_deref();
    let assignment = arguments.assignment.find(checkout, named)?;
    let (scene, golden) = assignment.find_scene(&arguments.scene)?;
    let pixel = Pixel {
        i: arguments.i,
        j: arguments.j,
    };
    let Resolution { n_x, n_y } = scene.resolution;
    if pixel.i >= n_x || pixel.j >= n_y {
        return Err(Error::input(
            format!("there is no pixel {pixel} in a film of {n_x}×{n_y} pixels"),
            format!(
                "use a column from 0 to {} and a row from 0 to {}",
                n_x - 1,
                n_y - 1
            ),
        ));
    }
    let submission = Submission::named_or(named, &assignment, &assignment.own_answers())?;
    let choice = arguments.run.sandbox.choice();
    let sandbox = Sandbox::around(&submission.folder, checkout, choice, &[])?;
    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, &assignment, checkout, &sandbox)?;
    let witness = Witness {
        program: &program,
        sandbox: &sandbox,
        assignment: &assignment,
        wall: arguments.run.wall(),
    };
    let explanation = witness.explain(
        &scene,
        pixel,
        Mitsuba::read(golden, scene.resolution.index(pixel))?,
    )?;
    progress.clear();
    let whose = submission.folder.display().to_string();
    if arguments.json {
        anstream::println!(
            "{:#}",
            as_json(&explanation, &scene, pixel, arguments, &whose)
        );
    } else {
        print(&explanation, &scene, pixel, arguments, &whose);
        if let Some(task) = explanation.task_at_fault(&scene.objects, &assignment) {
            let passage = Passage::chapter(&task.chapter);
            anstream::println!("\nread: {passage}");
            if arguments.read {
                anstream::println!("{}", escape::printable(&passage.open(checkout.root())));
            }
        }
    }
    Ok(Status::Well)
}

/// u(i) and v(j): a pixel centre's place on the image plane, scene units, from its
/// middle (the lecture's pixel convention).
fn on_image_plane(camera: &Camera, pixel: Pixel, resolution: Resolution) -> (f64, f64) {
    let along = |size: f64, n: usize, k: usize| size / n as f64 * (k as f64 + 0.5) - size / 2.0;
    (
        along(camera.width, resolution.n_x, pixel.i),
        along(camera.height, resolution.n_y, pixel.j),
    )
}

fn print(explanation: &Explanation, scene: &Scene, pixel: Pixel, arguments: &Explain, whose: &str) {
    let camera = &scene.camera;
    let (u, v) = on_image_plane(camera, pixel, scene.resolution);
    let show = |value| number(value, DIGITS);
    let Pixel { i, j } = pixel;
    anstream::println!(
        "pixel {pixel} of {}, scene {}, answers of {}
",
        scene.resolution,
        arguments.scene,
        escape::printable(whose)
    );
    anstream::println!(
        "on the image plane     u({i}) = {}, v({j}) = {}",
        show(u),
        show(v)
    );
    let (u, v) = (show(u), show(v));
    let in_camera_space = match camera.projection {
        Projection::Perspective { focal_length } => {
            format!("t ({u}, {v}, {})", show(-focal_length))
        }
        Projection::Orthographic => format!("({u}, {v}, 0) + t (0, 0, −1)"),
    };
    anstream::println!("ray in camera space    {in_camera_space}");
    match &explanation.ray {
        Ok(own) => anstream::println!("ray in world space     {}", ray(own, DIGITS)),
        Err(why) => {
            let why = terminal::no_answer(why);
            anstream::println!("ray in world space     {}: {why}", Kind::ViewingRay);
        }
    }
    if let Some(mitsuba) = &explanation.mitsuba {
        anstream::println!("  Mitsuba's            {}", ray(&mitsuba.ray, DIGITS));
    }
    if explanation.ray.is_err() && explanation.asked.is_some() {
        anstream::println!("  (below, Mitsuba's ray is used)");
    }

    anstream::println!("\ncandidates, t ≥ {}", show(scene.min_t));
    let missed = |said: &Said<Option<Hit>>| matches!(said, Ok(None));
    let misses = explanation
        .candidates
        .iter()
        .filter(|said| missed(said))
        .count();
    for (k, (said, shape)) in explanation
        .candidates
        .iter()
        .zip(&scene.objects)
        .enumerate()
    {
        if misses > MOST_MISSES && missed(said) {
            continue;
        }
        anstream::println!("  object {k:<3} {}", shape.describe(DIGITS));
        anstream::println!("             {}", in_words(said, words::intersection));
    }
    if misses > MOST_MISSES {
        anstream::println!("  and {misses} objects that the ray misses");
    }
    anstream::println!(
        "\nfirst hit              {}",
        in_words(&explanation.nearest, words::hit)
    );
    match &explanation.mitsuba {
        Some(mitsuba) => {
            let hit = words::hit(mitsuba.hit, DIGITS);
            anstream::println!("  expected (Mitsuba)   {hit}");
        }
        None => anstream::println!("  expected             unknown: this scene has no golden"),
    }
}

fn in_words(said: &Said<Option<Hit>>, words: fn(Option<Hit>, usize) -> String) -> String {
    match said {
        Ok(hit) => words(*hit, DIGITS),
        Err(why) => terminal::no_answer(why),
    }
}

fn as_json(
    explanation: &Explanation,
    scene: &Scene,
    pixel: Pixel,
    arguments: &Explain,
    whose: &str,
) -> Value {
    fn value<T: serde::Serialize>(said: &Said<T>) -> Value {
        match said {
            Ok(said) => json!(said),
            Err(why) => json!({ "problem": terminal::no_answer(why) }),
        }
    }
    let (u, v) = on_image_plane(&scene.camera, pixel, scene.resolution);
    let direction = match scene.camera.projection {
        Projection::Perspective { focal_length } => [u, v, -focal_length],
        Projection::Orthographic => [0.0, 0.0, -1.0],
    };
    let origin = match scene.camera.projection {
        Projection::Perspective { .. } => [0.0; 3],
        Projection::Orthographic => [u, v, 0.0],
    };
    json!({
        "scene": arguments.scene,
        "submission": whose,
        "pixel": [pixel.i, pixel.j],
        "min_t": scene.min_t,
        "u": u,
        "v": v,
        "camera_space": { "origin": origin, "direction": direction },
        "world_space": value(&explanation.ray),
        "candidates": explanation.candidates.iter().map(value).collect::<Vec<_>>(),
        (Kind::FirstHit.name()): value(&explanation.nearest),
        "expected": explanation.mitsuba.as_ref().map(|mitsuba| json!({
            "ray": mitsuba.ray,
            (Kind::FirstHit.name()): mitsuba.hit,
        })),
    })
}
