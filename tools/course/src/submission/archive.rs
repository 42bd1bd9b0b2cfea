//! A submission that comes as a ZIP file. Nothing is unpacked to disk, and only the answers
//! are unpacked at all.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::path::Path;

use zip::ZipArchive;

use super::Unusable;
use super::text::{self, MOST_BYTES, Text};
use crate::error::{Error, Result, ResultExt};

/// A longer archive holds more than answers.
const MOST_ARCHIVE_BYTES: u64 = 16 << 20;

/// An archive with more files is not a submission, and it would take long to read even their
/// names.
const MOST_ENTRIES: usize = 5000;

/// A file type in the upper bits of a mode, as Unix packs it.
const FILE_TYPE: u32 = 0o170_000;
const REGULAR: u32 = 0o100_000;

/// An archive whose list of contents makes sense.
pub struct Archive {
    zip: ZipArchive<Cursor<Vec<u8>>>,
    /// The index of each file, by its folders and name.
    files: BTreeMap<Vec<String>, usize>,
}

impl Archive {
    /// Reads the list of contents.
    ///
    /// # Errors
    /// If it is too long, or would put a file anywhere but below its own folder; or if the
    /// machine cannot read it.
    pub fn open(path: &Path) -> Result<Archive> {
        let refused = Error::input(
            format!("{} is refused", path.display()),
            "pack the answer files alone into a ZIP file, without a password",
        );
        // Read whole, so that what goes wrong later is the archive's own fault.
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
            return Err(refused.because("it is longer than 16 MiB"));
        }
        let mut zip = ZipArchive::new(Cursor::new(bytes))
            .map_err(|error| refused.because(format!("it is no ZIP file ({error})")))?;
        if zip.len() > MOST_ENTRIES {
            return Err(refused.because(format!("it holds more than {MOST_ENTRIES} files")));
        }
        if zip.has_duplicate_names() {
            return Err(refused.because("it holds two files of one name"));
        }
        let mut files = BTreeMap::new();
        for index in 0..zip.len() {
            let entry = zip.by_index_raw(index).map_err(|error| {
                refused.because(format!("its contents make no sense ({error})"))
            })?;
            let name = String::from_utf8_lossy(entry.name_raw()).into_owned();
            let place = place(&name).map_err(|why| refused.because(format!("{name:?} {why}")))?;
            if !entry.is_dir() && files.insert(place, index).is_some() {
                return Err(refused.because(format!("{name:?} is there twice")));
            }
        }
        Ok(Archive { zip, files })
    }

    /// The folders in which answers may lie: at the top, in `src`, or in the same two
    /// places of the only folder.
    pub fn places(&self) -> Vec<Vec<String>> {
        let src = "src".to_owned();
        let mut places = vec![vec![], vec![src.clone()]];
        let tops = self.files.keys().filter(|place| place.len() > 1);
        let mut tops: Vec<&String> = tops.map(|place| &place[0]).collect();
        tops.retain(|top| super::is_ordinary(top) && **top != src);
        tops.dedup();
        if let [only] = tops[..] {
            places.push(vec![only.clone()]);
            places.push(vec![only.clone(), src]);
        }
        places
    }

    /// Whether there is a file of this name.
    pub fn holds(&self, folder: &[String], name: &str) -> bool {
        self.files.contains_key(&within(folder, name))
    }

    /// The text of a file, or why there is none.
    pub fn text(&mut self, folder: &[String], name: &str) -> Text {
        let refused = |why: &str| Unusable::Refused(why.into());
        let wanted = within(folder, name);
        let is_alike = |other: &Vec<String>| {
            let alike = |(a, b): (&String, &String)| a.to_lowercase() == b.to_lowercase();
            other.len() == wanted.len() && other.iter().zip(&wanted).all(alike)
        };
        let alike = self.files.keys().filter(|other| is_alike(other)).count();
        let index = *self.files.get(&wanted).ok_or(Unusable::Missing)?;
        if alike > 1 {
            return Err(refused(
                "there is another whose name differs only in capitals",
            ));
        }
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
        let entry = self.zip.by_index(index);
        let entry = entry.map_err(|error| refused(&format!("it cannot be unpacked ({error})")))?;
        let mut bytes = Vec::new();
        // Whatever length the archive claims.
        let unpacked = entry.take(MOST_BYTES + 1).read_to_end(&mut bytes);
        unpacked.map_err(|error| refused(&format!("it cannot be unpacked ({error})")))?;
        text::of_bytes(bytes)
    }
}

fn within(folder: &[String], name: &str) -> Vec<String> {
    let mut place = folder.to_vec();
    place.push(name.to_owned());
    place
}

/// The folders and the name of an entry; some programs write `\` between them.
fn place(name: &str) -> std::result::Result<Vec<String>, &'static str> {
    if name.contains('\0') {
        return Err("has a NUL in its name");
    }
    if name.starts_with(['/', '\\']) || name.chars().nth(1) == Some(':') {
        return Err("has an absolute path");
    }
    let parts = name
        .split(['/', '\\'])
        .filter(|part| !part.is_empty() && *part != ".");
    let parts: Vec<String> = parts.map(str::to_owned).collect();
    match parts.iter().any(|part| part == "..") {
        true => Err("leads out of its folder"),
        false => Ok(parts),
    }
}

#[cfg(test)]
mod tests;
