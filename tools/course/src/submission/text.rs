//! The text of one untrusted file.

use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

use super::AnswerFileProblem;
use crate::error::{Error, Result, ResultExt};

/// An answer's text, or why there is none.
pub type Text = std::result::Result<String, AnswerFileProblem>;

/// An answer file longer than this is refused.
pub const MOST_BYTES: u64 = 256 * 1024;

/// Reads a regular file.
///
/// # Errors
/// If there is a file, but this machine cannot read it.
pub fn read(path: &Path) -> Result<Text> {
    let refused = |why: &str| Ok(Err(AnswerFileProblem::Refused(why.into())));
    // `symlink_metadata` looks at the link itself, because a link could lead anywhere.
    let metadata = match std::fs::symlink_metadata(path) {
        Ok(metadata) => metadata,
        Err(error) if is_absent(&error) => return Ok(Err(AnswerFileProblem::Missing)),
        Err(error) => return Err(unreadable(path).because(error)),
    };
    if !metadata.is_file() {
        return refused("it is not a regular file");
    }
    let file = open(path).or_fail(&unreadable(path))?;
    // Check again after opening, because the file may have been replaced in the meantime.
    if !file.metadata().is_ok_and(|metadata| metadata.is_file()) {
        return refused("it is not a regular file");
    }
    let mut bytes = Vec::new();
    file.take(MOST_BYTES + 1)
        .read_to_end(&mut bytes)
        .or_fail(&unreadable(path))?;
    Ok(of_bytes(bytes))
}

/// Whether no file has this name.
fn is_absent(error: &io::Error) -> bool {
    use io::ErrorKind::{NotADirectory, NotFound};
    matches!(error.kind(), NotFound | NotADirectory)
}

/// The error for a file that exists but cannot be read.
pub fn unreadable(path: &Path) -> Error {
    Error::environment(
        format!("cannot read {}", path.display()),
        "make it readable for the user who runs Pinhole (chmod -R u+rX), and run the command again",
    )
}

/// Opens a file without following a link or waiting for a writer.
pub fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(
        &mut options,
        libc::O_NOFOLLOW | libc::O_NONBLOCK,
    );
    options.open(path)
}

/// A file's name for people to read. Different names look different, even if they are not UTF-8,
/// because bytes that are not UTF-8 are written as in URLs. So is a `%` that could be mistaken for
/// the beginning of such a byte, and a backtick, which would end a quoted name in a message.
pub fn name(bytes: &[u8]) -> String {
    let mut name = String::new();
    for chunk in bytes.utf8_chunks() {
        for (at, c) in chunk.valid().char_indices() {
            let next = chunk.valid().as_bytes()[at + 1..].iter().take(2);
            let is_code = c == '%' && next.filter(|byte| byte.is_ascii_hexdigit()).count() == 2;
            match is_code || c == '`' {
                true => name.push_str(&format!("%{:02X}", u32::from(c))),
                false => name.push(c),
            }
        }
        for byte in chunk.invalid() {
            name.push_str(&format!("%{byte:02X}"));
        }
    }
    name
}

/// Checks the bytes of an answer, and returns its text.
pub fn of_bytes(bytes: Vec<u8>) -> Text {
    let refused = |why: &str| Err(AnswerFileProblem::Refused(why.into()));
    if bytes.len() as u64 > MOST_BYTES {
        return refused("it is larger than 256 KiB");
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text),
        Err(_) => refused("it is not UTF-8 text"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn a_file_that_the_machine_cannot_read_is_an_error_and_not_a_zero() {
        // A regular file whose first byte cannot be read.
        let error = read(Path::new("/proc/self/mem")).unwrap_err();
        assert!(
            error.problem.contains("cannot read /proc/self/mem"),
            "{error}"
        );
        let absent = read(Path::new("/proc/self/nothing")).unwrap();
        assert_eq!(absent, Err(AnswerFileProblem::Missing));
        let below_a_file = read(Path::new("/proc/self/mem/x")).unwrap();
        assert_eq!(below_a_file, Err(AnswerFileProblem::Missing));
    }
}
