//! A `tar` archive, compressed by `gzip` or not, read from front to back.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, Write};
use std::rc::Rc;

use flate2::read::MultiGzDecoder;
use pinhole_course::submission::archive::plain_path;
use pinhole_course::submission::text;
use tar::{Archive, Entry, EntryType, GnuHeader};

use super::limits::{LimitedStream, Limits, TOO_SLOW};
use super::unpack::{ReadFailure, UnreadFile};
use super::{MOST_NAME, Reader, TopNames};

/// Whether a file begins as `tar` archives do.
pub fn begins(start: &[u8]) -> bool {
    start.get(257..262) == Some(b"ustar")
}

/// Reads the files that matter.
pub fn read(
    reader: &mut Reader,
    file: File,
    path: &[String],
    depth: usize,
) -> Result<(), ReadFailure> {
    let limits = reader.limits(path);
    walk(reader, file, path, depth).map_err(|why| match limits.is_late() {
        true => ReadFailure::Unreadable(TOO_SLOW.into()),
        false => ReadFailure::Refused(why),
    })
}

fn walk(reader: &mut Reader, mut file: File, path: &[String], depth: usize) -> Result<(), String> {
    let limits = reader.limits(path);
    if depth == 0 {
        let mut names = TopNames::default();
        let same = file.try_clone().map_err(make_no_sense)?;
        each(same, limits.clone(), |name, entry| {
            let path = plain_path(name).ok().filter(|_| is_file(entry));
            let cost = path.map_or(0, |path| names.add(&path));
            Ok(limits.spend(|it| &it.kept, cost)?)
        })?;
        reader.name_submissions(names);
        file.rewind().map_err(make_no_sense)?;
    }
    each(file, limits, |name, entry| {
        let inside = match plain_path(name) {
            Ok(inside) => inside,
            Err(why) => return reader.refuse(path, depth, name, why),
        };
        let Some(inside) = reader.enter(path, &inside) else {
            return Ok(());
        };
        if !is_file(entry) || !reader.wants(&inside) {
            reader.pass(&inside, is_file(entry));
            return Ok(());
        }
        let mut copy = |most: u64, to: &mut dyn Write| {
            let copied = io::copy(&mut entry.take(most), to);
            copied
                .map(drop)
                .map_err(|error| ReadFailure::Refused(make_no_sense(error)))
        };
        reader.file(&inside, depth, UnreadFile::Packed(&mut copy));
        Ok(())
    })
}

fn make_no_sense(error: io::Error) -> String {
    format!("its contents make no sense ({error})")
}

type TarEntry<'a> = Entry<'a, Box<dyn Read>>;

fn is_file(entry: &TarEntry) -> bool {
    entry.header().entry_type().is_file()
}

