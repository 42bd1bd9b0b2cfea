//! What the real mistakes of a task look like: expected, theirs, and where they differ.
//!
//! Each mistake is compiled as a student's answers are, and casts the scene that shows it
//! best. The strips of three pictures are kept beside the chapters, so that building the
//! book needs none of that; the check makes them anew and compares.

pub mod strip;

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use pinhole::Film;
use pinhole::judge::Golden;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::checkout::{Checkout, write};
use crate::course::{Course, Mistake, SOLUTIONS_COUNTED, mistakes};
use crate::error::{Error, Problem, Result};
use crate::html::escaped;
use crate::run::copy_rust;
use crate::{check::pages_files, program};
use strip::Strip;

/// What is told of a strip.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Told {
    /// The scene that was cast.
    pub scene: String,
    /// Which of the three pictures: `id`, `depth` or `normal`.
    pub picture: String,
    /// In how many pixels it differs.
    pub pixels: usize,
    /// Of how many.
    pub of: usize,
}

/// By mistake.
type List = BTreeMap<String, Told>;

/// So many stand open; the others are folded.
const OPEN: usize = 4;

fn list_path(checkout: &Checkout) -> PathBuf {
    checkout.book().join("gallery.toml")
}

fn strip_path(slug: &str, checkout: &Checkout) -> PathBuf {
    checkout
        .book()
        .join("src/gallery")
        .join(format!("{slug}.png"))
}

fn list(checkout: &Checkout) -> List {
    let text = fs::read_to_string(list_path(checkout)).unwrap_or_default();
    toml::from_str(&text).unwrap_or_default()
}

/// HTML of a task's gallery: the mistakes made most often, then all others, folded.
pub fn shown(
    task: &str,
    to_root: &str,
    checkout: &Checkout,
) -> std::result::Result<String, (String, String)> {
    let remedy = "make it: cargo run --release -p pinhole-book -- gallery";
    let wrong = |error: Error| (error.to_string(), remedy.to_owned());
    let list = list(checkout);
    let all = mistakes(checkout).map_err(wrong)?;
    let mut own: Vec<(&String, &Mistake, Option<&Told>)> = all
        .iter()
        .filter(|(_, mistake)| {
            mistake.beliefs.is_empty() && mistake.fails.iter().any(|own| own == task)
        })
        .map(|(slug, mistake)| (slug, mistake, list.get(slug)))
        .collect();
    if own.iter().all(|(_, _, told)| told.is_none()) {
        return Err((
            format!("the gallery of {task} was never made"),
            remedy.into(),
        ));
    }
    // What was met most often first; of those never counted, what shows in most pixels.
    own.sort_by_key(|(slug, mistake, told)| {
        let share = told.map_or(0, |told| told.pixels * 1000 / told.of);
        (
            std::cmp::Reverse((told.is_some(), mistake.submissions, share)),
            (*slug).clone(),
        )
    });
    let one = |(slug, mistake, told): &(&String, &Mistake, Option<&Told>)| {
        one(slug, mistake, *told, to_root)
    };
    let (open, folded) = own.split_at(OPEN.min(own.len()));
    let open: String = open.iter().map(one).collect();
    let count = folded.len();
    let folded: String = folded.iter().map(one).collect();
    Ok(format!(
        "<div class=\"gallery\">\n{open}<details><summary>{count} more, less often \
         seen</summary>\n{folded}</details>\n</div>\n"
    ))
}

fn one(slug: &str, mistake: &Mistake, told: Option<&Told>, to_root: &str) -> String {
    let belief = escaped(&mistake.belief);
    let often = match mistake.submissions {
        Some(count) => format!(" Seen in {count} of {SOLUTIONS_COUNTED} solutions."),
        None => String::new(),
    };
    let read = escaped(&mistake.hint.read);
    let reading = format!("Read “{read}” in {}.{often}", escaped(&mistake.chapter));
    let Some(Told {
        scene,
        picture,
        pixels,
        of,
    }) = told
    else {
        return format!(
            "<figure class=\"mistake\" id=\"{slug}\"><figcaption>You may believe: “{belief}” No scene \
             shows it: questions do. {reading}</figcaption></figure>\n"
        );
    };
    let alternative = format!(
        "Scene {scene} as {picture} picture: as expected, as somebody with this belief casts it, and \
         the {pixels} of {of} pixels that differ"
    );
    format!(
        "<figure class=\"mistake\" id=\"{slug}\">\
         <div class=\"heads\" aria-hidden=\"true\"><span>expected</span><span>theirs</span>\
         <span>difference</span></div>\
         <img src=\"{to_root}gallery/{slug}.png\" alt=\"{alternative}\" loading=\"lazy\">\
         <figcaption>You may believe: “{belief}” <span class=\"where\"><code>{scene}</code>, {picture}: \
         {pixels} of {of} pixels. {reading}</span></figcaption></figure>\n"
    )
}

