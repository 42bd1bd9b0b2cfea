//! Reads a folder or an archive: the text of every file that may be an answer, judging by its
//! name, and the names of all other files. Archives inside count as folders.
//!
//! Everything is read once, before anything is judged. So a submission can't change during
//! grading, and all files are known when they are matched with people.

mod folder;
mod tarball;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read, Seek, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use encoding_rs::{Encoding, UTF_8};

use pinhole_course::error::{Result, ResultExt};
use pinhole_course::submission::Unusable;
use pinhole_course::submission::archive::Archive;
use pinhole_course::submission::text::{self, MOST_BYTES, Text};

/// A file that was found, or a folder or an archive at the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Its path: folders and archives, then its name.
    pub path: Vec<String>,
    pub content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A folder or an archive at the top, which may be empty.
    Folder,
    /// A file that may be an answer, judging by its name.
    Answer {
        text: Text,
        /// What was done to read it.
        note: Option<&'static str>,
    },
    /// A folder or an archive that is not accepted, and why.
    Refused(String),
    /// Something that the machine cannot read, and why.
    Unreadable(String),
    Other,
}

/// Why something was not read.
enum Trouble {
    /// It is the author's fault.
    Refused(String),
    /// It is the machine's.
    Unreadable(String),
}

/// A file that has not been read yet.
enum UnreadFile<'a> {
    File(File),
    /// A function that writes as many of its first bytes as the caller asks for.
    Packed(&'a mut dyn FnMut(u64, &mut dyn Write) -> std::result::Result<(), Trouble>),
}

/// The most bytes of answers that are read of one submission, and the most files that are
/// looked at.
const MOST_ANSWERS: u64 = 16 << 20;
const MOST_FILES: usize = 100_000;

/// How many other files are named.
const MOST_OTHERS: usize = 20;

/// How deep archives may be nested in archives, and folders in folders.
const MOST_ARCHIVES: usize = 3;
const MOST_FOLDERS: usize = 40;

/// A longer archive inside another is not unpacked.
const MOST_PACKED: u64 = 1 << 30;

/// Reads everything in a folder or an archive. `is_answer` tells whether a file name may be an
/// answer's.
///
/// # Errors
/// If there is nothing at that path.
pub fn read(path: &Path, is_answer: &dyn Fn(&str) -> bool) -> Result<Vec<Found>> {
    let mut reader = Reader {
        is_answer,
        found: Vec::new(),
        spent: BTreeMap::new(),
    };
    let metadata = path.metadata().or_input(
        format_args!("cannot read {}", path.display()),
        "name a submission, or a folder of submissions",
    )?;
    if metadata.is_dir() {
        folder::read(&mut reader, path).or_fail(&text::unreadable(path))?;
    } else {
        let file = File::open(path).or_fail(&text::unreadable(path))?;
        reader.archive(file, &[], 0);
    }
    Ok(reader.found)
}

struct Reader<'a> {
    is_answer: &'a dyn Fn(&str) -> bool,
    found: Vec<Found>,
    /// How much was read, by the name at the top.
    spent: BTreeMap<String, ReadCount>,
}

/// How much was read of one submission.
#[derive(Default)]
struct ReadCount {
    answers: u64,
    files: usize,
    others: usize,
}