/// Calls a function with the name and the content of everything in the archive but folders.
fn each(
    file: File,
    limits: Rc<Limits>,
    mut visit: impl FnMut(&str, &mut TarEntry) -> Result<(), String>,
) -> Result<(), String> {
    let limited = |inner: Box<dyn Read>| LimitedStream {
        inner,
        limits: limits.clone(),
        of: |it| &it.passed,
    };
    // Compressed bytes count too, because they may unpack to nothing.
    let mut file = BufReader::new(limited(Box::new(file)));
    let start = io::BufRead::fill_buf(&mut file).map_err(|error| error.to_string())?;
    let unpacked: Box<dyn Read> = match start.starts_with(b"\x1f\x8b") {
        true => Box::new(limited(Box::new(MultiGzDecoder::new(file)))),
        false => Box::new(file),
    };
    let mut archive = Archive::new(unpacked);
    let entries = archive.entries().map_err(make_no_sense)?;
    let (mut long_name, mut long_size): (Option<Vec<u8>>, Option<Vec<u8>>) = (None, None);
    // Read raw entries; otherwise a name of any length would be read into memory.
    for entry in entries.raw(true) {
        let mut entry = entry.map_err(make_no_sense)?;
        let kind = entry.header().entry_type();
        if kind == EntryType::GNULongName || kind == EntryType::XHeader {
            if entry.size() > MOST_HEADER {
                return Err("a header in it is too long; pack it again, as a ZIP file".into());
            }
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).map_err(make_no_sense)?;
            match kind {
                EntryType::GNULongName => {
                    bytes.truncate(bytes.iter().take_while(|byte| **byte != 0).count());
                    long_name = Some(bytes);
                }
                _ => {
                    long_name = record(b"path", &bytes)?.or(long_name);
                    long_size = record(b"size", &bytes)?.or(long_size);
                }
            }
            continue;
        }
        if kind == EntryType::GNULongLink {
            continue;
        }
        // Its list of holes may go on where the reader expects the content.
        if entry.header().as_gnu().is_some_and(GnuHeader::is_extended) && kind.is_gnu_sparse() {
            return Err("it holds a sparse file with many holes; pack it without -S".into());
        }
        // If a file has 8 GiB or more, its header doesn't say so.
        if long_size
            .take()
            .is_some_and(|it| it != entry.size().to_string().as_bytes())
        {
            return Err("it holds a file of 8 GiB or more; pack it without that file".into());
        }
        let name = long_name.take();
        let mut name = name.unwrap_or_else(|| entry.path_bytes().into_owned());
        name.truncate(MOST_NAME + 1);
        if !kind.is_dir() && kind != EntryType::XGlobalHeader {
            visit(&text::name(&name), &mut entry)?;
        }
    }
    // Two empty blocks end an archive, and the library reads only one. Otherwise, a class that was cut
    // between two files would look complete, and so would the first of two archives in one file.
    let mut rest = Vec::new();
    let read = archive.into_inner().take(MOST_REST).read_to_end(&mut rest);
    match rest.iter().any(|byte| *byte != 0) {
        true => Err("something else comes after its end; pack it again".into()),
        false if rest.is_empty() => Err(match read {
            Ok(_) => "it ends too early; download it again, or pack it again".into(),
            Err(error) => make_no_sense(error),
        }),
        false => Ok(()),
    }
}

/// The most bytes of an extended header. Apart from names, it holds what the system knows of a file.
const MOST_HEADER: u64 = 1 << 20;

/// How many bytes after the end of an archive are read. Programs fill the last record, which usually
/// has 10 KiB, with zeros.
const MOST_REST: u64 = 1 << 20;

