//! Pictures of a task's known mistakes: expected, yours, and where they differ.
//!
//! Each mistake is compiled like a student's answers, and casts the scenes in which it shows.
//! [`choice`] picks the scene that distinguishes it from the others. The strips of three pictures
//! are stored beside the chapters, with a list of what each shows, so that building the book
//! needs no compiler. The check casts each strip again and compares.

pub mod cast;
pub mod choice;
mod page;
pub mod strip;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{fmt, fs};

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::diagnosis::known::KnownMistakes;
use pinhole_course::mistake::{self, MistakeFolder};
use serde::{Deserialize, Serialize};

use crate::course;
use crate::error::{Problem, Result};
use cast::Caster;
use choice::{Candidate, Shot, choose, difference, is_seen};
pub use page::shown;
use strip::{SceneGolden, Strip};

/// The kind of false colours in which a film is shown.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum View {
    /// Objects.
    Id,
    /// Depths.
    Depth,
    /// Normals.
    Normal,
}

impl View {
    const ALL: [View; 3] = [View::Id, View::Depth, View::Normal];
}

impl fmt::Display for View {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            View::Id => "id",
            View::Depth => "depth",
            View::Normal => "normal",
        })
    }
}

/// What a strip shows.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct StripSubject {
    /// The scene that was cast.
    pub scene: String,
    /// The kind of false colours.
    pub view: View,
    /// How many pixels differ.
    pub pixels: usize,
    /// How many pixels there are.
    pub of: usize,
}

/// The strip of each mistake; `None` if it shows in no scene.
type Strips = Vec<(String, Option<Strip>)>;

const AGAIN: &str = "choose and cast again: cargo pinhole book gallery";

/// The single mistakes, the scenes, and the program that casts them.
struct Studio<'a> {
    mistakes: Vec<MistakeFolder>,
    scenes: Vec<SceneGolden>,
    caster: Caster<'a>,
}

impl<'a> Studio<'a> {
    fn new(assignment: &'a Assignment, checkout: &'a Checkout) -> Result<Studio<'a>> {
        let all = mistake::read_all(assignment)?.into_iter();
        let scenes = assignment.scenes.iter();
        let scenes = scenes.map(|scene| SceneGolden::read(&scene.name, assignment));
        Ok(Studio {
            mistakes: all.filter(|one| one.mistake.is_single()).collect(),
            scenes: scenes.collect::<Result<_>>()?,
            caster: Caster::new(assignment, checkout)?,
        })
    }

    /// Every picture that could show a mistake.
    fn candidate(&self, mistake: &MistakeFolder, known: &KnownMistakes) -> Result<Candidate> {
        let shows = |scene: &&SceneGolden| {
            let film = known.films.get(&scene.name);
            film.is_some_and(|film| film.contains_key(&mistake.slug))
        };
        let scenes: Vec<&SceneGolden> = self.scenes.iter().filter(shows).collect();
        let films = self.caster.films(mistake, &scenes)?;
        let mut shots = Vec::new();
        for (scene, film) in scenes.iter().zip(&films) {
            for view in View::ALL {
                let picture = scene.picture(film, view);
                let expected = scene.picture(scene.golden.film(), view);
                if is_seen(&expected, &picture) {
                    shots.push(Shot {
                        scene: scene.name.clone(),
                        view,
                        visible: difference(&expected, &picture),
                        picture,
                    });
                }
            }
        }
        Ok(Candidate {
            slug: mistake.slug.clone(),
            tasks: mistake.mistake.fails.clone(),
            shots,
        })
    }

    /// The strip of a mistake in this scene and view.
    fn strip(&self, mistake: &MistakeFolder, scene: &str, view: View) -> Result<Option<Strip>> {
        let Some(scene) = self.scenes.iter().find(|own| own.name == scene) else {
            return Ok(None);
        };
        let films = self.caster.films(mistake, &[scene])?;
        films
            .first()
            .map(|film| scene.strip(film, view))
            .transpose()
    }
}

/// Chooses a scene and a view for every mistake, and stores the strips.
pub fn keep(checkout: &Checkout) -> Result<()> {
    let mut strips = Strips::new();
    for assignment in course::assignments(checkout)? {
        strips.extend(chosen(&assignment, checkout)?);
    }
    keep_all(strips, checkout)
}

/// The strips of an assignment's mistakes, newly chosen.
fn chosen(assignment: &Assignment, checkout: &Checkout) -> Result<Strips> {
    let known = KnownMistakes::read(&assignment.golden())?;
    let studio = Studio::new(assignment, checkout)?;
    let count = studio.mistakes.len();
    let mut candidates = Vec::new();
    for (number, mistake) in (1..).zip(&studio.mistakes) {
        eprintln!("mistake {number} of {count}: {}", mistake.slug);
        candidates.push(studio.candidate(mistake, &known)?);
    }
    let chosen = choose(&candidates);
    let mut strips = Strips::new();
    for mistake in &studio.mistakes {
        let strip = match chosen.get(mistake.slug.as_str()) {
            Some(shot) => studio.strip(mistake, &shot.scene, shot.view)?,
            None => None,
        };
        strips.push((mistake.slug.clone(), strip));
    }
    Ok(strips)
}