impl Reader<'_> {
    fn keep(&mut self, path: &[String], content: Content) {
        let path = path.to_vec();
        self.found.push(Found { path, content });
    }

    fn spent(&mut self, path: &[String]) -> &mut ReadCount {
        let top = path.first().cloned().unwrap_or_default();
        self.spent.entry(top).or_default()
    }

    /// Whether another file may be looked at. If there are too many, that is reported once.
    fn may_go_on(&mut self, path: &[String]) -> bool {
        let spent = self.spent(path);
        spent.files += 1;
        if spent.files == MOST_FILES {
            let why = format!("it holds more than {MOST_FILES} files");
            self.keep(&path[..path.len().min(1)], Content::Refused(why));
        }
        self.spent(path).files < MOST_FILES
    }

    /// Whether the content of the file at this path matters.
    fn wants(&self, path: &[String]) -> bool {
        self.names_answer(path) || path.last().is_some_and(|name| is_archive(name))
    }

    fn names_answer(&self, path: &[String]) -> bool {
        path.last().is_some_and(|name| (self.is_answer)(name))
    }

    /// Records a file whose content doesn't matter, or that is not regular.
    fn pass(&mut self, path: &[String], is_regular: bool) {
        if !is_regular && self.names_answer(path) {
            let why = Unusable::Refused("it is not a regular file".into());
            let (text, note) = (Err(why), None);
            return self.keep(path, Content::Answer { text, note });
        }
        let spent = self.spent(path);
        spent.others += 1;
        // Files at the top may belong to nobody, and are then all listed.
        if path.len() == 1 || spent.others <= MOST_OTHERS {
            self.keep(path, Content::Other);
        }
    }

    /// Reads a file whose content matters, `depth` archives deep.
    fn file(&mut self, path: &[String], depth: usize, unread: UnreadFile) {
        let content = match self.names_answer(path) {
            true => self.answer(path, unread),
            false => match self.packed(path, depth, unread) {
                Ok(()) => return,
                Err(trouble) => trouble.into(),
            },
        };
        self.keep(path, content);
    }

    fn answer(&mut self, path: &[String], unread: UnreadFile) -> Content {
        let mut bytes = Vec::new();
        let text = match unread.copy(MOST_BYTES + 1, &mut bytes) {
            Ok(()) => decoded(bytes),
            Err(Trouble::Refused(why)) => (Err(Unusable::Refused(why)), None),
            Err(trouble) => return trouble.into(),
        };
        let spent = self.spent(path);
        spent.answers += text.0.as_ref().map_or(0, |text| text.len() as u64);
        if spent.answers > MOST_ANSWERS {
            return Content::Refused("it holds more answer files than anybody needs".into());
        }
        let (text, note) = text;
        Content::Answer { text, note }
    }

    fn packed(
        &mut self,
        path: &[String],
        depth: usize,
        unread: UnreadFile,
    ) -> std::result::Result<(), Trouble> {
        let name = path.last().map(String::as_str).unwrap_or_default();
        if !is_opened(name) {
            return Err(Trouble::Refused(
                "archives of this kind are not unpacked: ask for a ZIP file".into(),
            ));
        }
        if depth >= MOST_ARCHIVES {
            return Err(Trouble::Refused("it is nested in too many archives".into()));
        }
        let file = match unread {
            UnreadFile::File(file) => file,
            packed => {
                let mut file = tempfile::tempfile().map_err(no_room)?;
                packed.copy(MOST_PACKED + 1, &mut file)?;
                if file.metadata().map_err(no_room)?.len() > MOST_PACKED {
                    return Err(Trouble::Refused("it is longer than 1 GiB".into()));
                }
                file
            }
        };
        if path.len() == 1 {
            self.keep(path, Content::Folder);
        }
        self.archive(file, path, depth + 1);
        Ok(())
    }

    /// Reads the files of an archive. Its format is recognised by its content and not by its
    /// name. An archive that is made to harm its reader must not end the grading of a class.
    fn archive(&mut self, file: File, path: &[String], depth: usize) {
        let opened = catch_unwind(AssertUnwindSafe(|| self.open(file, path, depth)));
        let trouble = match opened {
            Ok(Ok(())) => return,
            Ok(Err(trouble)) => trouble,
            Err(_) => {
                Trouble::Unreadable("the grader itself failed to read it; please report it".into())
            }
        };
        self.keep(path, trouble.into());
    }

    fn open(
        &mut self,
        mut file: File,
        path: &[String],
        depth: usize,
    ) -> std::result::Result<(), Trouble> {
        let unreadable =
            |error: io::Error| Trouble::Unreadable(format!("it cannot be read ({error})"));
        if !file.metadata().map_err(unreadable)?.is_file() {
            return Err(Trouble::Refused(
                "it is neither a folder nor a regular file".into(),
            ));
        }
        let mut start = Vec::new();
        file.rewind()
            .and_then(|()| (&mut file).take(512).read_to_end(&mut start))
            .and_then(|_| file.rewind())
            .map_err(unreadable)?;
        if start.starts_with(b"\x1f\x8b") || tarball::begins(&start) {
            return tarball::read(self, file, path, depth).map_err(Trouble::Refused);
        }
        let mut archive = Archive::new(file).map_err(Trouble::Refused)?;
        let files: Vec<String> = archive.files().map(str::to_owned).collect();
        for name in files {
            let inside = joined(path, &name);
            if is_skipped(&inside, path.len()) || !self.may_go_on(&inside) {
                continue;
            }
            if !self.wants(&inside) {
                self.pass(&inside, true);
                continue;
            }
            let mut copy = |most: u64, to: &mut dyn Write| {
                archive.unpack(&name, most, to).map_err(|why| match why {
                    Unusable::Refused(why) => Trouble::Refused(why),
                    Unusable::Missing => Trouble::Refused("it is not there".into()),
                })
            };
            self.file(&inside, depth, UnreadFile::Packed(&mut copy));
        }
        Ok(())
    }
}

