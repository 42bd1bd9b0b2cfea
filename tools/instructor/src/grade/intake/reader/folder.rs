//! Reads a folder's files. A student may replace a folder with a link while we read it. So we open
//! each folder from its parent, which we hold open, and never follow a link.

use std::fs::File;
use std::io;
use std::path::Path;
use std::rc::Rc;

use pinhole_course::submission::text;

use super::file_names::{is_hidden, is_skipped};
use super::limits::Limits;
use super::unpack::UnreadFile;
use super::{Content, MOST_FOLDERS, Reader, TopNames};

/// Reads the folder at a path, which is not followed if it has become a link.
pub fn read(reader: &mut Reader, path: &Path) -> io::Result<()> {
    let folder = held::Folder::open(path)?;
    let mut names = TopNames::default();
    for (name, _) in folder.entries()? {
        names.add(&text::name(name.as_encoded_bytes()));
    }
    reader.whole = Rc::new(Limits::of_folder(names.tops.len() as u64));
    reader.name_submissions(names);
    walk(reader, &folder, &mut Vec::new())
}

fn walk(reader: &mut Reader, folder: &held::Folder, path: &mut Vec<String>) -> io::Result<()> {
    for (name, kind) in folder.entries()? {
        path.push(text::name(name.as_encoded_bytes()));
        if !is_skipped(path, 0) && reader.may_go_on(path) {
            let visited = visit(reader, folder, &name, kind, path);
            if let Err(error) = visited {
                let why = format!("{} cannot be read ({error})", path.join("/"));
                reader.keep(path, Content::Unreadable(why));
            }
        }
        path.pop();
    }
    Ok(())
}

fn visit(
    reader: &mut Reader,
    folder: &held::Folder,
    name: &std::ffi::OsStr,
    kind: held::Kind,
    path: &mut Vec<String>,
) -> io::Result<()> {
    match kind {
        held::Kind::Folder if path.len() == 1 && is_hidden(&path[0]) => {
            reader.keep(&[format!("{}/", path[0])], Content::Other);
        }
        held::Kind::Folder => {
            if path.len() == 1 {
                reader.keep(path, Content::Folder);
            }
            if path.len() > MOST_FOLDERS {
                reader.keep(
                    path,
                    Content::Refused("it is nested in too many folders".into()),
                );
                return Ok(());
            }
            match folder.folder(name)? {
                Some(inside) => walk(reader, &inside, path)?,
                None => reader.pass(path, false),
            }
        }
        held::Kind::File if reader.wants(path) => match folder.file(name)? {
            Some(file) => reader.file(path, 0, UnreadFile::File(file)),
            None => reader.pass(path, false),
        },
        held::Kind::File => reader.pass(path, true),
        held::Kind::Other => reader.pass(path, false),
    }
    Ok(())
}

/// The file, if it could be opened and is a regular file.
fn regular(file: File) -> io::Result<Option<File>> {
    let is_file = file.metadata()?.is_file();
    Ok(is_file.then_some(file))
}

#[cfg(unix)]
mod held {
    //! Folders by their descriptors.

    use std::ffi::{OsStr, OsString};
    use std::fs::File;
    use std::io;
    use std::os::fd::OwnedFd;
    use std::os::unix::ffi::OsStrExt;
    use std::path::Path;

    use rustix::fs::{AtFlags, CWD, Dir, FileType, Mode, OFlags, openat, statat};
    use rustix::io::Errno;

    /// What a name stands for.
    pub enum Kind {
        Folder,
        File,
        Other,
    }

    pub struct Folder(OwnedFd);

    const FOLDER: OFlags = OFlags::RDONLY
        .union(OFlags::DIRECTORY)
        .union(OFlags::NOFOLLOW)
        .union(OFlags::CLOEXEC);
    /// How files are opened: without following links, and without waiting for a writer.
    const FILE: OFlags = OFlags::RDONLY
        .union(OFlags::NOFOLLOW)
        .union(OFlags::NONBLOCK)
        .union(OFlags::CLOEXEC);

