//! Casts whole scenes on their own rays: in plain `f64`, by brute force and with boxes, and
//! exactly. Judges every pixel, and times all ways in turn.

use std::hint::black_box;
use std::path::{Path, PathBuf};

use pinhole::{Film, Scene, ShapeKind};
use rayon::prelude::*;

use crate::cast::model::Plain;
use crate::cast::rays::{camera, rays};
use crate::cast::world::World;
use crate::cast::{Caster, Search, Seen, Tally};
use crate::instructions;
use crate::judge::median_and_worst;
use crate::oracle::scene::{HitComparison, TrueHit, compared, sight};
use crate::plan::EXACT_OBJECTS;
use crate::plan::casting::PlannedCaster;
use crate::result::SceneTally;
use crate::shape::Ray;
use crate::speed::{Workload, race};
use crate::vector::Vector;

/// How much of every scene is cast.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// Every `step`-th ray is cast; 1 for all.
    pub step: usize,
    /// How long each way to cast the scene is timed.
    pub seconds: f64,
    /// Whether instructions of whole films are counted.
    pub instructions: bool,
}

/// A scene ready to be cast, and its rays.
struct SceneRays {
    caster: Caster,
    exact: PlannedCaster,
    rays: Vec<Ray<f64>>,
    min_t: f64,
}

/// One way to cast a scene.
struct CastMethod {
    /// The name in tables.
    model: &'static str,
    /// The search; `None` for the cheaper one.
    search: Option<Search>,
    /// Casts one ray, and returns object, t and normal.
    see: fn(&SceneRays, &Ray<f64>, &mut Tally) -> Seen,
    /// Casts all rays, for timing. It does not read a clock, because rustix's clock does not
    /// work under valgrind.
    film: fn(&SceneRays),
}

const WAYS: [CastMethod; 3] = [
    CastMethod {
        model: "f64",
        search: Some(Search::BruteForce),
        see: |scene, ray, tally| scene.plain(Search::BruteForce, ray, tally),
        film: |scene| scene.film(|ray, tally| scene.plain(Search::BruteForce, ray, tally)),
    },
    CastMethod {
        model: "f64",
        search: Some(Search::Boxes),
        see: |scene, ray, tally| scene.plain(Search::Boxes, ray, tally),
        film: |scene| scene.film(|ray, tally| scene.plain(Search::Boxes, ray, tally)),
    },
    CastMethod {
        model: "exact",
        search: None,
        see: |scene, ray, tally| scene.exact.see(ray, tally),
        film: |scene| scene.film(|ray, tally| scene.exact.see(ray, tally)),
    },
];

impl SceneRays {
    fn new(scene: &Scene, step: usize) -> SceneRays {
        let (world, all) = (World::of(&scene.objects), rays(scene));
        let camera = camera(scene, &all);
        SceneRays {
            exact: PlannedCaster::new(world.clone(), camera, scene.min_t, EXACT_OBJECTS),
            caster: Caster::new(world),
            rays: all.into_iter().step_by(step).collect(),
            min_t: scene.min_t,
        }
    }

    #[inline(always)]
    fn plain(&self, search: Search, ray: &Ray<f64>, tally: &mut Tally) -> Seen {
        let found = self.caster.first::<Plain>(search, ray, self.min_t, tally)?;
        let normal = found.part.shape.normal(ray, found.t);
        Some((found.part.object, found.t, normal))
    }

    #[inline(always)]
    fn film(&self, see: impl Fn(&Ray<f64>, &mut Tally) -> Seen) {
        for ray in black_box(&self.rays) {
            black_box(see(ray, &mut Tally::default()));
        }
    }
}

/// Prefix of a scene's name among the workloads that run under valgrind.
const SCENE: &str = "scene:";

/// Casts the named scene `films` times in one way. Returns false if there is no such scene.
pub fn cast(named: &str, way: usize, films: u32) -> bool {
    let name = named.strip_prefix(SCENE).map(|name| format!("{name}.toml"));
    let file = name.and_then(|name| files().into_iter().find(|file| file.ends_with(&name)));
    let Some(file) = file else { return false };
    let stage = SceneRays::new(&read(&file).expect("the scene is committed"), 1);
    if let Some(way) = WAYS.get(way) {
        (0..films).for_each(|_| (way.film)(&stage));
    }
    true
}

/// The assignment's scenes, in order of their names.
pub fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assignments/ray_casting/scenes");
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|kind| kind == "toml"));
    files.sort();
    files
}

/// The shapes with kernels; a soup consists of triangles.
const SHAPES: [ShapeKind; 4] = [
    ShapeKind::Sphere,
    ShapeKind::Plane,
    ShapeKind::Triangle,
    ShapeKind::Soup,
];

