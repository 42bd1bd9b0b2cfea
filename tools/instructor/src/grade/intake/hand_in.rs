//! Divides a path's files among the people who handed them in.

use std::collections::BTreeMap;

use super::names::{self, PlatformName, Sign};
use super::reader::{self, Content, Found};
use pinhole_course::assignment::Assignment;

/// What one person handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct HandIn {
    pub name: String,
    /// The names of its files or folders, as the platform gave them.
    pub given: Vec<String>,
    /// What the names say about the person. There are several signs if the names may contradict
    /// each other.
    pub signs: Vec<Sign>,
    pub uploads: Vec<Upload>,
    /// Uploads that a later one replaces.
    pub superseded: Vec<String>,
}

/// One file that a person handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct Upload {
    /// Its path inside the upload; empty if it is the upload itself.
    pub path: Vec<String>,
    /// Greater for later uploads, if the platform counts them.
    pub order: u64,
    pub content: Content,
}

impl Upload {
    /// The path, for people to read.
    pub fn name(&self, whole: &str) -> String {
        match self.path.is_empty() {
            true => whole.into(),
            false => self.path.join("/"),
        }
    }
}

/// A path on the command line, and what was found there.
pub struct Source<'a> {
    pub name: String,
    pub is_archive: bool,
    /// Whether no other path was named.
    pub is_only: bool,
    pub found: Vec<Found>,
    pub assignment: &'a Assignment,
    /// Whether somebody on the roster has this name or id.
    pub is_on_roster: &'a dyn Fn(&str) -> bool,
}

/// The names at the top of a source, and everything below each.
type Tops = BTreeMap<String, Vec<Found>>;

impl Source<'_> {
    /// Divides the files among people. Also returns the names of files that belong to nobody,
    /// and whether this is a class.
    pub fn share_out(mut self) -> (Vec<HandIn>, Vec<String>, bool) {
        if self.is_archive {
            self.unwrap();
        }
        if !self.is_class() {
            return (vec![self.whole()], Vec::new(), false);
        }
        let (all, ignored) = of_class(tops(self.found));
        (all, ignored, true)
    }

    /// Removes a single folder around a whole class.
    fn unwrap(&mut self) {
        let tops = tops(self.found.clone());
        let Some((top, found)) = tops.iter().next().filter(|_| tops.len() == 1) else {
            return;
        };
        let inside = below(found);
        let is_class = !inside.is_empty() && self.names_people(&inside);
        if is_class && !self.is_person(top) && !reader::is_archive(top) {
            self.found = inside;
        }
    }

    fn is_person(&self, name: &str) -> bool {
        let stem = reader::stem(name);
        !names::platforms(name).is_empty() || (self.is_on_roster)(stem)
    }

    /// Whether everything at the top has a person's name.
    fn names_people(&self, found: &[Found]) -> bool {
        let mut tops = found.iter().filter_map(|found| found.path.first());
        tops.all(|top| self.is_person(top))
    }

    /// Whether this is a folder of submissions, and not one.
    fn is_class(&self) -> bool {
        if self.found.iter().any(|found| found.path.is_empty()) {
            return false;
        }
        // The author of a single submission could give its files the names of others.
        if self.is_archive {
            return !self.found.is_empty()
                && !self.is_person(&self.name)
                && self.names_people(&self.found);
        }
        let tops = tops(self.found.clone());
        if tops.keys().any(|top| self.is_person(top)) {
            return true;
        }
        let answers = || {
            let is_answer = |found: &&Found| matches!(found.content, Content::Answer { .. });
            self.found.iter().filter(is_answer).map(|it| &it.path[..])
        };
        let is_in_handout = |path: &[String]| match path {
            [handout, src, _] => handout == "handout" && src == "src",
            [assignments, _, handout, src, _] => {
                assignments == "assignments" && handout == "handout" && src == "src"
            }
            _ => false,
        };
        if self.is_person(&self.name) || answers().any(is_in_handout) {
            return false;
        }
        let file = |path: &'_ [String]| match path {
            [file] => Some(file.clone()),
            [src, file] if src == "src" => Some(file.clone()),
            _ => None,
        };
        let direct: Vec<String> = answers().filter_map(file).collect();
        let holding = tops.iter().filter(|(top, found)| {
            let holds = |it: &Found| it.path.len() > 1 || is_closed(&it.content);
            *top != "src"
                && found
                    .iter()
                    .any(|it| holds(it) && it.content != Content::Other)
        });
        let (holding, tasks) = (holding.count(), &self.assignment.tasks);
        match direct.is_empty() {
            false => {
                let is_whole = tasks.iter().all(|task| direct.contains(&task.file()));
                !is_whole && holding > 1
            }
            true => self.is_only || holding != 1,
        }
    }

    /// Everything as one submission.
    fn whole(self) -> HandIn {
        let upload = |found: Found| Upload {
            path: found.path,
            order: 0,
            content: found.content,
        };
        HandIn {
            signs: signs(&self.name),
            name: account(&self.name),
            given: vec![self.name],
            uploads: self.found.into_iter().map(upload).collect(),
            superseded: Vec::new(),
        }
    }
}