/// Strips that differ from what their mistake casts, or look like another strip of the same
/// chapter.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    let mut strips = Strips::new();
    let mut problems = Vec::new();
    for assignment in course::assignments(checkout)? {
        let (own, wrong) = cast_again(&assignment, checkout)?;
        strips.extend(own);
        problems.extend(wrong);
    }
    problems.extend(stale(&strips, checkout));
    Ok(problems)
}

/// The listed strips of an assignment's mistakes, cast again, and their problems.
fn cast_again(assignment: &Assignment, checkout: &Checkout) -> Result<(Strips, Vec<Problem>)> {
    let studio = Studio::new(assignment, checkout)?;
    let list = list(checkout);
    let mut strips = Strips::new();
    for mistake in &studio.mistakes {
        let strip = match list.get(&mistake.slug) {
            Some(shown) => studio.strip(mistake, &shown.scene, shown.view)?,
            None => None,
        };
        strips.push((mistake.slug.clone(), strip));
    }
    let known = KnownMistakes::read(&assignment.golden())?;
    let shows = |slug: &String| {
        known.films.iter().any(|(film, its)| {
            assignment.scenes.iter().any(|scene| &scene.name == film) && its.contains_key(slug)
        })
    };
    let mut problems = Vec::new();
    for (slug, _) in strips
        .iter()
        .filter(|(slug, strip)| strip.is_none() && shows(slug))
    {
        let path = checkout.inside(&strip_path(slug, checkout));
        problems.push(Problem::of(
            path,
            "a scene shows this mistake, but no strip does",
            AGAIN,
        ));
    }
    problems.extend(alike(&strips, &studio.mistakes, checkout));
    Ok((strips, problems))
}

/// Strips of one chapter that show the same picture.
fn alike(strips: &Strips, mistakes: &[MistakeFolder], checkout: &Checkout) -> Vec<Problem> {
    let mut seen: BTreeMap<(&str, &[u8]), &str> = BTreeMap::new();
    let mut problems = Vec::new();
    for (MistakeFolder { mistake, .. }, (slug, strip)) in mistakes.iter().zip(strips) {
        let Some(strip) = strip else { continue };
        for task in &mistake.fails {
            if let Some(twin) = seen.insert((task, &strip.png), slug) {
                let path = checkout.inside(&strip_path(slug, checkout));
                let problem = format!("in the gallery of {task}, {twin} has the same picture");
                problems.push(Problem::of(path, problem, AGAIN));
            }
        }
    }
    problems
}

/// The strips, by mistake.
type List = BTreeMap<String, StripSubject>;

fn list_path(checkout: &Checkout) -> PathBuf {
    checkout.book().join("gallery.toml")
}

fn strip_path(slug: &str, checkout: &Checkout) -> PathBuf {
    checkout
        .book()
        .join("src/gallery")
        .join(format!("{slug}.png"))
}

/// What each strip shows. Empty if there are no strips yet.
fn list(checkout: &Checkout) -> List {
    let text = fs::read_to_string(list_path(checkout)).unwrap_or_default();
    toml::from_str(&text).unwrap_or_default()
}

/// Stores strips and the list of what each shows, replacing earlier ones.
fn keep_all(strips: Strips, checkout: &Checkout) -> Result<()> {
    for slug in list(checkout).keys() {
        let _absent = fs::remove_file(strip_path(slug, checkout));
    }
    let mut list = List::new();
    for (slug, strip) in strips {
        if let Some(Strip { shown, png }) = strip {
            checkout.write(strip_path(&slug, checkout), png)?;
            list.insert(slug, shown);
        }
    }
    let text = toml::to_string(&list).expect("it is a table of tables");
    let head = "# Written by `book gallery`: what each strip of book/src/gallery shows.\n\n";
    Ok(checkout.write(list_path(checkout), format!("{head}{text}"))?)
}

/// Stored strips that differ from these.
fn stale(strips: &Strips, checkout: &Checkout) -> Vec<Problem> {
    let list = list(checkout);
    let mut problems = Vec::new();
    for (slug, strip) in strips {
        let path = strip_path(slug, checkout);
        let kept = fs::read(&path).ok();
        let same = match strip {
            Some(Strip { shown, png }) => {
                list.get(slug) == Some(shown) && kept.as_ref() == Some(png)
            }
            None => kept.is_none() && !list.contains_key(slug),
        };
        if !same {
            let problem = "the strip is missing or out of date";
            problems.push(Problem::of(checkout.inside(&path), problem, AGAIN));
        }
    }
    for slug in list.keys() {
        if !strips.iter().any(|(made, _)| made == slug) {
            let path = checkout.inside(&strip_path(slug, checkout));
            let remedy = "remove it, and its lines in book/gallery.toml";
            problems.push(Problem::of(path, "there is no such mistake", remedy));
        }
    }
    problems
}

#[cfg(test)]
mod tests;
