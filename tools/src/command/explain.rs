//! `pinhole explain`: one pixel in words.

use std::path::PathBuf;
use std::time::Duration;

use pinhole::ask::Reply;
use pinhole::film::HIT_CHANNELS;
use pinhole::job::{Answer, CameraQuestion, Job, ShapeQuestion};
use pinhole::report::number;
use pinhole::{Camera, Film, Hit, Pixel, Projection, Ray, Resolution, Scene};
use serde_json::{Value, json};

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Explain;
use crate::compile::{Program, Replaced, compile};
use crate::describe::{self, hit_in_film, intersection, ray, ray_in_film};
use crate::error::{Error, Result};
use crate::examine;
use crate::progress::Progress;
use crate::sandbox::Sandbox;
use crate::table;

/// Enough digits to follow a computation by hand.
const DIGITS: usize = 6;

/// More candidates than this are a list nobody reads: those that miss are left out.
const MOST_MISSES: usize = 12;

pub fn run(checkout: &Checkout, arguments: &Explain) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, arguments.submission.as_ref().unwrap_or(&here))?;
    let (scene, golden) = super::scene(&arguments.scene, &assignment, checkout)?;
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
    let submission = super::submission(
        arguments.submission.as_ref(),
        &assignment,
        assignment.reference(),
    )?;
    let sandbox = Sandbox::around(&submission.folder, checkout, arguments.run.trust)?;
    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, &assignment, checkout, &sandbox)?;
    let witness = Witness {
        program: &program,
        sandbox: &sandbox,
        assignment: &assignment,
        wall: Duration::from_secs(arguments.run.timeout),
    };
    let explanation = witness.explain(
        &scene,
        pixel,
        Mitsuba::read(golden, scene.resolution.index(pixel))?,
    )?;
    progress.clear();
    if arguments.json {
        anstream::println!("{:#}", as_json(&explanation, &scene, pixel, arguments));
    } else {
        print(&explanation, &scene, pixel, arguments);
    }
    Ok(Outcome::Well)
}

/// What Mitsuba found at a pixel, where a golden is committed.
struct Mitsuba {
    ray: Ray,
    hit: Option<Hit>,
}

impl Mitsuba {
    fn read(golden: Option<PathBuf>, index: usize) -> Result<Option<Mitsuba>> {
        let Some(path) = golden else { return Ok(None) };
        let hits = Film::read(&path)?;
        let rays = Film::read(&path.with_extension("rays.exr"))?;
        debug_assert!(HIT_CHANNELS.iter().all(|name| hits.channel(name).is_some()));
        Ok(Some(Mitsuba {
            ray: ray_in_film(&rays, index),
            hit: hit_in_film(&hits, index),
        }))
    }
}

/// What an answer said, or why it said nothing.
type Said<T> = std::result::Result<T, String>;

struct Explanation {
    ray: Said<Ray>,
    /// The ray the rest was asked about: the submission's, or else Mitsuba's.
    asked: Option<Ray>,
    candidates: Vec<Said<Option<Hit>>>,
    first_hit: Said<Option<Hit>>,
    mitsuba: Option<Mitsuba>,
}

struct Witness<'a> {
    program: &'a Program,
    sandbox: &'a Sandbox,
    assignment: &'a Assignment,
    wall: Duration,
}

