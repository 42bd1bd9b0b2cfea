//! Writes the files that a person asks for: reports, films, pictures and archives.
//!
//! Each is written in one step, because a browser may reload it at any time, and two commands may
//! finish at once. Other users can't read it, because it may show goldens that students don't have.
//! If there is a link in its place, the link is replaced, because a student may have handed it in.

use std::fs::{self, File, Metadata};
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use crate::error::{Result, ResultExt};
use crate::link;
use crate::private::has_our_owner;

/// Writes a file, or replaces it. A pipe or a device is not replaced, but written to.
///
/// # Errors
/// If its folder is missing, can't be written, or is relative and leads through a link, or if another
/// user has made the pipe.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(mut pipe) = pipe(path)? {
        return pipe.write_all(bytes);
    }
    let folder = path.parent().filter(|it| !it.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    if folder.is_relative() {
        link::refuse(folder).map_err(io::Error::other)?;
    }
    let mut beside = NamedTempFile::new_in(folder)?;
    beside.write_all(bytes)?;
    beside.persist(path)?;
    Ok(())
}

/// Opens a pipe or a device, if there is one in this place. Follows only links that the system made,
/// as `/dev/stdout`, even if they lead to a file.
fn pipe(path: &Path) -> io::Result<Option<File>> {
    let is_of_system = path.starts_with("/dev") && !path.starts_with("/dev/shm");
    let is_ours = |about: io::Result<Metadata>| match is_of_system || has_our_owner(&about?) {
        true => Ok(()),
        false => Err(io::Error::other("another user has made this pipe")),
    };
    if !is_of_system {
        let about = path.symlink_metadata();
        let is_pipe = |it: &Metadata| !it.is_file() && !it.is_dir() && !it.is_symlink();
        if !about.as_ref().is_ok_and(is_pipe) {
            return Ok(None);
        }
        is_ours(about)?;
    }
    let mut options = File::options();
    options.write(true);
    // Another user may have put a link there meanwhile.
    #[cfg(unix)]
    if !is_of_system {
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, libc::O_NOFOLLOW);
    }
    let pipe = options.open(path)?;
    is_ours(pipe.metadata())?;
    Ok(Some(pipe))
}

/// Makes a folder for such files, if it is missing.
///
/// # Errors
/// If it is a link, or can't be made.
pub fn make_folder(folder: &Path) -> Result<()> {
    link::refuse(folder)?;
    fs::create_dir_all(folder).or_input(
        format_args!("cannot write to {}", folder.display()),
        "name a folder you may write to",
    )
}

/// Refuses a folder that is a link, or in which there is one.
///
/// # Errors
/// If there is a link.
pub fn refuse_links(folder: &Path) -> Result<()> {
    link::refuse(folder)?;
    let mut entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.try_for_each(|entry| link::refuse(&entry.path()))
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    #[test]
    fn nothing_is_written_through_a_link_and_nobody_else_can_read_it() {
        let folder = tempfile::tempdir().expect("there is room");
        let [victim, link] = ["victim", "link"].map(|name| folder.path().join(name));
        fs::write(&victim, "kept").expect("there is room");
        symlink(&victim, &link).expect("there is room");
        write(&link, b"new").expect("there is room");
        assert_eq!(fs::read(&victim).expect("it is there"), b"kept");
        assert_eq!(fs::read(&link).expect("it is there"), b"new");
        let mode = link.symlink_metadata().expect("it is there").permissions();
        assert_eq!(mode.mode() & 0o777, 0o600);
    }

    #[test]
    fn no_folder_is_written_through_a_link_however_its_name_ends() {
        let folder = tempfile::tempdir().expect("there is room");
        let [victim, link] = ["victim", "link"].map(|name| folder.path().join(name));
        make_folder(&victim.join("inside")).expect("there is room");
        symlink(&victim, &link).expect("there is room");
        for end in ["", "/", "/.", "//"] {
            let named = format!("{}{end}", link.display());
            let refused = make_folder(Path::new(&named)).expect_err("it is a link");
            assert!(refused.problem.contains("is a link"), "{refused}");
        }
        // The current folder may be a student's, but not the one that an absolute path names.
        let here = tempfile::tempdir_in(".").expect("there is room");
        let name = Path::new(here.path().file_name().expect("it has one"));
        symlink(&victim, here.path().join("link")).expect("there is room");
        make_folder(&name.join("link/new")).expect_err("it leads through a link");
        write(&name.join("link/new"), b"new").expect_err("it leads through a link");
        assert!(!victim.join("new").exists());
        make_folder(&folder.path().join("link/new")).expect("it was named in full");
        refuse_links(&victim).expect("it holds folders only");
        refuse_links(folder.path()).expect_err("it holds a link");
        refuse_links(&folder.path().join("absent")).expect("it will be made");
    }
}
