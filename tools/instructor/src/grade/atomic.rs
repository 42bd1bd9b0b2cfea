//! Writes files atomically: after a power cut, either the old file is there or the new one.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::private::new_private_file;

/// Writes a file atomically: beside its place, flushed to disk, then renamed.
pub fn write(path: &Path, content: &[u8]) -> Result<()> {
    write_beside(path, content)?;
    fs::rename(beside(path), path)
        .or_fail(&cannot_write(path))
        .and_then(|()| flush_folder(path))
}

/// Writes a new version beside a file, and flushes it to disk.
pub fn write_beside(path: &Path, content: &[u8]) -> Result<()> {
    let write = || {
        fs::create_dir_all(folder_of(path))?;
        let mut file = new_beside(path)?;
        file.write_all(content)?;
        file.sync_all()
    };
    write().or_fail(&cannot_write(path))
}

/// Makes what was renamed in a file's folder permanent.
#[cfg_attr(not(unix), expect(unused_variables))]
pub fn flush_folder(path: &Path) -> Result<()> {
    #[cfg(unix)]
    File::open(folder_of(path))
        .and_then(|folder| folder.sync_all())
        .or_fail(&cannot_write(path))?;
    Ok(())
}

/// Writes a file atomically, but without waiting for the disk. For files that can be made again.
pub fn write_unflushed(path: &Path, content: &[u8]) -> Result<()> {
    replace(path, |new| new.write_all(content)).or_fail(&cannot_write(path))
}

/// Puts a file in a second place, as a link, or as a copy where links don't work.
pub fn link(from: &Path, to: &Path) -> Result<()> {
    let _absent = fs::remove_file(to);
    let linked = fs::create_dir_all(folder_of(to)).and_then(|()| fs::hard_link(from, to));
    linked.or_else(|_| write_unflushed(to, &fs::read(from).or_fail(&cannot_write(to))?))
}

/// Calls `make` to write a new version beside a file, and then puts it in place.
pub fn replace(path: &Path, make: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    fs::create_dir_all(folder_of(path))?;
    make(&mut new_beside(path)?)?;
    fs::rename(beside(path), path)
}

/// A private file for a new version. A stopped run may have left one, or another user may have put one
/// there, to read and change what is written to it.
fn new_beside(path: &Path) -> io::Result<File> {
    let _absent = fs::remove_file(beside(path));
    new_private_file(&beside(path))
}

/// The path of a file's new version.
pub fn beside(path: &Path) -> PathBuf {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    beside.into()
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

pub fn cannot_write(path: &Path) -> Error {
    Error::environment(
        format!("cannot write {}", path.display()),
        "free some disk space, check that the folder can be written, and run this command again",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_version_is_written_to_no_file_that_was_there() {
        let folder = tempfile::tempdir().expect("there is room");
        let path = folder.path().join("grades.csv");
        for write in [write, write_unflushed] {
            fs::write(beside(&path), "").expect("there is room");
            let theirs = folder.path().join("theirs");
            let _first = fs::remove_file(&theirs);
            fs::hard_link(beside(&path), &theirs).expect("there is room");
            write(&path, b"marks").expect("there is room");
            assert_eq!(fs::read(&path).expect("it is there"), b"marks");
            assert_eq!(fs::read(&theirs).expect("it is there"), b"");
        }
    }
}
