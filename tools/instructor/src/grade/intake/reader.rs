//! Reads a folder or an archive: the text of every file whose name may be an answer's, and the
//! names of all other files. Archives inside count as folders.
//!
//! Everything is read once, before anything is judged. So a submission can't change afterwards, and
//! all files are known when they are matched with people.

pub mod file_names;
mod folder;
mod limits;
mod tarball;
mod unpack;
mod zip_file;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::rc::Rc;

use self::file_names::{is_archive, is_skipped};
use self::limits::Limits;
pub use self::unpack::utf_16;
use super::names::{self, Platform};
use super::pattern::NamePattern;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::submission::AnswerFileProblem;
use pinhole_course::submission::text::{self, Text};

/// A file that was found, or a folder or an archive at the top.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundFile {
    /// Its path: folders and archives, and then its name.
    pub path: Vec<String>,
    pub content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A folder or an archive at the top, which may be empty.
    Folder,
    /// A file whose name may be an answer's.
    Answer {
        text: Text,
        /// What had to be done to read it.
        note: Option<&'static str>,
    },
    /// A folder or an archive that is not accepted, and why.
    Refused(String),
    /// Something that the machine cannot read, and why.
    Unreadable(String),
    Other,
}

/// How many other files are listed.
const MOST_OTHERS: usize = 20;

/// How deep folders may be nested in folders.
const MOST_FOLDERS: usize = 40;

/// The longest path in an archive, as on Linux, and how many parts it may have.
const MOST_NAME: usize = 4096;
const MOST_PARTS: usize = 100;

/// Everything in a folder or an archive.
pub struct Found {
    pub files: Vec<FoundFile>,
    pub is_archive: bool,
    /// Whether it is an archive with a single folder around everything.
    pub is_wrapped: bool,
}

/// Reads everything in a folder or an archive. `is_answer` recognises the names of answer files, and
/// `named` says how submissions are named.
/// Neither follows a link nor waits for another process.
///
/// # Errors
/// If it can't be read, or is neither a folder nor a regular file, or if it contains too much.
pub fn read(path: &Path, is_answer: &dyn Fn(&str) -> bool, named: &NamePattern) -> Result<Found> {
    let unreadable = text::unreadable(path);
    let is_archive = !path.symlink_metadata().or_fail(&unreadable)?.is_dir();
    let mut reader = Reader::new(is_answer, named);
    match is_archive {
        false => folder::read(&mut reader, path).or_fail(&unreadable)?,
        true => {
            let file = text::open(path).or_fail(&unreadable)?;
            let metadata = file.metadata().or_fail(&unreadable)?;
            if !metadata.is_file() {
                return Err(Error::input(
                    format!("{} is neither a folder nor a regular file", path.display()),
                    "name a submission, or a folder of submissions",
                ));
            }
            reader.whole = Rc::new(Limits::of_archive(metadata.len()));
            reader.whole.start_clock();
            reader.archive(file, &[], 0);
        }
    }
    match reader.whole.exceeded() {
        None => Ok(Found {
            files: reader.found,
            is_archive,
            is_wrapped: reader.is_wrapped,
        }),
        // What comes later must not be taken for all that its author handed in.
        Some(why) => {
            let each = reader.of_each.iter().filter(|(path, _)| !path.is_empty());
            let over = each.filter(|(_, one)| one.limits.exceeded().is_some());
            let over: Vec<String> = over.map(|(path, _)| path.join("/")).collect();
            let error = Error::input(
                format!("{} cannot be read as a whole: {why}", path.display()),
                "if it is a class, grade those apart who handed in too much; of an archive, unpack it \
                 and pass the folder, with another --out if the class has been graded before",
            );
            Err(match &over[..] {
                [] => error,
                over => error.because(format!(
                    "too much is in {}",
                    file_names::quoted(over).join(", ")
                )),
            })
        }
    }
}

