//! Writes the files that a person asks for: reports, films and pictures.
//!
//! Each is written in one step, because a browser may reload it at any time, and two commands may
//! finish at once. Other users can't read it, because it may show goldens that students don't have.
//! If there is a link in its place, the link is replaced, because a student may have handed it in.

use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

/// Writes a file, or replaces it.
///
/// # Errors
/// If its folder is missing or can't be written.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = path.parent().filter(|it| !it.as_os_str().is_empty());
    let mut beside = NamedTempFile::new_in(folder.unwrap_or(Path::new(".")))?;
    beside.write_all(bytes)?;
    beside.persist(path)?;
    Ok(())
}

#[cfg(all(test, unix))]
#[test]
fn nothing_is_written_through_a_link_and_nobody_else_can_read_it() {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().expect("there is room");
    let [victim, link] = ["victim", "link"].map(|name| folder.path().join(name));
    fs::write(&victim, "kept").expect("there is room");
    std::os::unix::fs::symlink(&victim, &link).expect("there is room");
    write(&link, b"new").expect("there is room");
    assert_eq!(fs::read(&victim).expect("it is there"), b"kept");
    assert_eq!(fs::read(&link).expect("it is there"), b"new");
    let mode = link.symlink_metadata().expect("it is there").permissions();
    assert_eq!(mode.mode() & 0o777, 0o600);
}
