//! Casts whole scenes on their own rays: in plain `f64`, by brute force and with boxes, and
//! exactly. Judges every pixel, and times all ways in turn.

use std::hint::black_box;
use std::path::{Path, PathBuf};

use pinhole::{Film, Hit, Intersection, Scene, Shape};

use crate::cast::model::Plain;
use crate::cast::world::World;
use crate::cast::{Caster, Tally};
use crate::extent::Extent;
use crate::oracle::scene::{TrueHit, errors};
use crate::plan::casting::PlannedCaster;
use crate::plan::{EXACT_OBJECTS, search_name};
use crate::random_scene::grid;
use crate::result::SceneTally;
use crate::shape::Ray;
use crate::speed::{self, Time, Workload, race};

/// A scene ready to be cast.
pub struct Stage {
    /// Plain `f64`, without and with boxes.
    plain: [Caster; 2],
    /// The exact caster, with the rays that all ways cast.
    pub exact: PlannedCaster,
    min_t: f64,
}

/// The ways to cast a scene: the name in tables, and for plain `f64` whether it has boxes. Exact
/// casting chooses the cheaper search.
const WAYS: [(&str, Option<bool>); 3] =
    [("f64", Some(false)), ("f64", Some(true)), ("exact", None)];

impl Stage {
    /// Prepares a scene, of which every `step`-th ray is cast.
    ///
    /// # Panics
    /// If a ray of the camera overflows.
    pub fn new(scene: &Scene, step: usize) -> Stage {
        let exact = PlannedCaster::new(scene, EXACT_OBJECTS).expect("its rays are finite");
        Stage {
            plain: [false, true]
                .map(|has_boxes| Caster::new(World::of(&scene.objects), None, has_boxes)),
            exact: exact.every(step),
            min_t: scene.min_t,
        }
    }

    #[inline(always)]
    fn plain(&self, has_boxes: bool, ray: &Ray<f64>, tally: &mut Tally) -> Option<Hit> {
        let found = self.plain[usize::from(has_boxes)].first::<Plain>(ray, self.min_t, tally)?;
        Some(Hit {
            object: found.part.object as usize,
            intersection: Intersection {
                t: found.t,
                normal: found.part.shape.normal(ray, found.t).into(),
            },
        })
    }

    /// What each ray hits, and the work that this took.
    fn hits(&self, plain: Option<bool>) -> (Vec<Option<Hit>>, Tally) {
        let Some(has_boxes) = plain else {
            return self.exact.hits();
        };
        let mut tally = Tally::default();
        let rays = self.exact.rays().iter();
        let hits = rays
            .map(|ray| self.plain(has_boxes, ray, &mut tally))
            .collect();
        (hits, tally)
    }

    /// Casts all rays in plain `f64`, with or without boxes, or exactly, for timing. It does not
    /// read a clock, because rustix's clock does not work under valgrind.
    pub fn cast(&self, plain: Option<bool>) {
        let Some(has_boxes) = plain else {
            return self.exact.cast();
        };
        for ray in black_box(self.exact.rays()) {
            black_box(self.plain(has_boxes, ray, &mut Tally::default()));
        }
    }
}

/// Prefix of a scene's name among the workloads that run under valgrind.
const SCENE: &str = "scene:";

/// Casts the named scene `films` times in one way. Returns false if there is no such scene.
pub fn cast(named: &str, way: usize, films: u32) -> bool {
    let Some(name) = named.strip_prefix(SCENE) else {
        return false;
    };
    let file = || files().into_iter().find(|file| name_of(file) == name);
    let scene = match name.strip_prefix(GRID) {
        Some(seed) => grid(seed.parse().expect("a grid has a number")),
        None => read(&file().expect("it is a scene")).expect("the scene is committed"),
    };
    let stage = Stage::new(&scene, 1);
    (0..films).for_each(|_| stage.cast(WAYS[way].1));
    true
}

/// The name of a scene's file, without its extension.
pub fn name_of(file: &Path) -> String {
    file.file_stem().unwrap_or_default().display().to_string()
}

/// Scenes of small integers.
pub const GRIDS: std::ops::RangeInclusive<u64> = 1..=12;

/// Before the number in a grid's name.
const GRID: &str = "grid ";

/// The assignment's scenes, in order of their names.
pub fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assignments/ray_casting/scenes");
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|kind| kind == "toml"));
    files.sort();
    files
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

/// Judges every way to cast a scene of the assignment, and Mitsuba's film of it if there is one.
pub fn studied(file: &Path, extent: &Extent) -> Result<Vec<SceneTally>, pinhole::Error> {
    let (name, scene) = (name_of(file), read(file)?);
    let stage = Stage::new(&scene, extent.step);
    let mut tallies = judged_ways(&name, &stage, extent);
    if let Some(film) = golden(&name) {
        let casting = &stage.exact;
        let pixels = (0..film.resolution().pixels()).step_by(extent.step);
        let hits = pixels.map(|at| film.hit(at)).collect();
        tallies.push(SceneTally {
            scene: name,
            model: "Mitsuba",
            ..judged(casting.rays(), &casting.truths(), hits)
        });
    }
    Ok(tallies)
}

/// Judges every way to cast a scene of small integers.
pub fn of_grid(seed: u64, extent: &Extent) -> Vec<SceneTally> {
    // A grid has few rays.
    let stage = Stage::new(&grid(seed), 1);
    judged_ways(&format!("{GRID}{seed}"), &stage, extent)
}

fn judged_ways(name: &str, stage: &Stage, extent: &Extent) -> Vec<SceneTally> {
    let (rays, truths) = (stage.exact.rays(), stage.exact.truths());
    let films = WAYS.map(|(_, plain)| Box::new(move || stage.cast(plain)) as Workload);
    let times = race(films.into(), rays.len(), extent.seconds);
    let cheaper = stage.exact.has_boxes;
    let tally = |(at, ((model, plain), time)): (usize, ((&'static str, Option<bool>), Time))| {
        let (hits, tally) = stage.hits(plain);
        let has_boxes = plain.unwrap_or(cheaper);
        let is_counted = extent.instructions && has_boxes == cheaper;
        let count = || speed::instructions(&format!("{SCENE}{name}"), at, rays.len());
        SceneTally {
            scene: name.into(),
            model,
            search: Some(search_name(has_boxes)),
            nanoseconds: Some(time.nanoseconds),
            instructions: is_counted.then(count).flatten(),
            tests: Some(tally.tests as f64 / rays.len() as f64),
            semi_static: tally.semi_static,
            double_double: tally.double_double,
            exact: tally.exact,
            close_calls: tally.close_calls,
            ..judged(rays, &truths, hits)
        }
    };
    WAYS.into_iter().zip(times).enumerate().map(tally).collect()
}

fn judged(rays: &[Ray<f64>], truths: &[TrueHit], hits: Vec<Option<Hit>>) -> SceneTally {
    let errors = errors(rays, truths, hits, f64::INFINITY);
    SceneTally {
        rays: errors.rays,
        wrong_ids: errors.wrong_ids,
        worst_t: errors.worst_t,
        ..SceneTally::default()
    }
}
