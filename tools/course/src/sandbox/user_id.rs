//! User ids for foreign code. No two runs on a machine share one, so that none can signal another
//! or use up its processes.
//!
//! A process owns an id while it holds the lock on the id's file in `/run/pinhole`. The kernel
//! releases the lock when the process ends, however it ends.

use std::ffi::OsStr;
use std::fs::{DirBuilder, File, OpenOptions, Permissions, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{DirBuilderExt, OpenOptionsExt, PermissionsExt};
use std::path::Path;
use std::sync::Arc;

use super::container::Scratch;
use super::tree;
use crate::error::{Error, Result, ResultExt};

/// One user id, reserved until its last clone is dropped.
#[derive(Clone, Debug)]
pub struct UserId {
    number: u32,
    _lock: Arc<Lock>,
}

/// The locked file of an id. It is empty unless the id is in use, or a grader that used it was
/// killed. Otherwise it names the folder where that grader keeps its files.
#[derive(Debug)]
struct Lock(File);

impl Drop for Lock {
    fn drop(&mut self) {
        let _taken_for_a_killed_graders = self.0.set_len(0);
    }
}

/// Ids that no distribution gives to people, services or containers. They are below 65536,
/// because some containers have no higher ids, and below 61184, where systemd's services begin.
const FIRST: u32 = 60_706;
const LAST: u32 = 61_183;

/// The folder of locks, for all graders of this machine. Only root may write there.
const LOCKS: &str = "/run/pinhole";

impl UserId {
    /// Reserves an id that nobody else has.
    ///
    /// # Errors
    /// If the locks can't be written, or all ids are taken.
    pub fn reserve() -> Result<UserId> {
        let files = std::env::temp_dir();
        UserId::reserve_in(Path::new(LOCKS), &files, FIRST..=LAST, |id, left| {
            // The code of a killed grader may still run, and code with this id could read its
            // files. All other processes belong to somebody else, such as a grader in a container
            // with its own `/run`.
            if let Some(files) = left {
                tree::end_all_of(id);
                Scratch::remove_left_behind(files);
            }
            !tree::is_used(id)
        })
    }

    /// Reserves the first id that is free. `is_free` also gets the folder of a killed grader that
    /// had the id.
    fn reserve_in(
        locks: &Path,
        files: &Path,
        mut ids: impl Iterator<Item = u32>,
        is_free: impl Fn(u32, Option<&Path>) -> bool,
    ) -> Result<UserId> {
        let failed = Error::environment(
            format!("cannot reserve a user id in {}", locks.display()),
            "let root write there (in Apptainer: --writable-tmpfs), because each submission runs \
             with a user id of its own",
        );
        let mut folder = DirBuilder::new();
        folder
            .mode(0o700)
            .recursive(true)
            .create(locks)
            .or_fail(&failed)?;
        std::fs::set_permissions(locks, Permissions::from_mode(0o700)).or_fail(&failed)?;
        ids.find_map(|number| lock(locks, files, number, &is_free).transpose())
            .transpose()
            .or_fail(&failed)?
            .ok_or_else(|| {
                Error::environment(
                    "all user ids for submissions are taken",
                    "wait until another grader on this machine has ended, or use fewer --jobs",
                )
            })
    }

    /// The id.
    pub fn number(&self) -> u32 {
        self.number
    }
}

/// Locks an id; `None` if another process has it, or it is not free.
fn lock(
    locks: &Path,
    files: &Path,
    number: u32,
    is_free: &impl Fn(u32, Option<&Path>) -> bool,
) -> io::Result<Option<UserId>> {
    // The file is closed in programs that we start, because otherwise they would hold the lock too.
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true);
    options.truncate(false).mode(0o600);
    let mut file = options.open(locks.join(number.to_string()))?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Ok(None),
        Err(TryLockError::Error(error)) => return Err(error),
    }
    let mut left = Vec::new();
    file.read_to_end(&mut left)?;
    let left = (!left.is_empty()).then(|| Path::new(OsStr::from_bytes(&left)));
    let mut lock = Lock(file);
    if !is_free(number, left) {
        return Ok(None);
    }
    lock.0.set_len(0)?;
    lock.0.rewind()?;
    lock.0.write_all(files.as_os_str().as_bytes())?;
    let _lock = Arc::new(lock);
    Ok(Some(UserId { number, _lock }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_is_given_to_one_holder_at_a_time_and_returned() {
        let folder = tempfile::tempdir().unwrap();
        let locks = folder.path().join("locks");
        let reserve = || UserId::reserve_in(&locks, Path::new("/tmp"), 7..=8, |_, _| true);
        let (first, second) = (reserve().unwrap(), reserve().unwrap());
        assert_eq!((first.number(), second.number()), (7, 8));
        let refused = reserve().unwrap_err();
        assert!(refused.problem.contains("taken"), "{refused}");
        let clone = first.clone();
        drop(first);
        assert!(reserve().is_err(), "a clone holds it");
        drop(clone);
        assert_eq!(reserve().unwrap().number(), 7);
    }

    #[test]
    fn only_what_a_killed_grader_left_is_ended() {
        let folder = tempfile::tempdir().unwrap();
        let left = std::cell::RefCell::new(None);
        let reserve = |used: u32| {
            UserId::reserve_in(folder.path(), Path::new("/tmp"), 7..=8, |id, files| {
                left.replace(Some((id, files.map(Path::to_owned))));
                id != used
            })
        };
        // Somebody else's process has the id 7.
        assert_eq!(reserve(7).unwrap().number(), 8);
        drop(reserve(0).unwrap());
        assert_eq!(left.take(), Some((7, None)));
        std::fs::write(folder.path().join("7"), "/somewhere/else").unwrap();
        let id = reserve(0).unwrap();
        assert_eq!(id.number(), 7);
        assert_eq!(left.take(), Some((7, Some("/somewhere/else".into()))));
        let files = std::fs::read_to_string(folder.path().join("7")).unwrap();
        assert_eq!(files, "/tmp");
    }

    #[test]
    fn a_lock_is_another_processs_too() {
        let folder = tempfile::tempdir().unwrap();
        let mut flock = std::process::Command::new("flock");
        flock.arg(folder.path().join("7")).args(["cat"]);
        let other = flock
            .stdin(std::process::Stdio::piped())
            .stdout(std::process::Stdio::piped());
        let mut other = other.spawn().expect("there is `flock`");
        // The other process holds the lock once `cat` answers.
        use io::{Read, Write};
        let mut stdin = other.stdin.take().unwrap();
        stdin.write_all(b"x").unwrap();
        other.stdout.take().unwrap().read_exact(&mut [0]).unwrap();
        let reserve = || UserId::reserve_in(folder.path(), Path::new("/tmp"), 7..=8, |_, _| true);
        let reserve = || reserve().unwrap().number();
        assert_eq!(reserve(), 8);
        drop(stdin);
        other.wait().unwrap();
        assert_eq!(reserve(), 7);
    }
}
