//! Collects what each person handed in.

use std::collections::{BTreeMap, BTreeSet};

use super::matching::Proof;
use super::names::{self, Platform, PlatformName, Sign};
use super::pattern::NamePattern;
use super::reader::{Content, FoundFile, file_names};

/// What one person handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct HandIn {
    pub name: String,
    /// The names of its files or folders, as the platform gave them.
    pub given: Vec<String>,
    /// The platform that exported these files, if one did.
    pub platform: Option<Platform>,
    /// What the names say about the person. There are several signs if the names may contradict
    /// each other.
    pub signs: Vec<Sign>,
    /// The most that these signs can prove.
    pub at_most: Proof,
    /// Why the files may have been divided wrongly.
    pub doubts: Vec<String>,
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

/// The names at the top of a source, and everything below each.
pub type Tops = BTreeMap<String, Vec<FoundFile>>;

/// Groups files by the first part of their paths.
pub fn tops(found: Vec<FoundFile>) -> Tops {
    let mut tops = Tops::new();
    for found in found {
        let top = found.path.first().cloned().unwrap_or_default();
        tops.entry(top).or_default().push(found);
    }
    tops
}

/// The key under which files are collected. If the name is a platform's, it is what the
/// platform calls the submission. Otherwise, it is the whole name.
pub fn account(name: &str, named: &NamePattern) -> String {
    reading(name, None, named).map_or(name.into(), |it| it.submission)
}

/// The only one of these ways.
fn reading<'n>(
    name: &'n str,
    from: Option<Platform>,
    named: &NamePattern,
) -> Option<PlatformName<'n>> {
    names::only(named.readings(name, from))
}

/// The possible meanings of a name (several if it fits several platforms), and the most that they
/// can prove. The name of an archive may be its author's choice, unless it comes from this platform.
pub fn signs(name: &str, from: Option<Platform>, named: &NamePattern) -> (Vec<Sign>, Proof) {
    let platforms = named.readings(name, from);
    let is_archive = file_names::is_archive(name);
    let is_given = platforms.iter().any(|it| Some(it.platform) == from);
    let at_most = match is_archive && !is_given {
        true => Proof::Name,
        false => Proof::Id,
    };
    let plain = if is_archive {
        file_names::stem(name)
    } else {
        name
    };
    let signs = match platforms.is_empty() {
        true => vec![Sign::Plain(plain.into())],
        false => platforms.iter().map(PlatformName::sign).collect(),
    };
    (signs, at_most)
}

/// Divides the files of a class among its people.
pub fn of_class(tops: Tops, named: &NamePattern) -> (Vec<HandIn>, Vec<String>) {
    let mut ignored = Vec::new();
    let platform = named.exported_by(tops.keys());
    let mut all: BTreeMap<String, Vec<(String, Vec<FoundFile>)>> = BTreeMap::new();
    for (top, found) in tops {
        let holds = |it: &FoundFile| {
            it.path.len() > 1 || !matches!(it.content, Content::Other | Content::Answer { .. })
        };
        let name = match &named.readings(&top, platform)[..] {
            [only] => only.submission.clone(),
            [] if !found.iter().any(holds) => {
                let is_settings = top.starts_with('.') && !top.ends_with('/');
                ignored.extend((!is_settings || file_names::is_archive(&top)).then_some(top));
                continue;
            }
            _ => top.clone(),
        };
        all.entry(name).or_default().push((top, found));
    }
    let accounts: BTreeSet<String> = all.keys().cloned().collect();
    let may_be_later = |hand_in: &HandIn| {
        let name = &hand_in.name;
        let mut others = named.readings(name, platform).into_iter();
        others.any(|it| it.submission != *name && accounts.contains(&it.submission))
    };
    let all = all.into_iter().map(|(name, parts)| {
        let mut hand_in = of_one(name, platform, named, parts);
        if may_be_later(&hand_in) {
            let why = "it may be a later upload by the same person as another submission; of a person's \
                       uploads, only the newest is graded";
            hand_in.doubts.push(why.into());
        }
        hand_in
    });
    (all.collect(), ignored)
}

/// What one person handed in, in one or several uploads. Of several archives, only the newest
/// counts.
fn of_one(
    name: String,
    platform: Option<Platform>,
    named: &NamePattern,
    parts: Vec<(String, Vec<FoundFile>)>,
) -> HandIn {
    let order = |top: &str| reading(top, platform, named).map_or(0, |it| it.upload);
    let archives = parts.iter().map(|(top, _)| top);
    let newest = archives
        .filter(|top| file_names::is_archive(top))
        .map(|top| order(top))
        .max();
    let (signs, at_most) = signs(&parts[0].0, platform, named);
    let mut hand_in = HandIn {
        signs,
        at_most,
        doubts: Vec::new(),
        name,
        given: Vec::new(),
        platform,
        uploads: Vec::new(),
        superseded: Vec::new(),
    };
    let mut readings = parts
        .iter()
        .flat_map(|(top, _)| named.readings(top, platform));
    if readings.any(|it| it.has_several_times) {
        let why = "its name contains several times, so it may hold several submissions of a person, or \
                   not be this person's last one";
        hand_in.doubts.push(why.into());
    }
    for (top, found) in parts {
        let order = order(&top);
        if file_names::is_archive(&top) && newest.is_some_and(|newest| order < newest) {
            hand_in.superseded.push(top);
            continue;
        }
        hand_in.given.push(top.clone());
        let rest = reading(&top, platform, named).map_or(top.clone(), |it| it.rest.into());
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