impl Witness<'_> {
    fn explain(
        &self,
        scene: &Scene,
        pixel: Pixel,
        mitsuba: Option<Mitsuba>,
    ) -> Result<Explanation> {
        let Scene {
            camera,
            resolution,
            min_t,
            ref objects,
        } = *scene;
        let question = CameraQuestion {
            camera,
            pixel,
            resolution,
        };
        let ray = self.ask(
            "viewing_ray",
            &Job::ViewingRay(vec![question]),
            |answer| match answer {
                Answer::Ray(ray) => Some(ray),
                Answer::Hit(_) => None,
            },
        )?;
        let asked = ray
            .as_ref()
            .ok()
            .copied()
            .or(mitsuba.as_ref().map(|mitsuba| mitsuba.ray));
        let mut candidates = Vec::new();
        let mut first_hit = Err("there is no ray to ask about".into());
        if let Some(ray) = asked {
            let hit = |answer| match answer {
                Answer::Hit(hit) => Some(hit),
                Answer::Ray(_) => None,
            };
            for shape in objects {
                let question = ShapeQuestion {
                    shape: shape.clone(),
                    ray,
                    min_t,
                };
                let task = describe::kind(shape);
                candidates.push(self.ask(task, &Job::Intersect(vec![question]), hit)?);
            }
            first_hit = self.ask("first_hit", &Job::Cast(ray, min_t, objects.clone()), hit)?;
        }
        Ok(Explanation {
            ray,
            asked,
            candidates,
            first_hit,
            mitsuba,
        })
    }

    /// One question to one answer, which may fail without hiding the others.
    fn ask<T>(&self, task: &str, job: &Job, pick: impl Fn(Answer) -> Option<T>) -> Result<Said<T>> {
        if let Some(replaced) = self.program.replaced.get(task) {
            return Ok(Err(match replaced {
                Replaced::Unusable(_) => format!("there is no usable {task}.rs"),
                Replaced::DoesNotCompile(_) => format!("{task}.rs does not compile"),
            }));
        }
        let reply: Reply = examine::run(self.program, self.sandbox, self.wall, job, &mut |_| {})?;
        let answer = reply.answers.first().copied().flatten().and_then(pick);
        Ok(answer.ok_or_else(|| {
            let failure = examine::failure(&reply.ending, self.assignment, Some(task));
            failure.map_or("it gave no answer".into(), |failure| {
                table::outcome(&failure)
            })
        }))
    }
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

fn print(explanation: &Explanation, scene: &Scene, pixel: Pixel, arguments: &Explain) {
    let camera = &scene.camera;
    let (u, v) = on_image_plane(camera, pixel, scene.resolution);
    let show = |value| number(value, DIGITS);
    let Pixel { i, j } = pixel;
    anstream::println!(
        "pixel {pixel} of {}, scene {}\n",
        scene.resolution,
        arguments.scene
    );
    anstream::println!(
        "on the image plane     u({i}) = {}, v({j}) = {}",
        show(u),
        show(v)
    );
    let (u, v) = (show(u), show(v));
    match camera.projection {
        Projection::Perspective { focal_length } => {
            anstream::println!(
                "ray in camera space    t ({u}, {v}, {})",
                show(-focal_length)
            );
        }
        Projection::Orthographic => {
            anstream::println!("ray in camera space    ({u}, {v}, 0) + t (0, 0, −1)");
        }
    }
    match &explanation.ray {
        Ok(own) => anstream::println!("ray in world space     {}", ray(own, DIGITS)),
        Err(why) => anstream::println!("ray in world space     viewing_ray: {why}"),
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
        anstream::println!("  object {k:<3} {}", describe::shape(shape, DIGITS));
        anstream::println!("             {}", said_hit(said, false));
    }
    if misses > MOST_MISSES {
        anstream::println!("  and {misses} objects that the ray misses");
    }
    anstream::println!(
        "\nfirst hit              {}",
        said_hit(&explanation.first_hit, true)
    );
    match &explanation.mitsuba {
        Some(mitsuba) => {
            let hit = mitsuba.hit.map(|hit| (hit.object, hit.intersection));
            anstream::println!("  expected (Mitsuba)   {}", intersection(hit, true, DIGITS));
        }
        None => anstream::println!("  expected             unknown: this scene has no golden"),
    }
}

fn said_hit(said: &Said<Option<Hit>>, with_object: bool) -> String {
    match said {
        Ok(hit) => intersection(
            hit.map(|hit| (hit.object, hit.intersection)),
            with_object,
            DIGITS,
        ),
        Err(why) => why.clone(),
    }
}

fn as_json(explanation: &Explanation, scene: &Scene, pixel: Pixel, arguments: &Explain) -> Value {
    fn value<T: serde::Serialize>(said: &Said<T>) -> Value {
        match said {
            Ok(said) => json!(said),
            Err(why) => json!({ "problem": why }),
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
        "pixel": [pixel.i, pixel.j],
        "min_t": scene.min_t,
        "u": u,
        "v": v,
        "camera_space": { "origin": origin, "direction": direction },
        "world_space": value(&explanation.ray),
        "candidates": explanation.candidates.iter().map(value).collect::<Vec<_>>(),
        "first_hit": value(&explanation.first_hit),
        "expected": explanation.mitsuba.as_ref().map(|mitsuba| json!({
            "ray": mitsuba.ray,
            "first_hit": mitsuba.hit,
        })),
    })
}
