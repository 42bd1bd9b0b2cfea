//! Reads answers, and unpacks archives to find them.

use std::fs::File;
use std::io::{self, Read, Seek, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};

use super::file_names::is_opened;
use super::limits::{self, LimitedStream, Limits};
use super::{Content, Reader, tarball, zip_file};
use pinhole_course::submission::AnswerFileProblem;
use pinhole_course::submission::text::{self, MOST_BYTES, Text};

/// How deep archives may be nested in archives.
const MOST_ARCHIVES: usize = 3;

/// Why something was not read.
pub enum ReadFailure {
    /// It is the author's fault.
    Refused(String),
    /// It is the machine's.
    Unreadable(String),
}

/// A file that is not read yet.
pub enum UnreadFile<'a> {
    File(File),
    /// A function that writes as many of its first bytes as the caller asks for.
    Packed(&'a mut dyn FnMut(u64, &mut dyn Write) -> Result<(), ReadFailure>),
}

impl Reader<'_> {
    /// Reads a file whose content matters, `depth` archives deep.
    pub fn file(&mut self, path: &[String], depth: usize, unread: UnreadFile) {
        let limits = self.limits(path);
        if depth == 0 {
            limits.start_clock();
        }
        let content = match self.names_answer(path) {
            true => Some(self.answer(path, unread)),
            false => self.packed(path, depth, unread).err().map(Content::from),
        };
        if let Some(content) = content {
            self.keep(path, content);
        }
        if depth == 0 {
            limits.stop_clock();
        }
    }

    fn answer(&mut self, path: &[String], unread: UnreadFile) -> Content {
        let mut bytes = Vec::new();
        let (text, note) = match unread.copy(MOST_BYTES + 1, &mut bytes, self.limits(path)) {
            Ok(()) => decoded(bytes),
            Err(ReadFailure::Refused(why)) => (Err(AnswerFileProblem::Refused(why)), None),
            Err(trouble) => return trouble.into(),
        };
        Content::Answer { text, note }
    }

    fn packed(
        &mut self,
        path: &[String],
        depth: usize,
        unread: UnreadFile,
    ) -> Result<(), ReadFailure> {
        let name = path.last().map(String::as_str).unwrap_or_default();
        if !is_opened(name) {
            return Err(ReadFailure::Refused(
                "archives of this kind are not unpacked: ask for a ZIP file".into(),
            ));
        }
        if depth >= MOST_ARCHIVES {
            return Err(ReadFailure::Refused(
                "it is nested in too many archives".into(),
            ));
        }
        let file = match unread {
            UnreadFile::File(file) => file,
            packed => {
                let mut file = tempfile::tempfile().map_err(no_room)?;
                packed.copy(u64::MAX >> 1, &mut file, self.limits(path))?;
                file
            }
        };
        // It is listed in any case, because it may be empty.
        match path.len() {
            1 => self.keep(path, Content::Folder),
            _ => self.pass(path, true),
        }
        self.archive(file, path, depth + 1);
        Ok(())
    }

    /// Reads the files of an archive. Its format is recognised by its content and not by its
    /// name. An archive that is made to harm its reader must not end the grading of a class.
    pub fn archive(&mut self, file: File, path: &[String], depth: usize) {
        let opened = catch_unwind(AssertUnwindSafe(|| self.open(file, path, depth)));
        let trouble = match opened {
            Ok(Ok(())) => return,
            Ok(Err(trouble)) => trouble,
            Err(_) => ReadFailure::Unreadable(
                "the grader itself failed to read it; please report it".into(),
            ),
        };
        self.keep(path, trouble.into());
    }

    fn open(&mut self, mut file: File, path: &[String], depth: usize) -> Result<(), ReadFailure> {
        let mut start = Vec::new();
        file.rewind()
            .and_then(|()| (&mut file).take(512).read_to_end(&mut start))
            .and_then(|_| file.rewind())
            .map_err(|error| ReadFailure::Unreadable(format!("it cannot be read ({error})")))?;
        if start.starts_with(b"\x1f\x8b") || tarball::begins(&start) {
            return tarball::read(self, file, path, depth);
        }
        zip_file::read(self, file, path, depth)
    }
}

impl UnreadFile<'_> {
    fn copy(self, most: u64, to: &mut dyn Write, limits: Rc<Limits>) -> Result<(), ReadFailure> {
        let mut to = LimitedStream {
            inner: to,
            limits: limits.clone(),
            of: |it| &it.unpacked,
        };
        let copied = match self {
            UnreadFile::Packed(copy) => copy(most, &mut to),
            UnreadFile::File(file) => match io::copy(&mut file.take(most), &mut to) {
                Ok(_) => Ok(()),
                Err(error) => Err(ReadFailure::Unreadable(format!(
                    "it cannot be read ({error})"
                ))),
            },
        };
        copied.map_err(|trouble| match limits.is_late() {
            true => ReadFailure::Unreadable(limits::TOO_SLOW.into()),
            false => trouble,
        })
    }
}

impl From<ReadFailure> for Content {
    fn from(trouble: ReadFailure) -> Content {
        match trouble {
            ReadFailure::Refused(why) => Content::Refused(why),
            ReadFailure::Unreadable(why) => Content::Unreadable(why),
        }
    }
}

fn no_room(error: io::Error) -> ReadFailure {
    ReadFailure::Unreadable(format!("there is no room to unpack it ({error})"))
}

/// The encoding of text in UTF-16. Without a byte order mark, it is recognised by the zeros among
/// its first bytes, because half of an ASCII letter is zero.
pub fn utf_16(bytes: &[u8]) -> Option<&'static Encoding> {
    let has_zeros = |odd: usize| {
        let every_other = bytes.iter().skip(odd).step_by(2).take(64);
        let zeros = every_other.clone().filter(|it| **it == 0).count();
        4 * zeros > every_other.count()
    };
    match Encoding::for_bom(bytes) {
        Some((encoding, _)) => Some(encoding).filter(|it| *it != UTF_8),
        None if has_zeros(1) => Some(UTF_16LE),
        None if has_zeros(0) => Some(UTF_16BE),
        None => None,
    }
}

/// Text in UTF-8, as compilers read it. Text in UTF-16 is converted.
fn decoded(bytes: Vec<u8>) -> (Text, Option<&'static str>) {
    match utf_16(&bytes) {
        Some(encoding) if bytes.len() as u64 <= MOST_BYTES => {
            let (text, _, is_spoilt) = encoding.decode(&bytes);
            match is_spoilt {
                true => (text::of_bytes(bytes), None),
                false => (
                    Ok(text.into_owned()),
                    Some("was in UTF-16, and was converted to UTF-8"),
                ),
            }
        }
        _ => (text::of_bytes(bytes), None),
    }
}
