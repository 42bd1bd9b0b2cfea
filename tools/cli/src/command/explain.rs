//! `pinhole explain`: explains one pixel in words.

use pinhole::kind::CameraQuestion;
use pinhole::words::{self, number, ray};
use pinhole::{Camera, Hit, Kind, Pixel, Projection, Ray, Resolution, Scene};
use serde_json::{Value, json};

use super::read;
use crate::cli::Explain;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::compile;
use pinhole_course::error::{Error, Result};
use pinhole_course::explanation::{AnswerResult, Mitsuba, PixelAsker, PixelExplanation};
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::shell::from_here;
use pinhole_course::submission::Submission;
use pinhole_report::escape;
use pinhole_report::passage::Passage;
use pinhole_report::program::Status;
use pinhole_report::terminal::{self, FAIL, QUIET};

/// Enough digits to follow a computation by hand.
const DIGITS: usize = 6;

/// If a list is longer than this, leave out the objects that the ray misses.
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
    let submission = Submission::named_or(named, &assignment)?;
    let choice = arguments.run.sandbox.choice();
    let sandbox = Sandbox::around(&submission.read_from, checkout, choice, &[])?;
    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, &assignment, checkout, &sandbox)?;
    let witness = PixelAsker {
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
        let whose = from_here(&submission.folder).display().to_string();
        print(&explanation, &scene, pixel, arguments, &whose);
        if let Some(task) = explanation.task_at_fault(&scene.objects, &assignment) {
            let passage = Passage::chapter(&task.chapter);
            anstream::println!("\nread: {passage}");
            if arguments.read {
                read::open(&passage, checkout);
            }
        }
    }
    Ok(Status::Well)
}

/// What the lecture's formulas give for a pixel, in camera space: the ray, and its point on the
/// image plane.
struct Expected {
    u: f64,
    v: f64,
    ray: Ray,
}