/// A scene, if there are kernels for all its shapes.
///
/// # Errors
/// If it cannot be read, or has a shape that the study does not support.
pub fn read(file: &Path) -> Result<Scene, pinhole::Error> {
    let scene = Scene::read(file)?;
    let odd = scene.objects.iter().enumerate().find_map(|(k, shape)| {
        let kind = shape.kind();
        (!SHAPES.contains(&kind)).then(|| format!("object {k} is a {kind}"))
    });
    odd.map_or(Ok(scene), |odd| {
        let problem = format!("shape not supported: {odd}, and the study has no kernel for it");
        let remedy = "leave it out, or name another scene";
        Err(pinhole::Error::new(file, problem, remedy))
    })
}

/// Mitsuba's film of a scene of the assignment.
fn golden(name: &str) -> Option<Film> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../golden/ray_casting");
    Film::read(&folder.join(format!("{name}.exr"))).ok()
}

/// Judges every way to cast a scene, and Mitsuba's film of it if there is one.
pub fn studied(file: &Path, share: Share) -> Result<Vec<SceneTally>, pinhole::Error> {
    let scene = read(file)?;
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let stage = SceneRays::new(&scene, share.step);
    let (parts, rays) = (&stage.caster.world.parts, &stage.rays);
    let truth = |ray| sight(parts, ray, scene.min_t);
    let truths: Vec<_> = rays.par_iter().map(truth).collect();
    let films = WAYS
        .iter()
        .map(|way| Box::new(|| (way.film)(&stage)) as Workload);
    let times = race(films.collect(), rays.len(), share.seconds);
    let mut tallies = Vec::new();
    for (at, (way, time)) in WAYS.iter().zip(times).enumerate() {
        let cheaper = Search::cheaper(parts);
        let search = way.search.unwrap_or(cheaper);
        let is_counted = share.instructions && search == cheaper;
        let count = || instructions::of_cast(&format!("{SCENE}{name}"), at, rays.len());
        let mut tally = Tally::default();
        let seen = rays.iter().map(|ray| (way.see)(&stage, ray, &mut tally));
        let seen = seen.collect();
        tallies.push(SceneTally {
            scene: name.clone().into(),
            model: way.model.into(),
            search: Some(search.name().into()),
            parts: parts.len() as u64,
            nanoseconds: Some(time.nanoseconds),
            instructions: is_counted.then(count).flatten(),
            tests: Some(tally.tests as f64 / rays.len() as f64),
            semi_static: tally.semi_static,
            double_double: tally.double_double,
            exact: tally.exact,
            close_calls: tally.close_calls,
            ..judged(rays, &truths, seen)
        });
    }
    if let Some(film) = golden(&name) {
        let seen = seen_in(&film).into_iter().step_by(share.step).collect();
        tallies.push(SceneTally {
            scene: name.clone().into(),
            model: "Mitsuba".into(),
            parts: parts.len() as u64,
            ..judged(rays, &truths, seen)
        });
    }
    Ok(tallies)
}

/// Reads object, t and normal of each pixel from a film.
fn seen_in(film: &Film) -> Vec<Seen> {
    let channels = pinhole::film::HIT_CHANNELS.map(|name| film.channel(name).unwrap_or_default());
    let pixel = |at: usize| {
        let [id, t, x, y, z] = channels.map(|samples| f64::from(samples[at]));
        (id >= 0.0).then(|| (id as u32, t, Vector::new(x, y, z)))
    };
    (0..film.resolution().pixels()).map(pixel).collect()
}

fn judged(rays: &[Ray<f64>], truths: &[TrueHit], seen: Vec<Seen>) -> SceneTally {
    let mut tally = SceneTally {
        rays: rays.len() as u64,
        ..SceneTally::default()
    };
    let mut errors = Vec::new();
    for ((ray, truth), seen) in rays.iter().zip(truths).zip(seen) {
        match compared(truth, ray, seen) {
            HitComparison::Miss => (),
            HitComparison::AnotherObject => tally.wrong_ids += 1,
            HitComparison::Off { t, normal } => {
                errors.push(t);
                tally.worst_normal = Some(tally.worst_normal.unwrap_or(0.0).max(normal));
            }
        }
    }
    [tally.median_t, tally.worst_t] = median_and_worst(errors);
    tally
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scene_with_a_shape_without_kernel_is_rejected() {
        let file = std::env::temp_dir().join(format!("pinhole-disk-{}.toml", std::process::id()));
        let scene = files().remove(0);
        let scene = std::fs::read_to_string(scene).expect("it is committed");
        let camera = scene.split("[[object]]").next().expect("a camera");
        let disk =
            "[[object]]\ntype = \"disk\"\ncenter = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 1\n";
        std::fs::write(&file, format!("{camera}{disk}")).expect("room on the disk");
        let error = read(&file).expect_err("there is no kernel for a disk");
        std::fs::remove_file(&file).expect("it was written");
        let problem = "shape not supported: object 0 is a disk";
        assert!(error.problem.starts_with(problem), "{error}");
    }
}
