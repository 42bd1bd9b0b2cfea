//! Stores the files of a graded class.

#[cfg(test)]
mod tests;

use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::atomic::{
    beside, cannot_write, flush_folder, link, replace, write, write_beside, write_unflushed,
};
use super::evidence::{self, Evidence};
use super::intake::Entry;
use super::record::Record;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::outcome::SCHEMA;
use pinhole_course::private::{is_ours, make_private, private_file};
use pinhole_course::shell::in_shell;
use pinhole_report::escape::printable_json;

/// The roll's file in the folder of a graded class. Merges read it.
pub const ROLL: &str = "roll.json";

/// The folder of a graded class, locked as long as this value lives.
pub struct ResultCache {
    folder: PathBuf,
    /// The operating system releases the lock when this process ends, however it ends, so the
    /// lock is never stale.
    _lock: File,
}

impl ResultCache {
    /// Opens the folder, and locks it against other graders.
    pub fn open(folder: &Path) -> Result<ResultCache> {
        // Even the size of a file can tell what a submission printed about a fresh question.
        for path in ["", "submissions", evidence::FOLDER].map(|name| folder.join(name)) {
            if !path.exists() {
                fs::create_dir_all(&path)
                    .and_then(|()| make_private(&path))
                    .or_fail(&cannot_write(&path))?;
            }
        }
        refuse_foreign(folder, "name another folder with --out")?;
        let path = folder.join(".lock");
        let lock = private_file(&path).or_fail(&cannot_write(&path))?;
        match lock.try_lock() {
            Ok(()) => Ok(ResultCache {
                folder: folder.into(),
                _lock: lock,
            }),
            Err(TryLockError::WouldBlock) => Err(Error::input(
                format!("another grader is writing to {}", folder.display()),
                "wait until it is done, or name another folder with --out",
            )),
            Err(TryLockError::Error(error)) => Err(cannot_write(&path).because(error)),
        }
    }

    /// The path of a file of the class.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The folder of a submission's files.
    pub fn of(&self, id: &str) -> PathBuf {
        self.folder.join("submissions").join(id)
    }

    /// The finished grade of a submission; `None` if there is no readable one.
    pub fn get(&self, id: &str) -> Option<Record> {
        read(&self.of(id).join("result.json")).filter(Record::is_graded)
    }

    /// The grade of a submission in the last list of changes. `None` if it still has that grade, or
    /// had none. If a run is stopped, the next one compares with this grade.
    pub fn listed(&self, id: &str) -> Option<Record> {
        read(&self.of(id).join(LISTED)).filter(Record::is_graded)
    }

    /// Keeps the grade that is about to be replaced, unless an earlier one is kept already.
    pub fn keep_listed(&self, id: &str) -> Result<()> {
        let folder = self.of(id);
        let (result, listed) = (folder.join("result.json"), folder.join(LISTED));
        match result.exists() && self.listed(id).is_none() {
            true => link(&result, &listed),
            false => Ok(()),
        }
    }

    /// Forgets a kept grade, because the change is listed now.
    pub fn forget_listed(&self, id: &str) {
        let _unchanged = fs::remove_file(self.of(id).join(LISTED));
    }

    /// Stores a finished grade. If that fails or this process is killed, the old grade is there, or
    /// the new one, or none, but never a result beside another grade's report.
    pub fn put(&self, record: &Record, report: &str, evidence: &Evidence) -> Result<()> {
        self.keep_listed(&record.id)?;
        let folder = self.of(&record.id);
        let result = folder.join("result.json");
        let files = [
            (folder.join("report.html"), report.into()),
            (self.path(&Evidence::file(&record.id)), pretty(evidence)?),
            (result.clone(), pretty(record)?),
        ];
        for (path, content) in &files {
            write_beside(path, content.as_bytes())?;
        }
        let old = folder.join("result.json.old");
        let _is_first = fs::rename(&result, &old);
        flush_folder(&result)?;
        for (place, (path, _)) in files.iter().enumerate() {
            if let Err(error) = fs::rename(beside(path), path) {
                if place == 0 {
                    let _was_first = fs::rename(&old, &result);
                }
                return Err(cannot_write(path).because(error));
            }
            flush_folder(path)?;
        }
        let _was_first = fs::remove_file(&old);
        self.forget_fault(&record.id);
        Ok(())
    }

    /// Forgets that grading a submission has failed, because it has a result now.
    pub fn forget_fault(&self, id: &str) {
        let _was_mended = fs::remove_file(self.of(id).join("fault.json"));
    }

    /// Stores a grade in which only the points have changed, and adds a note to the end of its
    /// report. The note comes first: if this process is killed between the two, the next run finds
    /// the old points, and does both again.
    pub fn put_points(&self, record: &Record) -> Result<()> {
        self.keep_listed(&record.id)?;
        let folder = self.of(&record.id);
        let (points, possible) = (record.got.points.unwrap_or(0), record.got.possible);
        let note = format!(
            "{NOTE}<strong>Since this report was written, the points of some tasks or scenes have \
             changed. The submission now has {points} of {possible} points.</strong></p>\n"
        );
        let path = folder.join("report.html");
        unshare(&path)
            .and_then(|()| replace_note(&path, &note))
            .or_fail(&cannot_write(&path))?;
        write_unflushed(&folder.join("result.json"), pretty(record)?.as_bytes())
    }