    impl Folder {
        pub fn open(path: &Path) -> io::Result<Folder> {
            Ok(Folder(openat(CWD, path, FOLDER, Mode::empty())?))
        }

        /// The names in it, sorted, with what each stands for.
        pub fn entries(&self) -> io::Result<Vec<(OsString, Kind)>> {
            let mut entries = Vec::new();
            for entry in Dir::read_from(&self.0)? {
                let entry = entry?;
                let name = OsStr::from_bytes(entry.file_name().to_bytes());
                if name == "." || name == ".." {
                    continue;
                }
                let kind = match statat(&self.0, name, AtFlags::SYMLINK_NOFOLLOW) {
                    Ok(status) => FileType::from_raw_mode(status.st_mode),
                    Err(Errno::NOENT) => continue,
                    Err(error) => return Err(error.into()),
                };
                let kind = match kind {
                    FileType::Directory => Kind::Folder,
                    FileType::RegularFile => Kind::File,
                    _ => Kind::Other,
                };
                entries.push((name.to_owned(), kind));
            }
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            Ok(entries)
        }

        /// A folder in it; `None` if it has been replaced.
        pub fn folder(&self, name: &OsStr) -> io::Result<Option<Folder>> {
            let opened = openat(&self.0, name, FOLDER, Mode::empty());
            Ok(still(opened)?.map(Folder))
        }

        /// A file in it; `None` if it has been replaced.
        pub fn file(&self, name: &OsStr) -> io::Result<Option<File>> {
            match still(openat(&self.0, name, FILE, Mode::empty()))? {
                Some(file) => super::regular(file.into()),
                None => Ok(None),
            }
        }
    }

    fn still(opened: rustix::io::Result<OwnedFd>) -> io::Result<Option<OwnedFd>> {
        match opened {
            Ok(opened) => Ok(Some(opened)),
            Err(Errno::LOOP | Errno::NOTDIR | Errno::NOENT) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }
}

#[cfg(not(unix))]
mod held {
    //! Folders by their paths, for systems without a sandbox. All code and folders there are the
    //! user's own.

    use std::ffi::{OsStr, OsString};
    use std::fs::{self, File};
    use std::io;
    use std::path::{Path, PathBuf};

    /// What a name stands for.
    pub enum Kind {
        Folder,
        File,
        Other,
    }

    pub struct Folder(PathBuf);

    impl Folder {
        pub fn open(path: &Path) -> io::Result<Folder> {
            Ok(Folder(path.into()))
        }

        /// The names in it, sorted, with what each stands for.
        pub fn entries(&self) -> io::Result<Vec<(OsString, Kind)>> {
            let mut entries = Vec::new();
            for entry in fs::read_dir(&self.0)? {
                let entry = entry?;
                let kind = entry.file_type()?;
                let kind = match (kind.is_dir(), kind.is_file()) {
                    (true, _) => Kind::Folder,
                    (_, true) => Kind::File,
                    _ => Kind::Other,
                };
                entries.push((entry.file_name(), kind));
            }
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            Ok(entries)
        }

        pub fn folder(&self, name: &OsStr) -> io::Result<Option<Folder>> {
            Ok(Some(Folder(self.0.join(name))))
        }

        pub fn file(&self, name: &OsStr) -> io::Result<Option<File>> {
            super::regular(File::open(self.0.join(name))?)
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::super::super::pattern::NamePattern;
    use super::*;

    #[test]
    fn folder_that_has_become_a_link_is_not_read() {
        let folder = tempfile::tempdir().expect("there is room");
        let [ada, mallory] = ["ada", "mallory"].map(|name| folder.path().join(name));
        std::fs::create_dir(&ada).expect("there is room");
        std::fs::write(ada.join("answer.rs"), "").expect("there is room");
        std::os::unix::fs::symlink(&ada, &mallory).expect("there is room");
        let named = NamePattern::default();
        let mut reader = Reader::new(&|_| true, &named);
        assert!(read(&mut reader, &mallory).is_err());
        assert_eq!(reader.found, []);
        assert!(read(&mut reader, &ada).is_ok());
    }
}
