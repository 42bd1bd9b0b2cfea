//! What the real mistakes of a task look like: expected, theirs, and where they differ.
//!
//! Each mistake is compiled as a student's answers are, and casts the scene that shows it
//! best ([`strip`]). The strips of three pictures are kept beside the chapters, and a list
//! of what each shows, so that building the book needs none of that; the check makes them
//! anew and compares.

pub mod strip;

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::mistake::{self, Mistake, MistakeFolder};
use serde::{Deserialize, Serialize};

use crate::error::{Problem, Result, Wrong};
use crate::html::escaped;
use strip::{Strip, Strips, strips};

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

/// In how many public solutions mistakes were counted.
const SOLUTIONS_COUNTED: u32 = 115;

/// Makes strips, of all mistakes or of those named, and keeps them.
pub fn keep(slugs: &[String], checkout: &Checkout) -> Result<()> {
    keep_all(strips(slugs, checkout)?, checkout)
}

/// Strips that are not what their mistake casts.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    Ok(stale(&strips(&[], checkout)?, checkout))
}

/// By mistake.
type List = BTreeMap<String, Told>;

fn list_path(checkout: &Checkout) -> PathBuf {
    checkout.book().join("gallery.toml")
}

fn strip_path(slug: &str, checkout: &Checkout) -> PathBuf {
    checkout
        .book()
        .join("src/gallery")
        .join(format!("{slug}.png"))
}

/// What is told of each strip; nothing if none was ever made.
fn list(checkout: &Checkout) -> List {
    let text = fs::read_to_string(list_path(checkout)).unwrap_or_default();
    toml::from_str(&text).unwrap_or_default()
}

/// Keeps strips, and what is told of them.
fn keep_all(strips: Strips, checkout: &Checkout) -> Result<()> {
    let mut list = list(checkout);
    for (slug, strip) in strips {
        match strip {
            Some(Strip { told, png }) => {
                checkout.write(strip_path(&slug, checkout), png)?;
                list.insert(slug, told);
            }
            None => {
                list.remove(&slug);
            }
        }
    }
    let text = toml::to_string(&list).expect("it is a table of tables");
    let head = "# Written by `book gallery`: what each strip of book/src/gallery shows.\n\n";
    Ok(checkout.write(list_path(checkout), format!("{head}{text}"))?)
}

/// Kept strips that are not these.
fn stale(strips: &Strips, checkout: &Checkout) -> Vec<Problem> {
    let list = list(checkout);
    let remedy = "make it again: cargo pinhole book gallery";
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

/// So many stand open; the others are folded.
const OPEN: usize = 4;

/// HTML of a task's gallery: the mistakes made most often, then all others, folded.
pub fn shown(
    task: &str,
    to_root: &str,
    assignment: &Assignment,
    checkout: &Checkout,
) -> std::result::Result<String, Wrong> {
    let remedy = "make it: cargo pinhole book gallery";
    let list = list(checkout);
    let all = mistake::read_all(assignment).map_err(|error| (error.problem, error.remedy))?;
    let mut own: Vec<(&String, &Mistake, Option<&Told>)> = all
        .iter()
        .filter(|MistakeFolder { mistake, .. }| {
            mistake.is_single() && mistake.fails.iter().any(|own| own == task)
        })
        .map(|MistakeFolder { slug, mistake, .. }| (slug, mistake, list.get(slug)))
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
            Reverse((told.is_some(), mistake.submissions, share)),
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