struct Reader<'a> {
    is_answer: &'a dyn Fn(&str) -> bool,
    named: &'a NamePattern,
    found: Vec<FoundFile>,
    /// What may still be read of each submission, by the path of its account.
    of_each: BTreeMap<Vec<String>, SubmissionReadBudget>,
    /// The path of the submission that was read last, and of its account.
    last: (Vec<String>, Vec<String>),
    /// What may still be read of everything.
    whole: Rc<Limits>,
    /// Of what only a part was read, because a limit was exceeded.
    stopped: BTreeSet<Vec<String>>,
    /// Whether there is a single folder around everything.
    is_wrapped: bool,
    /// The platform that has exported everything, if one did.
    platform: Option<Platform>,
}

/// The names at the top and, as long as there is only one, the names inside it.
#[derive(Default)]
struct TopNames {
    tops: BTreeSet<String>,
    inside: BTreeSet<Option<String>>,
}

/// Longer names are not a platform's: each of two parts may have 255 characters of four bytes.
const LONGEST_NAME: usize = 2300;

impl TopNames {
    /// Adds the names in the path of a file, or the name of anything at the top. Returns how many
    /// bytes they take.
    fn add(&mut self, path: &str) -> u64 {
        let cut = |name: &str| name[..name.floor_char_boundary(LONGEST_NAME)].to_owned();
        let parts: Vec<String> = path.splitn(3, '/').map(cut).collect();
        if is_skipped(&parts, 0) {
            return 0;
        }
        let mut parts = parts.into_iter();
        let (top, inside) = (parts.next().unwrap_or_default(), parts.next());
        let cost = 64 + top.len() + inside.as_ref().map_or(0, String::len);
        let mut is_new = self.tops.insert(top);
        match self.tops.len() {
            1 => is_new |= self.inside.insert(inside),
            _ => self.inside.clear(),
        }
        if is_new { cost as u64 } else { 0 }
    }
}

/// How much was read of one submission.
struct SubmissionReadBudget {
    limits: Rc<Limits>,
    others: usize,
}