    /// Stores the record of a fault of ours beside a finished grade, without overwriting it.
    pub fn put_fault(&self, record: &Record) -> Result<()> {
        let folder = self.of(&record.id);
        let name = match folder.join("result.json").exists() {
            true => "fault.json",
            false => "result.json",
        };
        write(&folder.join(name), pretty(record)?.as_bytes())
    }

    /// Writes a file of the class, unless it has this content already.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> Result<()> {
        let (path, content) = (self.path(name), content.as_ref());
        if fs::read(&path).is_ok_and(|old| old == content) {
            return Ok(());
        }
        write(&path, content)
    }

    /// Writes a file of the class, or removes it if it has no content any more.
    pub fn write_or_remove(&self, name: &str, content: Option<impl AsRef<[u8]>>) -> Result<()> {
        let path = self.path(name);
        match content {
            Some(content) => self.write(name, content),
            None if path.exists() => fs::remove_file(&path).or_fail(&cannot_write(&path)),
            None => Ok(()),
        }
    }
}

/// Refuses the folder of a class if another user may have written the results in it, because these
/// files decide the marks. The folder itself may belong to another user: root in a container often
/// grades into a folder of the host.
pub fn refuse_foreign(folder: &Path, instead: &str) -> Result<()> {
    for path in ["submissions", evidence::FOLDER, "fresh", ROLL].map(|name| folder.join(name)) {
        if path.exists() && !is_ours(&path) {
            let path = path.display().to_string();
            return Err(Error::input(
                format!("another user may have written {path}"),
                format!(
                    "{instead}, or, if nobody else has changed it: chown -R \"$(id -u)\" {0} && \
                     chmod -R go-w {0}",
                    in_shell(&path)
                ),
            ));
        }
    }
    Ok(())
}

/// A grade that a run has replaced, until the change is listed.
const LISTED: &str = "listed.json";

/// The record of a submission in its folder: its grade, or why it has none. A grade for other
/// answers than the current ones is not valid. Such a grade remains if the run that should have
/// graded the current answers was stopped, if another shard has graded them, or if grading failed.
pub fn standing(folder: &Path, entry: &Entry) -> Option<Record> {
    let is_of_these = |record: &Record| match &entry.answers {
        Some(answers) => *answers == record.provenance.answers,
        // They can't be read, so no grade is for them.
        None => !record.is_graded(),
    };
    let [result, fault] = ["result.json", "fault.json"].map(|name| read(&folder.join(name)));
    // A fault is newer than the result beside it, unless both are of the same run.
    let is_new = |fault: &Record| {
        let of = |record: &Record| record.provenance == fault.provenance;
        !result.as_ref().is_some_and(of)
    };
    let records = [fault.filter(is_new), result].into_iter().flatten();
    let mut records: Vec<Record> = records.collect();
    if let Some(at) = records.iter().position(is_of_these) {
        return Some(records.swap_remove(at));
    }
    Some(records.into_iter().next()?.not_graded(
        "these answers have not been graded yet; any older mark is for other answers".into(),
    ))
}

/// A record; `None` if there is none, or if it has another version.
fn read(path: &Path) -> Option<Record> {
    let record: Record = serde_json::from_str(&fs::read_to_string(path).ok()?).ok()?;
    (record.got.schema == SCHEMA).then_some(record)
}

/// The beginning of a note that is added to the end of a report after points have changed.
const NOTE: &str = "<p role=\"note\">";

/// Replaces a file by a copy of it, because a merge may have linked it to a file of a part.
fn unshare(path: &Path) -> io::Result<()> {
    replace(path, |new| io::copy(&mut File::open(path)?, new).map(drop))
}

/// Writes a note to the end of a report, replacing an earlier one.
fn replace_note(report: &Path, note: &str) -> io::Result<()> {
    let mut file = File::options().read(true).write(true).open(report)?;
    let before_note = file.metadata()?.len().saturating_sub(2 * note.len() as u64);
    file.seek(SeekFrom::Start(before_note))?;
    let mut tail = Vec::new();
    file.read_to_end(&mut tail)?;
    let mut places = tail.windows(NOTE.len());
    let end = places.position(|window| window == NOTE.as_bytes());
    let end = before_note + end.unwrap_or(tail.len()) as u64;
    file.set_len(end)?;
    file.seek(SeekFrom::Start(end))?;
    file.write_all(note.as_bytes())
}

/// JSON, indented for people.
pub fn pretty(value: &impl serde::Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(value)
        .or_environment("cannot write a result", "report this")?;
    Ok(printable_json(&text) + "\n")
}
