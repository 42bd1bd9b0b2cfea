//! A path on the command line: a class, whose files are divided among people, or a single
//! submission.

use std::collections::BTreeSet;

use super::hand_in::{self, HandIn, Upload, account, signs, tops};
use super::index::Index;
use super::matching::Proof;
use super::names::{self, Platform, Sign};
use super::pattern::NamePattern;
use super::plain;
use super::reader::{Content, FoundFile, file_names};

/// A path on the command line, and what was found there.
pub struct Source<'a> {
    pub name: String,
    pub is_archive: bool,
    /// Whether it is an archive with a single folder around everything.
    pub is_wrapped: bool,
    /// Whether no other path was named.
    pub is_only: bool,
    pub found: Vec<FoundFile>,
    /// How submissions are named.
    pub named: &'a NamePattern,
    /// Everybody on the roster; nobody without one.
    pub index: &'a Index<'a>,
}

/// The folders at the top of the course's repository. They are not submissions.
const REPOSITORY: [&str; 6] = ["assignments", "book", "golden", "handout", "src", "tools"];

impl Source<'_> {
    /// Divides the files of a class among its people. Also returns the names of files that
    /// belong to nobody. It may be one person's upload, with names of other people inside, if it has
    /// that person's name, or beside other paths, above all if not all of them are classes
    /// (`are_classes`).
    pub fn of_class(self, are_classes: bool) -> (Vec<HandIn>, Vec<String>) {
        let has_owner = self.has_owner(file_names::stem(&self.name));
        let doubt = match (has_owner, are_classes) {
            (true, _) => Some("its own name is a person's; if it is a class, rename it"),
            (_, false) => {
                Some("was passed together with single submissions; if it is a class, pass it alone")
            }
            _ => None,
        };
        let (mut all, ignored) = hand_in::of_class(tops(self.found), self.named);
        for hand_in in &mut all {
            let is_plain = matches!(hand_in.signs[..], [Sign::Plain(_)]);
            hand_in.at_most = match (self.is_archive, self.is_only) {
                _ if doubt.is_some() => Proof::Hint,
                (true, true) if is_plain => hand_in.at_most.min(Proof::Given),
                (_, false) => Proof::Name,
                _ => hand_in.at_most,
            };
            let doubt =
                doubt.map(|why| format!("`{}` contains names of people, but {why}", self.name));
            hand_in.doubts.extend(doubt);
        }
        (all, ignored)
    }

    /// Removes a single folder around a whole class in an archive, and the list of submissions
    /// that Brightspace adds.
    pub fn unwrap(&mut self) {
        remove_list(&mut self.found);
        let Some(top) = self.found.first().and_then(|it| it.path.first()) else {
            return;
        };
        let mut inside = below(&self.found);
        remove_list(&mut inside);
        let is_class = !inside.is_empty() && self.names_people(&inside);
        let is_owners = self.is_person(top, false) || self.has_owner(top);
        if self.is_wrapped && is_class && !is_owners {
            self.found = inside;
        }
    }

    /// Whether somebody on the roster has this id or login.
    fn is_id(&self, name: &str) -> bool {
        !self.index.with_assigned(name).is_empty()
    }

    /// Whether this name says whose a submission is.
    fn has_owner(&self, name: &str) -> bool {
        plain::has_owner(name, self.named, self.index)
    }

    /// Whether a name may be a person's. What people have chosen counts only if `or_chosen`.
    fn is_person(&self, name: &str, or_chosen: bool) -> bool {
        let stem = file_names::stem(name);
        let is_of_repository = REPOSITORY.contains(&name);
        let is_on_roster = !is_of_repository && plain::is_somebody(stem, self.index, or_chosen);
        is_on_roster || !names::platforms(name).is_empty()
    }

    /// How many of these names are people's. Somebody may have chosen a single one of them, such as
    /// `main`.
    fn people_among<'t>(&self, tops: impl Iterator<Item = &'t String> + Clone) -> usize {
        let count = |or_chosen| {
            let fits = |top: &str| self.named.fits(file_names::stem(top));
            let is = |top: &&String| fits(top) || self.is_person(top, or_chosen);
            tops.clone().filter(is).count()
        };
        match count(true) {
            1 => count(false),
            people => people,
        }
    }

    /// Whether most of what is at the top has a person's name. A single other name, such as that of
    /// Moodle's default group, makes no difference.
    fn names_people(&self, found: &[FoundFile]) -> bool {
        let tops = found.iter().filter_map(|found| found.path.first());
        let tops: BTreeSet<&String> = tops.collect();
        2 * self.people_among(tops.iter().copied()) > tops.len()
    }

    /// Whether the name of an archive, or of the only folder in it, says whose all of it is. What a
    /// platform has exported is a class, even if somebody's display name is in the archive's name.
    fn is_owners(&self, name: &str, found: &[FoundFile]) -> bool {
        let is_given = |name: &String| !names::platforms(name).is_empty();
        let tops = found.iter().filter_map(|found| found.path.first());
        let tops: BTreeSet<&String> = tops.collect();
        let given = tops.iter().filter(|top| is_given(top)).count();
        let is_export = 2 * given > tops.len() && !is_given(&name.to_owned());
        match is_export {
            true => self.is_id(file_names::stem(name)),
            false => self.is_person(name, false) || self.has_owner(file_names::stem(name)),
        }
    }

    /// Whether this is a folder of submissions, and not a single submission.
    pub fn is_class(&self) -> bool {
        if self.found.iter().any(|found| found.path.is_empty()) {
            return false;
        }
        // The author of a single submission could give its files the names of others.
        if self.is_archive || !names::platforms(&self.name).is_empty() {
            return self.is_archive
                && !self.found.is_empty()
                && !self.is_owners(&self.name, &self.found)
                && self.names_people(&self.found);
        }
        // One person's folder may contain folders with names of others. But somebody may have
        // chosen the name of the class's folder. That folder contains no answers itself, so it is
        // still a class.
        if self.is_id(&self.name) || self.holds_answers() && self.is_person(&self.name, true) {
            return false;
        }
        let tops = tops(self.found.clone());
        // Names that people choose don't make a class of a clone, and beside others, nothing does.
        let is_given = |name: &String| {
            let stem = file_names::stem(name);
            let is_platforms = !names::platforms(name).is_empty();
            self.named.fits(stem) || self.is_id(stem) || is_platforms
        };
        let is_clone = self.named.fits(&self.name) && self.has_owner(&self.name);
        if is_clone && !(self.is_only && tops.keys().any(is_given)) {
            return false;
        }
        if self.people_among(tops.keys()) > 0 {
            return true;
        }
        if self.is_person(&self.name, false) || self.has_owner(&self.name) {
            return false;
        }
        let holding = self.holding().len();
        match self.holds_answers() {
            true => holding > 1,
            false => self.is_only || holding != 1,
        }
    }

    /// Whether answers lie where a single submission has them: at the top, in `src`, or where
    /// the handed-out repository has them.
    fn holds_answers(&self) -> bool {
        let is_own = |path: &[String]| match path {
            [name] => names::platforms(name).is_empty(),
            [src, _] => src == "src",
            [handout, src, _] => handout == "handout" && src == "src",
            [assignments, _, handout, src, _] => {
                assignments == "assignments" && handout == "handout" && src == "src"
            }
            _ => false,
        };
        let is_answer = |found: &&FoundFile| matches!(found.content, Content::Answer { .. });
        let mut answers = self.found.iter().filter(is_answer);
        answers.any(|found| is_own(&found.path))
    }

    /// The folders and archives at the top that may be somebody's submission.
    fn holding(&self) -> Vec<String> {
        let holds = |it: &FoundFile| {
            (it.path.len() > 1 || is_closed(&it.content)) && it.content != Content::Other
        };
        let tops = tops(self.found.clone()).into_iter();
        let tops = tops
            .filter(|(top, found)| !REPOSITORY.contains(&top.as_str()) && found.iter().any(holds));
        tops.map(|(top, _)| top).collect()
    }

    /// Everything as one submission.
    pub fn whole(self) -> HandIn {
        let holding = self.holding();
        let mut doubts = Vec::new();
        let stem = file_names::stem(&self.name);
        let mut tops = holding.iter().map(|top| file_names::stem(top));
        let names_others = tops.any(|top| plain::names_another(top, stem, self.named, self.index));
        let has_others = names_others || self.holds_answers() && !holding.is_empty();
        if holding.len() > 1 || has_others {
            let holding = file_names::quoted(&holding).join(", ");
            doubts.push(format!("other submissions may be in it: {holding}"));
        }
        let upload = |found: FoundFile| Upload {
            path: found.path,
            order: 0,
            content: found.content,
        };
        let (signs, mut at_most) = signs(&self.name, None, self.named);
        // Its author may have chosen a name like a platform's.
        if self.is_archive {
            at_most = at_most.min(Proof::Name);
        }
        HandIn {
            signs,
            at_most,
            doubts,
            name: account(&self.name, self.named),
            platform: None,
            given: vec![self.name],
            uploads: self.found.into_iter().map(upload).collect(),
            superseded: Vec::new(),
        }
    }
}

fn is_closed(content: &Content) -> bool {
    matches!(content, Content::Refused(_) | Content::Unreadable(_))
}

/// Removes the list of submissions that Brightspace adds, if these are Brightspace's.
fn remove_list(found: &mut Vec<FoundFile>) {
    let is_brightspaces = |it: &FoundFile| {
        let top = it.path.first().map_or("", String::as_str);
        let mut all = names::platforms(top).into_iter();
        all.any(|name| name.platform == Platform::Brightspace)
    };
    if found.iter().any(is_brightspaces) {
        found.retain(|it| it.path != ["index.html"]);
    }
}

/// The same files, with paths below the top folder.
fn below(found: &[FoundFile]) -> Vec<FoundFile> {
    let inside = found.iter().filter(|found| found.path.len() > 1);
    let shorter = inside.map(|found| FoundFile {
        path: found.path[1..].to_vec(),
        content: found.content.clone(),
    });
    shorter.collect()
}
