//! Makes strips: chooses the scene that shows a mistake best, and has it cast.

use std::collections::BTreeMap;

use pinhole::Scene;
use pinhole::judge::Golden;
use serde::Deserialize;

use super::cast::Caster;
use super::strip::{Strip, strip};
use crate::checkout::Checkout;
use crate::course::{Course, mistakes};
use crate::error::{Problem, Result};

/// The strip of each mistake; `None` if it shows in no scene.
pub type Strips = Vec<(String, Option<Strip>)>;

/// What `pinhole golden` knows of mistakes, as far as galleries read it.
#[derive(Deserialize)]
struct Known {
    /// By scene, then by mistake: in how many pixels it shows.
    films: BTreeMap<String, BTreeMap<String, usize>>,
}

/// Where it is kept.
const KNOWN: &str = "golden/ray_casting/mistakes.toml";

impl Known {
    fn read(checkout: &Checkout) -> Result<Known> {
        let known = toml::from_str(&checkout.read(KNOWN)?);
        Ok(known.map_err(|error| Problem::of(KNOWN, error.message(), "make it again"))?)
    }
}

/// The strips of all mistakes, or of those named.
pub fn made(slugs: &[String], checkout: &Checkout) -> Result<Strips> {
    let course = Course::read(checkout)?;
    let known = Known::read(checkout)?;
    let caster = Caster::new(checkout)?;
    let mut strips = Vec::new();
    for (slug, mistake) in mistakes(checkout)? {
        if !mistake.beliefs.is_empty() || !(slugs.is_empty() || slugs.contains(&slug)) {
            continue;
        }
        let made = match best(&slug, &course, &known, checkout)? {
            None => None,
            Some((scene, golden)) => {
                let film = caster.film(&slug, scene)?;
                let path = checkout.assignment().join("scenes");
                let camera = Scene::read(&path.join(format!("{scene}.toml")))?.camera;
                Some(strip(scene, &golden, &film, camera.depth_per_t())?)
            }
        };
        strips.push((slug, made));
    }
    Ok(strips)
}

/// The scene that shows a mistake best, and its golden.
fn best<'a>(
    slug: &str,
    course: &'a Course,
    known: &Known,
    checkout: &Checkout,
) -> Result<Option<(&'a str, Golden)>> {
    let mut shows = Vec::new();
    for scene in &course.scene {
        let film = known.films.get(&scene.name);
        if let Some(pixels) = film.and_then(|film| film.get(slug)) {
            let golden = Golden::read(&checkout.golden().join(format!("{}.exr", scene.name)))?;
            let all = golden.film().resolution().pixels();
            // Best where much is wrong, and enough is right to see that it is this scene.
            let share = *pixels as f64 / all as f64;
            let merit = if share <= 0.6 { share } else { 0.6 - share };
            shows.push((merit, scene.name.as_str(), golden));
        }
    }
    shows.sort_by(|one, other| other.0.total_cmp(&one.0));
    let best = shows.into_iter().next();
    Ok(best.map(|(_, scene, golden)| (scene, golden)))
}