/// The last value of a key in an extended header, which has records like `17 path=ada/a.rs\n`
/// (POSIX.1-2008, pax, "pax Header Block"). A name may contain line breaks, so only the length says
/// where a record ends.
fn record(key: &[u8], mut bytes: &[u8]) -> Result<Option<Vec<u8>>, String> {
    let mut value = None;
    while let Some(space) = bytes.iter().position(|byte| *byte == b' ') {
        let length = std::str::from_utf8(&bytes[..space]).ok();
        let length = length.and_then(|it| it.parse().ok()).unwrap_or(0);
        let (record, rest) = bytes.split_at(bytes.len().min(length));
        let Some(record) = record.get(space + 1..) else {
            return Err("its contents make no sense (in an extended header)".into());
        };
        let after = record.strip_prefix(key);
        if let Some(found) = after.and_then(|it| it.strip_prefix(b"=")) {
            value = Some(found.strip_suffix(b"\n").unwrap_or(found).to_owned());
        }
        bytes = rest;
    }
    Ok(value)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::super::super::pattern::NamePattern;
    use super::*;

    #[test]
    fn only_its_length_ends_a_record() {
        let own = |key: &str, value: &str| {
            let rest = format!(" {key}={value}\n");
            let length = (rest.len()..).find(|all| all.to_string().len() + rest.len() == *all);
            format!(
                "{}{rest}",
                length.expect("lengths grow faster than their digits")
            )
        };
        let name = |header: &str| {
            record(b"path", header.as_bytes()).map(|name| name.map(|it| text::name(&it)))
        };
        let named = |it: &str| Ok(Some(it.to_owned()));
        let forged = "eve/x\n22 path=ada/sphere.rs";
        let time = own("mtime", "1.5");
        assert_eq!(
            name(&format!("{time}{}", own("path", forged))),
            named(forged)
        );
        let last = own("path", "a") + &own("path", "b") + &time;
        assert_eq!(name(&last), named("b"));
        assert_eq!(name(&time), Ok(None));
        assert_eq!(name("12 path=eve"), named("eve"));
        for broken in ["x path=eve\n", "1 path=eve\n", " path=eve\n"] {
            assert!(name(broken).is_err());
        }
    }

    #[test]
    fn content_of_a_huge_file_is_not_taken_for_files() {
        let sized = |size: &str| {
            let mut tar = tar::Builder::new(Vec::new());
            let huge = [("size", size.as_bytes())];
            tar.append_pax_extensions(huge)
                .expect("memory can be written");
            let mut header = tar::Header::new_ustar();
            header.set_size(1);
            let added = tar.append_data(&mut header, "a", &b"a"[..]);
            added.expect("memory can be written");
            let mut file = tempfile::tempfile().expect("there is room");
            let written = file.write_all(&tar.into_inner().expect("it ends"));
            written.and_then(|()| file.rewind()).expect("there is room");
            read(
                &mut Reader::new(&|_| true, &NamePattern::default()),
                file,
                &[],
                0,
            )
        };
        assert!(sized("1").is_ok());
        let result = sized("8589934592");
        assert!(matches!(result, Err(ReadFailure::Refused(why)) if why.contains("8 GiB")));
    }

    #[test]
    fn a_name_after_long_records_is_read() {
        let named_after = |length: usize| {
            let mut tar = tar::Builder::new(Vec::new());
            let long = "x".repeat(length);
            let records = [("SCHILY.xattr.user.x", long.as_bytes()), ("path", b"ada")];
            let added = tar.append_pax_extensions(records);
            added.expect("memory can be written");
            let mut header = tar::Header::new_ustar();
            header.set_size(0);
            let added = tar.append_data(&mut header, "eve", &b""[..]);
            added.expect("memory can be written");
            let mut file = tempfile::tempfile().expect("there is room");
            let written = file.write_all(&tar.into_inner().expect("it ends"));
            written.and_then(|()| file.rewind()).expect("there is room");
            let mut names = Vec::new();
            let visit = |name: &str, _: &mut TarEntry| {
                names.push(name.to_owned());
                Ok(())
            };
            each(file, Rc::new(Limits::of_one(None)), visit).map(|()| names)
        };
        assert_eq!(named_after(10 * MOST_NAME), Ok(vec!["ada".into()]));
        assert!(named_after(1 << 20).is_err_and(|why| why.contains("too long")));
    }

    #[test]
    fn holes_of_a_sparse_file_are_not_taken_for_files() {
        let mut header = tar::Header::new_gnu();
        header.set_entry_type(EntryType::GNUSparse);
        header.set_size(0);
        header.as_gnu_mut().expect("it is new").isextended = [1];
        header.set_cksum();
        let mut file = tempfile::tempfile().expect("there is room");
        let written = file.write_all(&[&header.as_bytes()[..], &[0; 3 * 512]].concat());
        written.and_then(|()| file.rewind()).expect("there is room");
        let result = read(
            &mut Reader::new(&|_| true, &NamePattern::default()),
            file,
            &[],
            0,
        );
        assert!(matches!(result, Err(ReadFailure::Refused(why)) if why.contains("sparse")));
    }

    #[test]
    fn clock_ends_the_reading_of_an_archive_that_unpacks_to_nothing() {
        let empty = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        let empty = empty.finish().expect("memory can be written");
        let length = 1000 * empty.len() as u64;
        let read = |time| {
            let mut file = tempfile::tempfile().expect("there is room");
            let written = file.write_all(&empty.repeat(1000));
            written.and_then(|()| file.rewind()).expect("there is room");
            // Both share a position.
            let mut same = file.try_clone().expect("it is open");
            let limits = Limits::of_one(None).with_time(time);
            limits.start_clock();
            let named = NamePattern::default();
            let mut reader = Reader::new(&|_| true, &named);
            reader.whole = Rc::new(limits);
            let result = super::read(&mut reader, file, &[], 0);
            (result, same.stream_position().expect("it is open"))
        };
        let (result, position) = read(Duration::from_secs(60));
        assert!(matches!(result, Err(ReadFailure::Refused(why)) if why.contains("ends too early")));
        assert_eq!(position, length);
        let (result, position) = read(Duration::ZERO);
        assert!(matches!(result, Err(ReadFailure::Unreadable(why)) if why == TOO_SLOW));
        assert!(position < length, "{position}");
    }
}
