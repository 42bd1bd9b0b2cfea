//! The text of one file that somebody else has made.

use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

use super::Unusable;

/// An answer file longer than this is refused.
pub const MOST_BYTES: u64 = 256 * 1024;

/// Reads a file that is what it seems.
pub fn read(path: &Path) -> Result<String, Unusable> {
    let refused = |why: &str| Err(Unusable::Refused(why.into()));
    // `symlink_metadata` looks at the link itself: a link could lead anywhere.
    let metadata = std::fs::symlink_metadata(path).map_err(|_| Unusable::Missing)?;
    if !metadata.is_file() {
        return refused("it is not a regular file");
    }
    let file = match open(path) {
        Ok(file) => file,
        Err(error) => return refused(&error.to_string()),
    };
    // Once more, of what was opened: it may have been exchanged meanwhile.
    if !file.metadata().is_ok_and(|metadata| metadata.is_file()) {
        return refused("it is not a regular file");
    }
    let mut bytes = Vec::new();
    match file.take(MOST_BYTES + 1).read_to_end(&mut bytes) {
        Ok(_) => of_bytes(bytes),
        Err(error) => refused(&error.to_string()),
    }
}

/// Opens a file, but follows no link and waits for no writer.
pub fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(target_os = "linux")]
    std::os::unix::fs::OpenOptionsExt::custom_flags(
        &mut options,
        libc::O_NOFOLLOW | libc::O_NONBLOCK,
    );
    options.open(path)
}

/// Bytes as an answer's text.
pub fn of_bytes(bytes: Vec<u8>) -> Result<String, Unusable> {
    let refused = |why: &str| Err(Unusable::Refused(why.into()));
    if bytes.len() as u64 > MOST_BYTES {
        return refused("it is longer than 256 KiB");
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text),
        Err(_) => refused("it is not UTF-8 text"),
    }
}
