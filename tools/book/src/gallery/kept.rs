//! Strips as they are kept: pictures beside the chapters, and a list of what each shows.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use super::Told;
use super::made::Strips;
use super::strip::Strip;
use crate::checkout::{Checkout, write};
use crate::error::{Problem, Result};

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
pub fn list(checkout: &Checkout) -> List {
    let text = fs::read_to_string(list_path(checkout)).unwrap_or_default();
    toml::from_str(&text).unwrap_or_default()
}

/// Keeps strips, and what is told of them.
pub fn keep(strips: Strips, checkout: &Checkout) -> Result<()> {
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

/// Kept strips that are not these.
pub fn stale(strips: &Strips, checkout: &Checkout) -> Vec<Problem> {
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
        keep(strips(), &checkout).expect("there is room");
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
