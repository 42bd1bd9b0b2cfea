//! Deletes the oldest programs. Every save of an answer makes one, so they would fill the disk.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use crate::private::private_file;

/// How many programs are kept, about a megabyte each. Undoing an edit then needs no new build.
const KEPT: usize = 200;

/// Programs younger than this are kept, because another command may still need them.
const YOUNG: Duration = Duration::from_secs(15 * 60);

/// Locks the folder of programs until the file is dropped. Meanwhile, no other command uses, adds
/// or deletes a program.
pub fn lock(programs: &Path) -> io::Result<fs::File> {
    fs::create_dir_all(programs)?;
    let file = private_file(&programs.join(".lock"))?;
    file.lock()?;
    Ok(file)
}

/// Marks a program as new, because it is about to be asked.
pub fn keep(program: &Path) {
    let opened = fs::File::open(program);
    // If this fails, the program is only deleted sooner.
    let _aged = opened.and_then(|folder| folder.set_modified(SystemTime::now()));
}

/// Removes the oldest programs of a folder that is locked.
pub fn prune(programs: &Path) {
    prune_to(programs, KEPT, YOUNG);
}

fn prune_to(programs: &Path, kept: usize, young: Duration) {
    let entries = fs::read_dir(programs).into_iter().flatten().flatten();
    let mut old: Vec<(SystemTime, PathBuf)> = entries
        .filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path())))
        .collect();
    old.sort();
    old.truncate(old.len().saturating_sub(kept));
    old.retain(|(made, _)| made.elapsed().is_ok_and(|age| age >= young));
    for (_, program) in old {
        // If this fails, the program just stays.
        let _gone_or_kept = fs::remove_dir_all(program);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn nobody_else_can_hold_the_lock() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".lock"), "").unwrap();
        let held = lock(folder.path()).unwrap();
        // A lock can be held by everybody who can open the file.
        assert_eq!(held.metadata().unwrap().permissions().mode() & 0o777, 0o600);
        drop(held);
        // Root may grade with a checkout that another user has built.
        if rustix::process::geteuid().is_root() {
            std::os::unix::fs::chown(folder.path().join(".lock"), Some(12345), None).unwrap();
            lock(folder.path()).unwrap();
        }
    }

    #[test]
    fn oldest_programs_are_deleted_and_young_ones_kept() {
        let folder = tempfile::tempdir().unwrap();
        for (name, age) in [("a", 3000), ("b", 2000), ("c", 4000), ("d", 10)] {
            let program = folder.path().join(name);
            fs::create_dir(&program).unwrap();
            let made = SystemTime::now() - Duration::from_secs(age);
            fs::File::open(&program)
                .unwrap()
                .set_modified(made)
                .unwrap();
        }
        let left = || {
            let names = fs::read_dir(folder.path()).unwrap().flatten();
            let mut names: Vec<_> = names.map(|entry| entry.file_name()).collect();
            names.sort();
            names
        };
        prune_to(folder.path(), 3, Duration::from_secs(60));
        assert_eq!(left(), ["a", "b", "d"]);
        prune_to(folder.path(), 0, Duration::from_secs(60));
        assert_eq!(left(), ["d"]);
        fs::create_dir(folder.path().join("e")).unwrap();
        let long_ago = SystemTime::now() - Duration::from_secs(5000);
        let open = || fs::File::open(folder.path().join("e")).unwrap();
        open().set_modified(long_ago).unwrap();
        keep(&folder.path().join("e"));
        prune_to(folder.path(), 0, Duration::from_secs(60));
        assert_eq!(left(), ["d", "e"]);
    }
}
