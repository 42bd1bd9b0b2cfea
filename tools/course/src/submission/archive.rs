//! A submission in a ZIP file. Only the answers are unpacked, and only into memory.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::rc::Rc;

use zip::ZipArchive;

use super::AnswerFileProblem;
use super::text::{self, MOST_BYTES, Text};
use crate::error::{Error, Result, ResultExt};

/// The length limit of a student's own archive.
const MOST_ARCHIVE_BYTES: u64 = 16 << 20;

/// The most bytes that are read of an archive to list its contents, and again to unpack a file,
/// unless it may contain more. We limit what we read instead of trusting the lengths that the
/// archive claims.
pub const MOST_READ: u64 = 16 << 20;

/// The bits of a Unix mode that hold the file type.
const FILE_TYPE: u32 = 0o170_000;
const REGULAR: u32 = 0o100_000;

/// A ZIP file whose list of contents makes sense.
pub struct Archive<R> {
    zip: ZipArchive<LimitedReader<R>>,
    left: Rc<Cell<u64>>,
    /// The index of each file, by its path, with `/` between its parts.
    files: BTreeMap<String, usize>,
    misplaced: Vec<(String, &'static str)>,
}

/// A reader that stops after a number of bytes.
struct LimitedReader<R> {
    inner: R,
    left: Rc<Cell<u64>>,
}

impl<R: Read> Read for LimitedReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let most = usize::try_from(self.left.get()).unwrap_or(usize::MAX);
        if most == 0 && !buffer.is_empty() {
            return Err(io::Error::other("there is too much to read"));
        }
        let end = buffer.len().min(most);
        let read = self.inner.read(&mut buffer[..end])?;
        self.left.set(self.left.get() - read as u64);
        Ok(read)
    }
}

impl<R: Seek> Seek for LimitedReader<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.inner.seek(to)
    }
}

/// Opens a student's own archive, named on the command line.
///
/// # Errors
/// As [`Archive::new`], or if a file appears twice or would be put outside the archive's own folder,
/// if it is too long, or if the machine cannot read it.
pub fn open(path: &Path) -> Result<Archive<Cursor<Vec<u8>>>> {
    let refused = Error::input(
        format!("{} is refused", path.display()),
        "pack only the answer files into a ZIP file, without a password",
    );
    // Read the whole file first, so that any later error is the archive's own fault.
    let unreadable = text::unreadable(path);
    let file = text::open(path).or_fail(&unreadable)?;
    if !file.metadata().or_fail(&unreadable)?.is_file() {
        return Err(refused.because("it is neither a folder nor a regular file"));
    }
    let mut bytes = Vec::new();
    file.take(MOST_ARCHIVE_BYTES + 1)
        .read_to_end(&mut bytes)
        .or_fail(&unreadable)?;
    if bytes.len() as u64 > MOST_ARCHIVE_BYTES {
        return Err(refused.because("it is larger than 16 MiB"));
    }
    let archive = match Archive::new(Cursor::new(bytes), MOST_READ) {
        Ok(archive) => archive,
        Err(why) => return Err(refused.because(why)),
    };
    match archive.misplaced().first() {
        Some((name, why)) => Err(refused.because(format!("{name:?} {why}"))),
        None => Ok(archive),
    }
}

/// The names that the list of contents, which starts at this byte, has more than once (APPNOTE.TXT,
/// "4.3.12 Central directory structure"). It ends where something else begins.
fn repeated_names(reader: &mut (impl Read + Seek), start: u64) -> BTreeSet<Vec<u8>> {
    const SIGNATURE: &[u8] = b"PK\x01\x02";
    let (mut all, mut repeated) = (BTreeSet::new(), BTreeSet::new());
    let mut header = [0; 46];
    let mut next = reader.seek(SeekFrom::Start(start));
    while next.is_ok() && reader.read_exact(&mut header).is_ok() && header.starts_with(SIGNATURE) {
        let length = |at: usize| u16::from_le_bytes([header[at], header[at + 1]]);
        let mut name = vec![0; length(28).into()];
        if reader.read_exact(&mut name).is_err() {
            break;
        }
        if !all.insert(name.clone()) {
            repeated.insert(name);
        }
        next = reader.seek(SeekFrom::Current(
            i64::from(length(30)) + i64::from(length(32)),
        ));
    }
    repeated
}

/// A file's name for people to read, from its bytes and from the library's reading of them. The library
/// follows the format's specification (APPNOTE 6.3.10, appendix D): without a flag, a name is in code page
/// 437, as Windows writes it. But other systems write UTF-8 without the flag.
fn shown(raw: &[u8], read: Option<&str>) -> String {
    let is_plain = std::str::from_utf8(raw).is_ok();
    match read.filter(|read| !is_plain && !read.contains(char::REPLACEMENT_CHARACTER)) {
        Some(read) => text::name(read.as_bytes()),
        None => text::name(raw),
    }
}