impl Expected {
    fn of(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Expected {
        let along = |size: f64, n: usize, k: usize| size / n as f64 * (k as f64 + 0.5) - size / 2.0;
        let u = along(camera.width, resolution.n_x, pixel.i);
        let v = along(camera.height, resolution.n_y, pixel.j);
        let (origin, direction) = match camera.projection {
            Projection::Perspective { focal_length } => ([0.0; 3], [u, v, -focal_length]),
            Projection::Orthographic => ([u, v, 0.0], [0.0, 0.0, -1.0]),
        };
        let ray = Ray {
            origin: origin.into(),
            direction: direction.into(),
        };
        Expected { u, v, ray }
    }
}

fn print(
    explanation: &PixelExplanation,
    scene: &Scene,
    pixel: Pixel,
    arguments: &Explain,
    whose: &str,
) {
    anstream::println!(
        "pixel {pixel} of {}, scene {}, answers of {}\n",
        scene.resolution,
        arguments.scene,
        escape::printable(whose)
    );
    print_rays(explanation, scene, pixel);
    print_candidates(explanation, scene);
    anstream::println!("\nfirst hit");
    let nearest = in_words(&explanation.nearest, words::hit);
    let hits = |mitsuba: &Mitsuba| words::hit(mitsuba.hit, DIGITS);
    let expected = explanation.mitsuba.as_ref().map(hits);
    let differs = explanation.nearest_differs();
    let unknown = "unknown, because this scene has no golden".to_owned();
    pair(nearest, differs, "Mitsuba's", expected.unwrap_or(unknown));
    print_output(&explanation.printed.nearest, "  ");
}

/// Prints your value above the expected one, so that the digits can be compared.
fn pair(yours: String, differs: bool, whose: &str, expected: String) {
    let mark = match differs {
        true => format!("  {FAIL}← differs{FAIL:#}"),
        false => String::new(),
    };
    anstream::println!("  {:<11}{yours}{mark}", "yours");
    anstream::println!("  {whose:<11}{expected}");
}

/// What the student's code printed for one question.
fn print_output(printed: &str, indent: &str) {
    for line in printed.lines() {
        let line = escape::printable(line);
        anstream::println!("{indent}{:<11}{QUIET}{line}{QUIET:#}", "printed");
    }
}

/// Prints the ray in each space: yours, and the expected one.
fn print_rays(explanation: &PixelExplanation, scene: &Scene, pixel: Pixel) {
    let show = |value| number(value, DIGITS);
    let camera = scene.camera;
    let question = CameraQuestion {
        camera,
        pixel,
        resolution: scene.resolution,
    };
    let Pixel { i, j } = pixel;
    let expected = Expected::of(&camera, pixel, scene.resolution);
    let own = explanation.ray.as_ref();
    let yours = |words: &dyn Fn(&Ray) -> String| match own {
        Ok(own) => words(own),
        Err(_) => "–".into(),
    };
    let differs = explanation.ray_differs();

    anstream::println!("on the image plane");
    let on_image_plane = |own: &Ray| {
        let size = camera.width.max(camera.height);
        match question
            .on_image_plane(own)
            .map(|at| without_noise(at, size))
        {
            [u, v] if u.is_finite() && v.is_finite() => format!("u = {}, v = {}", show(u), show(v)),
            _ => "your ray never meets the image plane".into(),
        }
    };
    let (u, v) = (show(expected.u), show(expected.v));
    let formula = format!("u({i}) = {u}, v({j}) = {v}");
    pair(yours(&on_image_plane), differs, "expected", formula);

    anstream::println!("ray in camera space");
    let in_camera_space = |own: &Ray| {
        let Ray { origin, direction } = question.in_camera_space(own);
        let far = own.origin.length().max(camera.eye.length());
        let clean = |vector: [f64; 3], size| vector.map(|x| without_noise(x, size)).into();
        let clean = Ray {
            origin: clean(origin.to_array(), far),
            direction: clean(direction.to_array(), direction.length()),
        };
        ray(&clean, DIGITS)
    };
    let should = ray(&expected.ray, DIGITS);
    pair(yours(&in_camera_space), differs, "expected", should);

    anstream::println!("ray in world space");
    let in_world_space = match own {
        Ok(own) => ray(own, DIGITS),
        Err(why) => format!("{}: {}", Kind::ViewingRay, terminal::no_answer(why)),
    };
    match &explanation.mitsuba {
        Some(mitsuba) => pair(
            in_world_space,
            differs,
            "Mitsuba's",
            ray(&mitsuba.ray, DIGITS),
        ),
        None => anstream::println!("  {:<11}{in_world_space}", "yours"),
    }
    print_output(&explanation.printed.ray, "  ");
    if own.is_err() && explanation.asked.is_some() {
        anstream::println!("  (below, Mitsuba's ray is used)");
    }
}

/// A coordinate this small compared with `size` is a rounding error, and shown as 0.
fn without_noise(value: f64, size: f64) -> f64 {
    match value.abs() <= 1e-12 * size {
        true => 0.0,
        false => value,
    }
}

fn print_candidates(explanation: &PixelExplanation, scene: &Scene) {
    anstream::println!(
        "\nyour intersection with each object, at min_t = {} or beyond",
        number(scene.min_t, DIGITS)
    );
    let missed = |said: &AnswerResult<Option<Hit>>| matches!(said, Ok(None));
    let candidates = &explanation.candidates;
    let misses = candidates.iter().filter(|said| missed(said)).count();
    let printed = &explanation.printed.candidates;
    for (k, ((said, printed), shape)) in candidates
        .iter()
        .zip(printed)
        .zip(&scene.objects)
        .enumerate()
    {
        if misses > MOST_MISSES && missed(said) {
            continue;
        }
        anstream::println!("  object {k:<3} {}", shape.describe(DIGITS));
        anstream::println!("             {}", in_words(said, words::intersection));
        print_output(printed, "             ");
    }
    if misses > MOST_MISSES {
        anstream::println!("  and {misses} objects that the ray misses");
    }
}

fn in_words(said: &AnswerResult<Option<Hit>>, words: fn(Option<Hit>, usize) -> String) -> String {
    match said {
        Ok(hit) => words(*hit, DIGITS),
        Err(why) => terminal::no_answer(why),
    }
}

fn as_json(
    explanation: &PixelExplanation,
    scene: &Scene,
    pixel: Pixel,
    arguments: &Explain,
    whose: &str,
) -> Value {
    fn value<T: serde::Serialize>(said: &AnswerResult<T>) -> Value {
        match said {
            Ok(said) => json!(said),
            Err(why) => json!({ "problem": terminal::no_answer(why) }),
        }
    }
    let Expected { u, v, ray } = Expected::of(&scene.camera, pixel, scene.resolution);
    json!({
        "scene": arguments.scene,
        "submission": whose,
        "pixel": [pixel.i, pixel.j],
        "min_t": scene.min_t,
        "u": u,
        "v": v,
        "camera_space": ray,
        "world_space": value(&explanation.ray),
        "candidates": explanation.candidates.iter().map(value).collect::<Vec<_>>(),
        (Kind::FirstHit.name()): value(&explanation.nearest),
        "expected": explanation.mitsuba.as_ref().map(|mitsuba| json!({
            "ray": mitsuba.ray,
            (Kind::FirstHit.name()): mitsuba.hit,
        })),
        "printed": explanation.printed,
    })
}
