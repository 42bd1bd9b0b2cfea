//! What lies in the folder of a graded class, written so that a power cut at any moment
//! leaves the old file or the new one, never half of either.

use std::fs::{self, File, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::record::Record;
use pinhole_course::error::{Error, Result};
use pinhole_course::outcome::SCHEMA;

/// The folder of a graded class, locked for as long as this lives.
pub struct Store {
    folder: PathBuf,
    /// The operating system lets go of it however we end: no lock is ever stale.
    _lock: File,
}

impl Store {
    /// Opens the folder for one grader alone.
    pub fn open(folder: &Path) -> Result<Store> {
        let submissions = folder.join("submissions");
        fs::create_dir_all(&submissions).map_err(|error| failed(&submissions, &error))?;
        let path = folder.join(".lock");
        let lock = File::options()
            .create(true)
            .truncate(false)
            .write(true)
            .open(&path);
        let lock = lock.map_err(|error| failed(&path, &error))?;
        match lock.try_lock() {
            Ok(()) => Ok(Store {
                folder: folder.into(),
                _lock: lock,
            }),
            Err(TryLockError::WouldBlock) => Err(Error::input(
                format!("somebody else is grading into {}", folder.display()),
                "wait until they are done, or name another folder with --out",
            )),
            Err(TryLockError::Error(error)) => Err(failed(&path, &error)),
        }
    }

    /// Where a file of the class lies.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Where the files of a submission lie.
    pub fn of(&self, id: &str) -> PathBuf {
        self.folder.join("submissions").join(id)
    }

    /// The finished grade of a submission; `None` if there is none that can be read.
    pub fn record(&self, id: &str) -> Option<Record> {
        read(&self.of(id).join("result.json")).filter(Record::is_graded)
    }

    /// Keeps a finished grade. Its report is there before it, so that a result means
    /// that all is there.
    pub fn keep(&self, record: &Record, report: &str) -> Result<()> {
        let folder = self.of(&record.id);
        write(&folder.join("report.html"), report.as_bytes())?;
        write(&folder.join("result.json"), pretty(record)?.as_bytes())?;
        let _was_mended = fs::remove_file(folder.join("fault.json"));
        Ok(())
    }

    /// Keeps the record of a fault of ours beside a finished grade, never over it.
    pub fn keep_fault(&self, record: &Record) -> Result<()> {
        let folder = self.of(&record.id);
        let name = match folder.join("result.json").exists() {
            true => "fault.json",
            false => "result.json",
        };
        write(&folder.join(name), pretty(record)?.as_bytes())
    }

    /// Writes a file of the class, unless it holds the same already.
    pub fn write(&self, name: &str, content: &str) -> Result<()> {
        let path = self.path(name);
        if fs::read(&path).is_ok_and(|old| old == content.as_bytes()) {
            return Ok(());
        }
        write(&path, content.as_bytes())
    }
}

/// What a folder of `submissions` holds of one: its grade, or why it has none. A grade
/// does not stand if other answers could not be graded since.
pub fn standing(folder: &Path) -> Option<Record> {
    let (result, fault) = (
        read(&folder.join("result.json")),
        read(&folder.join("fault.json")),
    );
    match (&result, &fault) {
        (Some(result), Some(fault)) if result.provenance == fault.provenance => {}
        (_, Some(_)) => return fault,
        (_, None) => {}
    }
    result
}

/// A record; `None` if there is none, or of another version.
fn read(path: &Path) -> Option<Record> {
    let record: Record = serde_json::from_str(&fs::read_to_string(path).ok()?).ok()?;
    (record.got.schema == SCHEMA).then_some(record)
}

/// JSON for people, too.
pub fn pretty(value: &impl serde::Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(value).map_err(|error| {
        Error::environment(format!("cannot write a result: {error}"), "report this")
    })?;
    Ok(text + "\n")
}

/// Writes beside, makes sure that it is on the disk, and puts it in its place at once.
pub fn write(path: &Path, content: &[u8]) -> Result<()> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    let beside = PathBuf::from(beside);
    let put = || {
        fs::create_dir_all(folder)?;
        let mut file = File::create(&beside)?;
        file.write_all(content)?;
        file.sync_all()?;
        fs::rename(&beside, path)?;
        #[cfg(unix)]
        File::open(folder)?.sync_all()?;
        Ok(())
    };
    put().map_err(|error: std::io::Error| failed(path, &error))
}

fn failed(path: &Path, error: &std::io::Error) -> Error {
    Error::environment(
        format!("cannot write {}: {error}", path.display()),
        "free some disk space and check that the folder can be written; run this again and it goes on",
    )
}