impl<R: Read + Seek> Archive<R> {
    /// Reads the list of contents, of which no more than this many bytes are read.
    ///
    /// Fails if the archive is not a ZIP file, or holds too much. The text says why.
    pub fn new(mut inner: R, most_read: u64) -> std::result::Result<Archive<R>, String> {
        if matches!(inner.seek(SeekFrom::End(0)), Ok(0)) {
            return Err("it is empty".into());
        }
        let left = Rc::new(Cell::new(most_read));
        let metered = LimitedReader {
            inner,
            left: left.clone(),
        };
        let open = |reader| {
            ZipArchive::new(reader)
                .map_err(|error| format!("it is damaged, or not a ZIP file ({error})"))
        };
        let mut zip = open(metered)?;
        // The end of a broken download of a class may be somebody's upload that looks like a class.
        if zip.offset() != 0 {
            return Err(
                "something else comes before it; download it again, or pack it again".into(),
            );
        }
        let (mut files, mut misplaced) = (BTreeMap::new(), Vec::new());
        if zip.has_duplicate_names() {
            // The library tells nothing more about them, and keeps only one file of each name.
            let start = zip.central_directory_start();
            let mut reader = zip.into_inner();
            left.set(most_read);
            let repeated = repeated_names(&mut reader, start);
            if repeated.is_empty() {
                return Err("it holds two files with the same name".into());
            }
            // A folder may be listed twice.
            for name in repeated.iter().filter(|name| !name.ends_with(b"/")) {
                misplaced.push((text::name(name), "appears twice"));
            }
            left.set(most_read);
            zip = open(reader)?;
        }
        left.set(most_read);
        for index in 0..zip.len() {
            let entry = zip
                .by_index_raw(index)
                .map_err(|error| format!("its contents make no sense ({error})"))?;
            let name = shown(entry.name_raw(), entry.name().ok().as_deref());
            let path = match plain_path(&name) {
                Ok(path) => path,
                Err(why) => {
                    misplaced.push((name, why));
                    continue;
                }
            };
            if !entry.is_dir() && files.insert(path, index).is_some() {
                misplaced.push((name, "appears twice"));
            }
        }
        Ok(Archive {
            zip,
            left,
            files,
            misplaced,
        })
    }

    /// The names that are not accepted, because they appear twice or would put a file outside the
    /// archive's own folder, and what is wrong with each.
    pub fn misplaced(&self) -> &[(String, &'static str)] {
        &self.misplaced
    }

    /// The paths of all files.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// The folders in which answers may be, each with `/` at its end: at the top, in `src`, or in
    /// the same two places of the only folder.
    pub fn places(&self) -> Vec<String> {
        let mut places = vec![String::new(), "src/".into()];
        let tops = self
            .files()
            .filter_map(|path| Some(path.split_once('/')?.0));
        let mut tops: Vec<&str> = tops.collect();
        tops.retain(|top| super::is_ordinary(top) && *top != "src");
        tops.dedup();
        if let [only] = tops[..] {
            places.push(format!("{only}/"));
            places.push(format!("{only}/src/"));
        }
        places
    }

    /// Whether there is a file with this path.
    pub fn holds(&self, path: &str) -> bool {
        self.files.contains_key(path)
    }

    /// The text of a file, or why there is none.
    pub fn text(&mut self, path: &str) -> Text {
        let alike = self
            .files()
            .filter(|other| other.to_lowercase() == path.to_lowercase());
        if alike.count() > 1 {
            let why = "there is another file whose name differs only in upper and lower case";
            return Err(AnswerFileProblem::Refused(why.into()));
        }
        let mut bytes = Vec::new();
        self.unpack(path, MOST_BYTES + 1, &mut bytes)?;
        text::of_bytes(bytes)
    }

    /// Unpacks the first `most` bytes of a file, ignoring the length that the archive claims.
    ///
    /// # Errors
    /// If it is missing, not a regular file, encrypted or damaged.
    pub fn unpack(
        &mut self,
        path: &str,
        most: u64,
        to: &mut dyn Write,
    ) -> std::result::Result<(), AnswerFileProblem> {
        let refused = |why: &str| AnswerFileProblem::Refused(why.into());
        let index = *self.files.get(path).ok_or(AnswerFileProblem::Missing)?;
        self.left.set(MOST_READ.max(2 * most));
        let raw = self.zip.by_index_raw(index);
        let raw = raw.map_err(|error| refused(&error.to_string()))?;
        if raw.encrypted() {
            return Err(refused("it is encrypted"));
        }
        let kind = raw.unix_mode().unwrap_or(0) & FILE_TYPE;
        if kind != 0 && kind != REGULAR {
            return Err(refused("it is not a regular file"));
        }
        drop(raw);
        let spoilt =
            |error: &dyn fmt::Display| refused(&format!("it cannot be unpacked ({error})"));
        let entry = self.zip.by_index(index).map_err(|error| spoilt(&error))?;
        io::copy(&mut entry.take(most), to).map_err(|error| spoilt(&error))?;
        Ok(())
    }
}

/// An entry's path with `/` between its parts, because some programs write `\`.
pub fn plain_path(name: &str) -> std::result::Result<String, &'static str> {
    if name.contains('\0') {
        return Err("has a NUL in its name");
    }
    if name.starts_with(['/', '\\']) || name.chars().nth(1) == Some(':') {
        return Err("has an absolute path");
    }
    let parts = name
        .split(['/', '\\'])
        .filter(|part| !part.is_empty() && *part != ".");
    let parts: Vec<&str> = parts.collect();
    match parts.contains(&"..") {
        true => Err("leads out of its folder"),
        false => Ok(parts.join("/")),
    }
}

#[cfg(test)]
mod tests;