fn is_closed(content: &Content) -> bool {
    matches!(content, Content::Refused(_) | Content::Unreadable(_))
}

fn tops(found: Vec<Found>) -> Tops {
    let mut tops = Tops::new();
    for found in found {
        let top = found.path.first().cloned().unwrap_or_default();
        tops.entry(top).or_default().push(found);
    }
    tops
}

/// The same files, with paths below the top folder.
fn below(found: &[Found]) -> Vec<Found> {
    let inside = found.iter().filter(|found| found.path.len() > 1);
    let shorter = inside.map(|found| Found {
        path: found.path[1..].to_vec(),
        content: found.content.clone(),
    });
    shorter.collect()
}

/// The key under which uploads of the same person are collected. If the name is a platform's,
/// it is the person's name and number there, which are the same for all uploads of an account.
/// Otherwise, it is the whole name.
fn account(name: &str) -> String {
    match &names::platforms(name)[..] {
        [one] => format!("{}_{}", one.person, one.number),
        _ => name.into(),
    }
}

/// The possible meanings of a name: several if it fits several platforms.
fn signs(name: &str) -> Vec<Sign> {
    let platforms = names::platforms(name);
    match platforms.is_empty() {
        false => platforms.iter().map(PlatformName::sign).collect(),
        true => vec![Sign {
            person: reader::stem(name).into(),
            number: None,
        }],
    }
}

/// Divides the files of a class among its people.
fn of_class(tops: Tops) -> (Vec<HandIn>, Vec<String>) {
    let mut ignored = Vec::new();
    let mut all: BTreeMap<String, Vec<(String, Vec<Found>)>> = BTreeMap::new();
    for (top, found) in tops {
        let holds = |it: &Found| {
            it.path.len() > 1 || !matches!(it.content, Content::Other | Content::Answer { .. })
        };
        let name = match &names::platforms(&top)[..] {
            [_] => account(&top),
            [] if !found.iter().any(holds) => {
                let is_settings = top.starts_with('.') && !top.ends_with('/');
                ignored.extend((!is_settings || reader::is_archive(&top)).then_some(top));
                continue;
            }
            _ => top.clone(),
        };
        all.entry(name).or_default().push((top, found));
    }
    let all = all.into_iter().map(|(name, parts)| of_one(name, parts));
    (all.collect(), ignored)
}

/// What one person handed in, in one or several uploads. Of several archives, only the newest
/// counts.
fn of_one(name: String, parts: Vec<(String, Vec<Found>)>) -> HandIn {
    let order = |top: &str| match &names::platforms(top)[..] {
        [one] => one.upload,
        _ => 0,
    };
    let archives = parts.iter().map(|(top, _)| top);
    let newest = archives
        .filter(|top| reader::is_archive(top))
        .map(|top| order(top))
        .max();
    let mut hand_in = HandIn {
        signs: signs(&parts[0].0),
        name,
        given: Vec::new(),
        uploads: Vec::new(),
        superseded: Vec::new(),
    };
    for (top, found) in parts {
        let order = order(&top);
        if reader::is_archive(&top) && newest.is_some_and(|newest| order < newest) {
            hand_in.superseded.push(top);
            continue;
        }
        hand_in.given.push(top.clone());
        let rest = match &names::platforms(&top)[..] {
            [one] => one.rest.to_owned(),
            _ => top.clone(),
        };
        let uploads = found.into_iter().map(|found| Upload {
            path: match (found.path.len(), &found.content) {
                (1, Content::Answer { .. } | Content::Other) => vec![rest.clone()],
                _ => found.path[1..].to_vec(),
            },
            order,
            content: found.content,
        });
        hand_in.uploads.extend(uploads);
    }
    hand_in
}
