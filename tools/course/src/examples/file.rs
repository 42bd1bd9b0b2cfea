//! The file of examples: how it is read, and how one begins.

use std::path::Path;

use glam::DVec3;
use pinhole::Fact;
use serde::Deserialize;
use toml::Spanned;

use super::{Asked, Claim, OWN, find_task, groups};
use crate::assignment::Assignment;
use crate::error::{Error, Result};
use crate::goldens::Goldens;

/// A file of examples.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub task: Spanned<String>,
    #[serde(default)]
    pub example: Vec<Spanned<Entry>>,
}

/// One example. Which parts an answer has depends on the task.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
    group: Option<String>,
    question: Option<usize>,
    pub ray: Option<Spanned<OwnRay>>,
    shape: Option<toml::Table>,
    hit: Option<bool>,
    object: Option<f64>,
    t: Option<f64>,
    normal: Option<[f64; 3]>,
    origin: Option<[f64; 3]>,
    direction: Option<[f64; 3]>,
    min: Option<[f64; 3]>,
    max: Option<[f64; 3]>,
}

/// A ray e + t d that a student has chosen. Only values of t from `min_t` on count.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OwnRay {
    pub e: DVec3,
    pub d: DVec3,
    pub min_t: f64,
}

impl Entry {
    /// Its group and question. `own` is the next question of the group [`OWN`].
    pub(super) fn question(&self, own: &mut usize) -> Result<(&str, usize)> {
        match (&self.group, self.question, &self.ray, &self.shape) {
            (Some(group), Some(question), None, None) => Ok((group, question)),
            (None, None, Some(_), Some(_)) => {
                *own += 1;
                Ok((OWN, *own - 1))
            }
            _ => Err(Error::input(
                "this example has no question, or more than one",
                "give `group` and `question`, or `ray` and `shape`",
            )),
        }
    }

    /// What it says about the answer to a question.
    pub(super) fn claim(&self, asked: &Asked) -> Result<Claim> {
        let number = |number: f64| vec![number];
        let vector = |vector: [f64; 3]| vector.to_vec();
        let parts = [
            ("object", self.object.map(number)),
            ("t", self.t.map(number)),
            ("normal", self.normal.map(vector)),
            ("origin", self.origin.map(vector)),
            ("direction", self.direction.map(vector)),
            ("min", self.min.map(vector)),
            ("max", self.max.map(vector)),
        ];
        let given = parts.into_iter().filter_map(|(part, it)| Some((part, it?)));
        let parts: Vec<_> = given.collect();
        let hit = match asked.id() {
            Some(_) if !parts.is_empty() => self.hit.or(Some(true)),
            _ => self.hit,
        };
        let mut names: Vec<&str> = asked.parts.iter().map(|(part, _)| *part).collect();
        names.extend(asked.id().map(|_| "hit"));
        let given = parts.iter().map(|(part, _)| *part);
        let mut given = given.chain(self.hit.map(|_| "hit"));
        if let Some(part) = given.find(|part| !names.contains(part)) {
            return Err(Error::input(
                format!("an answer to this question has no `{part}`"),
                format!("give one or more of: {}", names.join(", ")),
            ));
        }
        match hit == Some(false) && !parts.is_empty() {
            true => Err(Error::input(
                "`hit = false` says that nothing is hit, but there are numbers for a hit",
                "remove `hit = false`, or the numbers",
            )),
            false => Ok(Claim { hit, parts }),
        }
    }
}

/// A file with one question of each group, without answers. `path` is how to call it.
///
/// # Errors
/// If there is no such task, or its questions can't be read.
pub fn new_file(task: &str, assignment: &Assignment, path: &Path) -> Result<String> {
    let task = find_task(task, assignment)?;
    let goldens = Goldens::read(&assignment.golden(), assignment)?;
    let mut text = format!(
        "# Questions about `{}`. Work out some answers, write them below their questions, and run:\n\
         # cargo pinhole examples {}\n\
         task = \"{}\"\n",
        task.name,
        path.display(),
        task.name
    );
    for group in groups(task) {
        let asked = Asked::read(&goldens, task, &group.group)?;
        let Some(place) = asked.places.first() else {
            continue;
        };
        text += &format!(
            "\n# {}\n[[example]]\ngroup = \"{}\"\nquestion = 0 # or any up to {}\n",
            group.about,
            group.group,
            asked.places.len() - 1
        );
        for Fact { label, text: says } in asked.describe(*place) {
            let says = says.replace('\n', "\n#           ");
            text += &format!("# {label:<9} {says}\n");
        }
        if asked.id().is_some() {
            text += "# hit = false\n";
        }
        for (part, channels) in &asked.parts {
            text += &match channels.len() {
                1 => format!("# {part} = 0\n"),
                _ => format!("# {part} = [0, 0, 0]\n"),
            };
        }
    }
    Ok(text)
}