impl<'a> Reader<'a> {
    fn new(is_answer: &'a dyn Fn(&str) -> bool, named: &'a NamePattern) -> Reader<'a> {
        Reader {
            is_answer,
            named,
            found: Vec::new(),
            of_each: BTreeMap::new(),
            last: Default::default(),
            whole: Rc::new(Limits::of_folder(0)),
            stopped: BTreeSet::new(),
            is_wrapped: false,
            platform: None,
        }
    }

    /// Finds out how submissions are named. Otherwise, somebody who hands in many archives could have
    /// each of them read as far as a whole submission.
    fn name_submissions(&mut self, names: TopNames) {
        self.is_wrapped = names.tops.len() == 1 && !names.inside.contains(&None);
        self.platform = match self.is_wrapped {
            true => self.named.exported_by(names.inside.iter().flatten()),
            false => self.named.exported_by(names.tops.iter()),
        };
    }

    /// How many parts of a path distinguish submissions.
    fn length_of_own(&self, path: &[String]) -> usize {
        path.len().min(1 + usize::from(self.is_wrapped))
    }

    fn of_one(&mut self, path: &[String]) -> &mut SubmissionReadBudget {
        let own = &path[..self.length_of_own(path)];
        if self.last.0 != own {
            let mut account = own.to_vec();
            if let Some(name) = account.last_mut().filter(|it| it.len() <= LONGEST_NAME) {
                *name = names::account(name, &self.named.readings(name, self.platform));
            }
            self.last = (own.to_vec(), account);
        }
        let own = self.last.1.clone();
        let whole = self.whole.clone();
        self.of_each
            .entry(own)
            .or_insert_with_key(|own| SubmissionReadBudget {
                limits: match own.is_empty() {
                    true => whole,
                    false => {
                        // The path is stored in several places. If it takes too much, the next file
                        // ends the reading.
                        let length: usize = own.iter().map(String::len).sum();
                        let _ = whole.spend(|it| &it.kept, 512 + 4 * length as u64);
                        Rc::new(Limits::of_one(Some(whole)))
                    }
                },
                others: 0,
            })
    }

    fn limits(&mut self, path: &[String]) -> Rc<Limits> {
        self.of_one(path).limits.clone()
    }

    fn keep(&mut self, path: &[String], content: Content) {
        let path = path.to_vec();
        let found = FoundFile { path, content };
        match self
            .limits(&found.path)
            .spend(|it| &it.kept, limits::cost(&found))
        {
            Ok(()) => self.found.push(found),
            Err(why) => self.stop(&found.path, why),
        }
    }

    /// Notes, once, that a submission is over a limit.
    fn stop(&mut self, path: &[String], why: &str) {
        let is_late = self.limits(path).is_late();
        let path = path[..self.length_of_own(path)].to_vec();
        if self.stopped.insert(path.clone()) {
            let is_shared = path
                .last()
                .is_some_and(|it| self.named.readings(it, self.platform).len() > 1);
            let content = match (is_shared, is_late) {
                (true, _) => Content::Unreadable(format!(
                    "together with uploads whose names begin alike, {why}"
                )),
                (_, true) => Content::Unreadable(why.into()),
                _ => Content::Refused(why.into()),
            };
            self.found.push(FoundFile { path, content });
        }
    }

    /// The path of a file in an archive, if the file is to be looked at.
    fn enter(&mut self, folder: &[String], name: &str) -> Option<Vec<String>> {
        if self.whole.exceeded().is_some() {
            return None;
        }
        let is_long = name.len() > MOST_NAME;
        let most = if is_long { LONGEST_NAME } else { MOST_NAME };
        let shown = &name[..name.floor_char_boundary(most)];
        let parts = shown.split('/').take(MOST_PARTS + 1).map(str::to_owned);
        let path: Vec<String> = folder.iter().cloned().chain(parts).collect();
        if name.is_empty() || is_skipped(&path, folder.len()) || !self.may_go_on(&path) {
            return None;
        }
        if path.len() > MOST_PARTS || is_long {
            self.stop(
                &path,
                "it contains files that are nested too deeply, or whose names are too long",
            );
            return None;
        }
        Some(path)
    }

    /// Lists a file in an archive whose name is not accepted. In the archive of a class, it keeps
    /// the part of its name that the platform gave. Any other archive is refused.
    fn refuse(
        &mut self,
        folder: &[String],
        depth: usize,
        name: &str,
        why: &str,
    ) -> std::result::Result<(), String> {
        let why = format!("{name:?} {why}");
        if depth > 0 {
            return Err(why);
        }
        let name = name.replace(['\\', '\0'], "_");
        let parts = name.split('/').filter(|it| !["", ".", ".."].contains(it));
        let name = parts.collect::<Vec<_>>().join("/");
        if let Some(path) = self.enter(folder, &name) {
            self.keep(&path, Content::Refused(why));
        }
        Ok(())
    }

    /// Whether another file may be looked at.
    fn may_go_on(&mut self, path: &[String]) -> bool {
        match self.limits(path).spend(|it| &it.files, 1) {
            Ok(()) => true,
            Err(why) => {
                self.stop(path, why);
                false
            }
        }
    }

    /// Whether the content of the file at this path matters.
    fn wants(&self, path: &[String]) -> bool {
        self.names_answer(path) || path.last().is_some_and(|name| is_archive(name))
    }

    fn names_answer(&self, path: &[String]) -> bool {
        path.last().is_some_and(|name| (self.is_answer)(name))
    }

    /// Notes a file whose content doesn't matter, or that is not regular.
    fn pass(&mut self, path: &[String], is_regular: bool) {
        if !is_regular && self.names_answer(path) {
            let why = AnswerFileProblem::Refused("it is not a regular file".into());
            let (text, note) = (Err(why), None);
            return self.keep(path, Content::Answer { text, note });
        }
        let one = self.of_one(path);
        one.others += 1;
        // Files at the top may belong to nobody, and are then all listed.
        if path.len() == 1 || one.others <= MOST_OTHERS {
            self.keep(path, Content::Other);
        }
    }
}