/// Makes strips, of all mistakes or of those named, and keeps them.
pub fn keep(slugs: &[String], checkout: &Checkout) -> Result<()> {
    keep_all(made(slugs, checkout)?, checkout)
}

/// The strip of each mistake; `None` if it shows in no scene.
type Strips = Vec<(String, Option<Strip>)>;

fn keep_all(strips: Strips, checkout: &Checkout) -> Result<()> {
    let mut list = list(checkout);
    for (slug, strip) in strips {
        match strip {
            Some(Strip { told, png }) => {
                write(&strip_path(&slug, checkout), png)?;
                list.insert(slug, told);
            }
            None => {
                list.remove(&slug);
            }
        }
    }
    write_list(&list, checkout)
}

fn write_list(list: &List, checkout: &Checkout) -> Result<()> {
    let text = toml::to_string(list).expect("it is a table of tables");
    let head = "# Written by `book gallery`: what each strip of book/src/gallery shows.\n\n";
    write(&list_path(checkout), format!("{head}{text}"))
}

/// Strips that are not what their mistake casts.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    Ok(stale(&made(&[], checkout)?, checkout))
}

fn stale(strips: &Strips, checkout: &Checkout) -> Vec<Problem> {
    let list = list(checkout);
    let remedy = "make it again: cargo run --release -p pinhole-book -- gallery";
    let mut problems = Vec::new();
    for (slug, strip) in strips {
        let path = strip_path(slug, checkout);
        let kept = fs::read(&path).ok();
        let same = match strip {
            Some(Strip { told, png }) => list.get(slug) == Some(told) && kept.as_ref() == Some(png),
            None => kept.is_none() && !list.contains_key(slug),
        };
        if !same {
            let problem = "the strip is not what this mistake casts";
            problems.push(Problem::of(checkout.inside(&path), problem, remedy));
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

/// What `pinhole golden` knows of mistakes, as far as galleries read it.
#[derive(Deserialize)]
struct Known {
    films: BTreeMap<String, BTreeMap<String, usize>>,
}

/// The strips of all mistakes, or of those named.
fn made(slugs: &[String], checkout: &Checkout) -> Result<Strips> {
    let course = Course::read(checkout)?;
    let known: Known = toml::from_str(&checkout.read("golden/ray_casting/mistakes.toml")?)
        .map_err(|error| {
            Problem::of(
                "golden/ray_casting/mistakes.toml",
                error.message(),
                "make it again",
            )
        })?;
    let pinhole = program::build("pinhole-tools", checkout)?;
    let state = state(checkout)?;
    let mut strips = Vec::new();
    for (slug, mistake) in mistakes(checkout)? {
        if !mistake.beliefs.is_empty() || !(slugs.is_empty() || slugs.contains(&slug)) {
            continue;
        }
        let mut shows = Vec::new();
        for scene in &course.scene {
            if let Some(pixels) = known
                .films
                .get(&scene.name)
                .and_then(|film| film.get(&slug))
            {
                let golden = Golden::read(&golden_path(&scene.name, checkout))?;
                let all = golden.film().resolution().pixels();
                // Best where much is wrong, and enough is right to see that it is this scene.
                let share = *pixels as f64 / all as f64;
                let merit = if share <= 0.6 { share } else { 0.6 - share };
                shows.push((merit, &scene.name, golden));
            }
        }
        shows.sort_by(|one, other| other.0.total_cmp(&one.0));
        let Some((_, scene, golden)) = shows.into_iter().next() else {
            strips.push((slug, None));
            continue;
        };
        let film = cast(&slug, scene, &pinhole, &state, checkout)?;
        let per_t = pinhole::Scene::read(&scene_path(scene, checkout))?
            .camera
            .depth_per_t();
        strips.push((slug, Some(strip::strip(scene, &golden, &film, per_t)?)));
    }
    Ok(strips)
}

fn golden_path(scene: &str, checkout: &Checkout) -> PathBuf {
    checkout.golden().join(format!("{scene}.exr"))
}

fn scene_path(scene: &str, checkout: &Checkout) -> PathBuf {
    checkout
        .assignment()
        .join("scenes")
        .join(format!("{scene}.toml"))
}

/// A hash of everything but the mistake that its film depends on.
fn state(checkout: &Checkout) -> Result<Sha256> {
    let mut hash = Sha256::new();
    let assignment = checkout.assignment();
    for folder in [
        checkout.root().join("src"),
        assignment.join("reference"),
        assignment.join("scenes"),
    ] {
        for file in pages_files(&folder)? {
            hash.update(fs::read(&file).map_err(|error| Error::file(&file, &error))?);
        }
    }
    Ok(hash)
}

/// The film of a mistake, from its last cast if nothing has changed since.
fn cast(
    slug: &str,
    scene: &str,
    pinhole: &std::path::Path,
    state: &Sha256,
    checkout: &Checkout,
) -> Result<Film> {
    let source = checkout.assignment().join("mistakes").join(slug);
    let mut hash = state.clone();
    hash.update(scene);
    for file in pages_files(&source)? {
        hash.update(fs::read(&file).map_err(|error| Error::file(&file, &error))?);
    }
    let key: String = hash
        .finalize()
        .iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    let out = checkout
        .scratch()
        .join("films")
        .join(format!("{slug}.{key}"));
    let film = out.join("film.exr");
    if !film.is_file() {
        let answers = checkout.scratch().join("answers").join(slug);
        let _absent = fs::remove_dir_all(&answers);
        copy_rust(
            &checkout.assignment().join("reference/src"),
            &answers.join("src"),
        )?;
        copy_rust(&source, &answers.join("src"))?;
        let output = Command::new(pinhole)
            .args(["render", scene, "--submission"])
            .arg(&answers)
            .arg("--out")
            .arg(&out)
            .output()
            .map_err(|error| Error::file(pinhole, &error))?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            let problem = format!("it does not cast {scene}: {said}");
            let remedy = "make what is known again: cargo run --release -- golden mistakes";
            return Err(Problem::of(checkout.inside(&source), problem, remedy).into());
        }
    }
    Ok(Film::read(&film)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(pixels: usize, png: &str) -> Strip {
        let told = Told {
            scene: "bunny".into(),
            picture: "id".into(),
            pixels,
            of: 100,
        };
        let png = png.into();
        Strip { told, png }
    }

    #[test]
    fn a_strip_that_its_mistake_no_longer_casts_is_a_problem() {
        let folder = tempfile::tempdir().expect("there is room");
        let checkout = Checkout::at(folder.path());
        let strips = || {
            vec![
                ("seen".to_owned(), Some(strip(7, "a picture"))),
                ("unseen".to_owned(), None),
            ]
        };
        keep_all(strips(), &checkout).expect("there is room");
        let told = |strips: &Strips| -> Vec<String> {
            let problems = stale(strips, &checkout).into_iter();
            problems.map(|problem| problem.problem).collect()
        };
        assert!(told(&strips()).is_empty());

        let changed = ["the strip is not what this mistake casts"];
        let mut other_picture = strips();
        other_picture[0].1 = Some(strip(7, "another"));
        assert_eq!(told(&other_picture), changed);
        let mut other_count = strips();
        other_count[0].1 = Some(strip(8, "a picture"));
        assert_eq!(told(&other_count), changed);
        let mut shown_now = strips();
        shown_now[1].1 = Some(strip(1, "a picture"));
        assert_eq!(told(&shown_now), changed);
        let mut hidden_now = strips();
        hidden_now[0].1 = None;
        assert_eq!(told(&hidden_now), changed);
        assert_eq!(told(&strips().split_off(1)), ["there is no such mistake"]);
    }
}