impl UnreadFile<'_> {
    fn copy(self, most: u64, to: &mut dyn Write) -> std::result::Result<(), Trouble> {
        match self {
            UnreadFile::Packed(copy) => copy(most, to),
            UnreadFile::File(file) => match io::copy(&mut file.take(most), to) {
                Ok(_) => Ok(()),
                Err(error) => Err(Trouble::Unreadable(format!("it cannot be read ({error})"))),
            },
        }
    }
}

impl From<Trouble> for Content {
    fn from(trouble: Trouble) -> Content {
        match trouble {
            Trouble::Refused(why) => Content::Refused(why),
            Trouble::Unreadable(why) => Content::Unreadable(why),
        }
    }
}

fn no_room(error: io::Error) -> Trouble {
    Trouble::Unreadable(format!("there is no room to unpack it ({error})"))
}

fn joined(folder: &[String], path: &str) -> Vec<String> {
    let parts = path.split('/').map(str::to_owned);
    folder.iter().cloned().chain(parts).collect()
}

/// The ends of archives' names; only those in the first list are opened.
const OPENED: [&str; 4] = [".zip", ".tar", ".tgz", ".tar.gz"];
const CLOSED: [&str; 7] = [".rar", ".7z", ".xz", ".txz", ".bz2", ".zst", ".gz"];

fn ends(name: &str, ends: &[&str]) -> bool {
    let name = name.to_lowercase();
    ends.iter().any(|end| name.ends_with(end))
}

fn is_opened(name: &str) -> bool {
    ends(name, &OPENED)
}

/// Whether a name is an archive's.
pub fn is_archive(name: &str) -> bool {
    is_opened(name) || ends(name, &CLOSED)
}

/// A name without an archive's end.
pub fn stem(name: &str) -> &str {
    let mut found = OPENED.iter().filter(|end| ends(name, &[*end]));
    let end = found.next_back().map_or(0, |end| end.len());
    name.get(..name.len() - end).unwrap_or(name)
}

/// Whether a path, after its first `from` parts, goes through a folder made by a program: by
/// version control, a build, or the operating system. Such a folder holds no answers.
fn is_skipped(path: &[String], from: usize) -> bool {
    let is_inside = path.len() > 1;
    path[from.min(path.len())..]
        .iter()
        .any(|name| is_litter(name) || is_inside && (name.starts_with('.') || name == "target"))
}

/// Whether this is a file that operating systems leave in every folder.
fn is_litter(name: &str) -> bool {
    let litter = ["__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini"];
    litter.contains(&name) || name.starts_with("._")
}

/// Text in UTF-8, as compilers read it. Text in UTF-16 is converted if it begins with a byte
/// order mark.
fn decoded(bytes: Vec<u8>) -> (Text, Option<&'static str>) {
    match Encoding::for_bom(&bytes) {
        Some((encoding, _)) if encoding != UTF_8 && bytes.len() as u64 <= MOST_BYTES => {
            let (text, _, is_spoilt) = encoding.decode(&bytes);
            match is_spoilt {
                true => (text::of_bytes(bytes), None),
                false => (
                    Ok(text.into_owned()),
                    Some("was UTF-16, and was read as UTF-8"),
                ),
            }
        }
        _ => (text::of_bytes(bytes), None),
    }
}
