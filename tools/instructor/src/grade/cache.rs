//! Stores the files of a graded class. Each is written atomically: after a power cut, either the
//! old file is there or the new one.

use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::evidence::{self, Evidence};
use super::intake::Entry;
use super::record::Record;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::outcome::SCHEMA;
use pinhole_course::private::{is_ours, make_private, new_private_file, private_file};
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
    let record = last(folder)?;
    let is_of_these = match &entry.answers {
        Some(answers) => *answers == record.provenance.answers,
        // They can't be read, so no grade is for them.
        None => !record.is_graded(),
    };
    Some(match is_of_these {
        true => record,
        false => record.not_graded(
            "these answers have not been graded yet; any older mark is for other answers".into(),
        ),
    })
}

fn last(folder: &Path) -> Option<Record> {
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

/// Writes a file atomically: beside its place, flushed to disk, then renamed.
pub fn write(path: &Path, content: &[u8]) -> Result<()> {
    write_beside(path, content)?;
    fs::rename(beside(path), path)
        .or_fail(&cannot_write(path))
        .and_then(|()| flush_folder(path))
}

/// Writes a new version beside a file, and flushes it to disk.
fn write_beside(path: &Path, content: &[u8]) -> Result<()> {
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
fn flush_folder(path: &Path) -> Result<()> {
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
fn replace(path: &Path, make: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
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
fn beside(path: &Path) -> PathBuf {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    beside.into()
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

fn cannot_write(path: &Path) -> Error {
    Error::environment(
        format!("cannot write {}", path.display()),
        "free some disk space, check that the folder can be written, and run this command again",
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::grade::record::tests::graded;

    #[test]
    fn report_names_only_the_latest_points() {
        let folder = tempfile::tempdir().expect("there is room");
        let report = folder.path().join("report.html");
        let page = "<html>".repeat(100);
        fs::write(&report, &page).expect("there is room");
        for mark in ["7 of 8", "12 of 16"] {
            let note = format!("{NOTE}{mark}</p>");
            replace_note(&report, &note).expect("it is there");
            let now = fs::read_to_string(&report).expect("it is there");
            assert_eq!(now, format!("{page}{note}"));
        }
    }

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

    #[test]
    fn no_result_is_beside_another_grades_report() {
        let folder = tempfile::tempdir().expect("there is room");
        let cache = ResultCache::open(folder.path()).expect("it is new");
        let record = graded("ada", 1, 1);
        let evidence = evidence(&record);
        cache
            .put(&record, "first", &evidence)
            .expect("there is room");
        assert_eq!(cache.get("ada"), Some(record.clone()));
        // Storing the second grade fails before or after the old report is gone.
        let report = cache.of("ada").join("report.html");
        for (blocked, old) in [
            (report, Some(record.clone())),
            (cache.path(&Evidence::file("ada")), None),
        ] {
            fs::remove_file(&blocked).expect("it is there");
            fs::create_dir(&blocked).expect("there is room");
            let failed = cache.put(&graded("ada", 0, 1), "second", &evidence);
            assert!(failed.is_err());
            assert_eq!(cache.get("ada"), old);
            fs::remove_dir(&blocked).expect("it is empty");
        }
    }

    #[test]
    fn the_next_list_of_changes_knows_the_grade_before_a_run_that_was_stopped() {
        let folder = tempfile::tempdir().expect("there is room");
        let cache = ResultCache::open(folder.path()).expect("it is new");
        let put = |points| {
            let record = graded("ada", points, 3);
            cache
                .put(&record, "report", &evidence(&record))
                .expect("there is room");
        };
        let listed = || cache.listed("ada").map(|record| record.got.points);
        put(1);
        assert_eq!(listed(), None, "a first grade is not a change");
        // A power cut has left an empty file.
        fs::write(cache.of("ada").join(LISTED), "").expect("there is room");
        put(2);
        put(3);
        assert_eq!(listed(), Some(Some(1)));
        cache.forget_listed("ada");
        cache
            .put_points(&graded("ada", 2, 3))
            .expect("there is room");
        assert_eq!(listed(), Some(Some(3)));
    }

    fn evidence(record: &Record) -> Evidence {
        Evidence {
            id: record.id.clone(),
            public: record.got.clone(),
            fresh: None,
            fresh_folder: None,
            answers: Default::default(),
        }
    }

    #[cfg(unix)]
    #[test]
    fn results_that_others_may_have_written_are_not_believed() {
        use std::os::unix::fs::{PermissionsExt, chown};

        let out = tempfile::tempdir().expect("there is room");
        let open = || ResultCache::open(out.path()).map(drop);
        open().expect("it is new");
        open().expect("it is ours");
        for name in ["submissions", "evidence", "fresh", "roll.json"] {
            let path = out.path().join(name);
            if name == "fresh" {
                fs::create_dir(&path).expect("there is room");
            } else if name == "roll.json" {
                fs::write(&path, "{}").expect("there is room");
            }
            let allow = |mode| fs::set_permissions(&path, fs::Permissions::from_mode(mode));
            allow(0o770).expect("it is ours");
            let error = open().expect_err("somebody else may have written them");
            assert!(error.to_string().contains(name), "{error}");
            allow(0o755).expect("it is ours");
            open().expect("others may only read them");
            // Only root can give files away.
            if chown(&path, Some(12345), None).is_ok() {
                open().expect_err("somebody else made it");
                chown(&path, Some(0), None).expect("we are root");
            }
        }
    }

    #[cfg(unix)]
    #[test]
    fn nobody_else_sees_how_large_the_files_of_a_class_are() {
        use pinhole_course::private::{allow, is_private};

        let folder = tempfile::tempdir().expect("there is room");
        // Either folder may be new: the class's, or those inside.
        let [new, old] = ["new", "old"].map(|name| folder.path().join(name));
        fs::create_dir(&old).expect("there is room");
        allow(&old, 0o755).expect("it is ours");
        let put = |out: &Path| {
            let cache = ResultCache::open(out).expect("it is ours");
            let record = graded("ada", 1, 1);
            let put = cache.put(&record, "report", &evidence(&record));
            put.expect("there is room");
        };
        put(&new);
        assert!(is_private(&new));
        put(&old);
        for name in ["submissions", "evidence"] {
            assert!(is_private(&old.join(name)), "{name}");
        }
    }

    #[test]
    fn unreadable_submission_has_no_grade() {
        use crate::grade::class::marks::tests::entry;

        let folder = tempfile::tempdir().expect("there is room");
        let cache = ResultCache::open(folder.path()).expect("it is new");
        let mut entry = entry("ada", "ada", "ada");
        let record = graded("ada", 1, 1);
        write(
            &cache.of("ada").join("result.json"),
            &pretty(&record).expect("JSON").into_bytes(),
        )
        .expect("there is room");
        let grade = |entry: &Entry| standing(&cache.of("ada"), entry).map(|it| it.is_graded());
        assert_eq!(grade(&entry), Some(false));
        entry.answers = Some(record.provenance.answers.clone());
        assert_eq!(grade(&entry), Some(true));
        // A later upload can't be read either, and the reason is shown.
        entry.answers = None;
        cache
            .put_fault(&record.not_graded("it is encrypted".into()))
            .expect("there is room");
        fs::remove_file(cache.of("ada").join("result.json")).expect("it is there");
        assert!(standing(&cache.of("ada"), &entry).is_none_or(|it| !it.is_graded()));
    }

    #[test]
    fn result_of_an_older_version_is_ignored() {
        let folder = tempfile::tempdir().expect("there is room");
        let cache = ResultCache::open(folder.path()).expect("it is new");
        let path = cache.of("ada").join("result.json");
        let mut record = serde_json::to_value(graded("ada", 1, 1)).expect("it can be written");
        let is_there = |record: &serde_json::Value| {
            write(&path, record.to_string().as_bytes()).expect("there is room");
            (cache.get("ada").is_some(), last(&cache.of("ada")).is_some())
        };
        assert_eq!(is_there(&record), (true, true));
        record["schema"] = 1.into();
        assert_eq!(is_there(&record), (false, false));
        let oldest = json!({ "schema": 1, "id": "ada", "name": "ada", "points": 1 });
        assert_eq!(is_there(&oldest), (false, false));
    }
}
