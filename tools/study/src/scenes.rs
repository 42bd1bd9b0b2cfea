//! Casts whole scenes on their own rays: in plain `f64`, by brute force and with boxes, and
//! exactly. Judges every pixel, and times all ways in turn.

use std::hint::black_box;
use std::path::Path;

use pinhole::{Film, Hit, Scene, Shape};

use crate::cast::model::Plain;
use crate::cast::world::World;
use crate::cast::{Caster, Tally};
use crate::extent::Extent;
use crate::oracle::scene::errors;
use crate::plan::casting::PlannedCaster;
use crate::plan::{EXACT_OBJECTS, search_name};
use crate::random_scene::grid;
use crate::result::SceneTally;
use crate::shape::Ray;
use crate::speed::{self, Workload, race};

/// A scene ready to be cast.
pub struct Stage {
    /// The scene's name.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// Plain `f64`, without and with boxes.
    plain: [Caster; 2],
    /// The exact caster, with the rays that all ways cast.
    pub exact: PlannedCaster,
}

/// The ways to cast a scene: the name in tables, and for plain `f64` whether it has boxes. Exact
/// casting chooses the cheaper search.
const WAYS: [(&str, Option<bool>); 3] =
    [("f64", Some(false)), ("f64", Some(true)), ("exact", None)];

impl Stage {
    /// Prepares a scene, of which every `step`-th ray is cast.
    pub fn new(name: &str, step: usize) -> Stage {
        let scene = named(name);
        let exact = PlannedCaster::new(&scene, EXACT_OBJECTS).expect("its rays are finite");
        let plain = |has_boxes| Caster::new(World::of(&scene.objects), None, has_boxes);
        Stage {
            name: name.into(),
            plain: [false, true].map(plain),
            exact: exact.every(step),
            scene,
        }
    }

    /// Casts one ray in plain `f64`, with or without boxes, or exactly.
    #[inline(always)]
    fn see(&self, plain: Option<bool>, ray: &Ray<f64>, tally: &mut Tally) -> Option<Hit> {
        let Some(has_boxes) = plain else {
            return self.exact.see(ray, tally);
        };
        let caster = &self.plain[usize::from(has_boxes)];
        let found = caster.first::<Plain>(ray, self.scene.min_t, tally)?;
        Some(
            found
                .part
                .hit(found.t, found.part.shape.normal(ray, found.t)),
        )
    }

    /// Casts all rays in one way, for timing. It does not read a clock, because rustix's clock does
    /// not work under valgrind.
    pub fn cast(&self, plain: Option<bool>) {
        for ray in black_box(self.exact.rays()) {
            black_box(self.see(plain, ray, &mut Tally::default()));
        }
    }
}

/// Prefix of a scene's name among the workloads that run under valgrind.
const SCENE: &str = "scene:";

/// Casts the named scene `films` times in one way. Returns false if this is not the name of a scene.
pub fn cast(name: &str, way: usize, films: u32) -> bool {
    let Some(name) = name.strip_prefix(SCENE) else {
        return false;
    };
    let stage = Stage::new(name, 1);
    (0..films).for_each(|_| stage.cast(WAYS[way].1));
    true
}

/// Before the number in a grid's name.
const GRID: &str = "grid ";

/// The names of the scenes of small integers.
pub fn grids() -> impl Iterator<Item = String> {
    (1..=12).map(|seed| format!("{GRID}{seed}"))
}

/// The folder of the assignment's scenes.
const FOLDER: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../assignments/ray_casting/scenes"
);

/// The names of the assignment's scenes, in order.
pub fn names() -> Vec<String> {
    let entries = std::fs::read_dir(FOLDER).into_iter().flatten().flatten();
    let files = entries.map(|entry| entry.file_name().display().to_string());
    let mut names: Vec<String> = files
        .filter_map(|file| Some(file.strip_suffix(".toml")?.into()))
        .collect();
    names.sort();
    names
}

/// A scene of the assignment, or one of the [`grids`].
///
/// # Panics
/// If no scene has this name.
pub fn named(name: &str) -> Scene {
    match name.strip_prefix(GRID) {
        Some(seed) => grid(seed.parse().expect("a grid has a number")),
        None => read(&Path::new(FOLDER).join(format!("{name}.toml"))).expect("it is committed"),
    }
}

/// A scene, if there are kernels for all its shapes.
///
/// # Errors
/// If it cannot be read, or has a shape that the study does not support.
pub fn read(file: &Path) -> Result<Scene, pinhole::Error> {
    let scene = Scene::read(file)?;
    for (k, shape) in scene.objects.iter().enumerate() {
        use Shape::{Plane, Soup, Sphere, Triangle};
        if !matches!(shape, Sphere(_) | Plane(_) | Triangle(_) | Soup(_)) {
            let odd = format!("object {k} is a {}", shape.kind());
            let problem = format!("shape not supported: {odd}, and the study has no kernel for it");
            let remedy = "leave it out, or name another scene";
            return Err(pinhole::Error::new(file, problem, remedy));
        }
    }
    Ok(scene)
}

/// Mitsuba's film of a scene of the assignment.
fn golden(name: &str) -> Option<Film> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../golden/ray_casting");
    Film::read(&folder.join(format!("{name}.exr"))).ok()
}

/// Judges every way to cast a scene, and Mitsuba's film of it if there is one.
pub fn studied(stage: &Stage, extent: &Extent) -> Vec<SceneTally> {
    let (name, rays, truths) = (&stage.name, stage.exact.rays(), stage.exact.truths());
    let judged = |hits| errors(rays, &truths, hits, f64::INFINITY);
    let films = WAYS.map(|(_, plain)| Box::new(move || stage.cast(plain)) as Workload);
    let times = race(films.into(), rays.len(), extent.seconds);
    let cheaper = stage.exact.has_boxes;
    let mut tallies = Vec::new();
    for (at, ((model, plain), time)) in WAYS.into_iter().zip(times).enumerate() {
        let mut tally = Tally::default();
        let hits = rays.iter().map(|ray| stage.see(plain, ray, &mut tally));
        let errors = judged(hits.collect());
        let has_boxes = plain.unwrap_or(cheaper);
        let is_counted = extent.instructions && has_boxes == cheaper;
        let count = || speed::instructions(&format!("{SCENE}{name}"), at, rays.len());
        tallies.push(SceneTally {
            scene: name.clone(),
            model,
            search: Some(search_name(has_boxes)),
            nanoseconds: Some(time.nanoseconds),
            instructions: is_counted.then(count).flatten(),
            tests: Some(tally.tests as f64 / rays.len() as f64),
            errors,
            tally,
        });
    }
    if let Some(film) = golden(name) {
        let pixels = (0..film.resolution().pixels()).step_by(extent.step);
        let hits = pixels.map(|at| film.hit(at)).collect();
        tallies.push(SceneTally {
            scene: name.clone(),
            model: "Mitsuba",
            errors: judged(hits),
            ..SceneTally::default()
        });
    }
    tallies
}
