//! Writes a student's repository, completely or not at all, and never over existing work.

use std::fs;
use std::io;
use std::path::Path;

use super::{CARGO_CONFIG, Files, Repository, VENDORED, cargo_on};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::handout_record::{self, HandoutRecord};
use pinhole_course::manifest::{Hashes, hash, hash_of};

/// The size of a repository.
pub struct HandoutSize {
    /// How many files it has.
    pub files: usize,
    /// Their total size, in bytes.
    pub bytes: u64,
}

/// The largest size of a repository, in bytes. There is a limit because students fetch the
/// repository again and again.
const MOST_BYTES: u64 = 20_000_000;

/// How many files an error names.
const MOST_NAMED: usize = 10;

/// Writes the repository beside `out`, then moves it there.
pub fn write(
    repository: Repository,
    out: &Path,
    checkout: &Checkout,
    force: bool,
) -> Result<HandoutSize> {
    let name = out
        .file_name()
        .map(|name| name.to_string_lossy().into_owned());
    let name = name.ok_or_else(|| {
        let problem = format!("{} cannot be the name of a new folder", out.display());
        Error::input(problem, "name a new folder with --out")
    })?;
    let old = before(out, &repository.assignment, force)?;
    // Other users may make files where the repository will be, so write it in a folder with a name
    // that nobody knows.
    let around = out.parent().filter(|it| !it.as_os_str().is_empty());
    let around = around.unwrap_or(Path::new("."));
    let beside = fs::create_dir_all(around)
        .and_then(|()| around.canonicalize())
        .and_then(tempfile::tempdir_in);
    let beside = beside.or_fail(&cannot(out))?;
    let fresh = &beside.path().join(name);
    let Repository {
        assignment,
        mut files,
        vendored,
    } = repository;
    for (path, bytes) in &files {
        put(&fresh.join(path), bytes)?;
    }
    prune_lock(fresh, checkout)?;
    let lock = fresh.join("Cargo.lock");
    files.insert(
        "Cargo.lock".into(),
        fs::read(&lock).or_fail(&cannot(&lock))?,
    );
    if vendored {
        // Add these settings only now: they name a folder that is not there yet, and cargo would
        // have looked for it.
        let settings = files.entry(CARGO_CONFIG.into()).or_default();
        settings.extend_from_slice(VENDORED.as_bytes());
        put(&fresh.join(CARGO_CONFIG), settings)?;
    }
    let record = HandoutRecord {
        assignment,
        files: hashes(&files),
    };
    let text = record.text()?;
    put(&fresh.join(handout_record::FILE), text.as_bytes())?;
    let bytes = files.values().map(Vec::len).sum::<usize>() + text.len();
    let written = HandoutSize {
        files: files.len() + 1,
        bytes: bytes as u64,
    };
    if written.bytes > MOST_BYTES {
        return Err(Error::input(
            format!(
                "the repository would be {:.1} MB, but may be at most {} MB",
                written.bytes as f64 / 1e6,
                MOST_BYTES / 1_000_000
            ),
            "withhold the scene with the largest mesh, or render its golden with fewer pixels",
        ));
    }
    match old {
        None => {
            // Removes an empty folder. If the folder were not empty, `before` would have refused
            // it.
            let _absent = fs::remove_dir(out);
            fs::rename(fresh, out).or_fail(&cannot(out))?;
        }
        Some(old) => replace(fresh, out, &old, &record)?,
    }
    Ok(written)
}

/// What is at `out`: nothing, or an earlier handout that may be replaced.
fn before(out: &Path, assignment: &str, force: bool) -> Result<Option<HandoutRecord>> {
    let is_free = match fs::read_dir(out) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == io::ErrorKind::NotFound && !out.is_symlink(),
    };
    if is_free {
        return Ok(None);
    }
    let taken = |problem: &str, remedy: &str| {
        Err(Error::input(format!("{} {problem}", out.display()), remedy))
    };
    if !force {
        return taken(
            "already exists and is not empty",
            "name a new folder, or pass --force to replace an earlier handout there",
        );
    }
    match HandoutRecord::read(out)? {
        Some(record) if record.assignment == assignment => Ok(Some(record)),
        _ => taken(
            "is not an earlier handout of this assignment",
            "name a new folder; --force replaces only an earlier handout",
        ),
    }
}

/// Replaces the files of an earlier handout if none has been changed since. Everything else in
/// the folder stays.
fn replace(fresh: &Path, out: &Path, old: &HandoutRecord, new: &HandoutRecord) -> Result<()> {
    let is_changed = |path: &&String| {
        let now = hash(&out.join(path)).ok();
        // An interrupted run may have written some new files already.
        let expected = [old.files.get(*path), new.files.get(*path)];
        now.is_some_and(|now| !expected.contains(&Some(&now)))
    };
    let paths = old.files.keys().chain(new.files.keys());
    let mut changed: Vec<&String> = paths.filter(is_changed).collect();
    changed.sort();
    changed.dedup();
    if !changed.is_empty() {
        let named = changed.iter().take(MOST_NAMED).map(|path| path.as_str());
        return Err(Error::input(
            format!(
                "somebody has changed files in {1} ({0}): {2}",
                changed.len(),
                out.display(),
                named.collect::<Vec<_>>().join(", ")
            ),
            "nothing was replaced; name a new folder, or move these files away first",
        ));
    }
    for path in new
        .files
        .keys()
        .map(String::as_str)
        .chain([handout_record::FILE])
    {
        let to = out.join(path);
        let parent = to.parent().unwrap_or(out);
        fs::create_dir_all(parent)
            .and_then(|()| fs::rename(fresh.join(path), &to))
            .or_fail(&cannot(&to))?;
    }
    for path in old
        .files
        .keys()
        .filter(|path| !new.files.contains_key(*path))
    {
        let stale = out.join(path);
        match fs::remove_file(&stale) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(cannot(&stale).because(error));
            }
            _ => {}
        }
        // Remove their folders too, up to the first that is not empty.
        let folders = stale
            .ancestors()
            .skip(1)
            .take_while(|folder| *folder != out);
        for folder in folders {
            if fs::remove_dir(folder).is_err() {
                break;
            }
        }
    }
    Ok(())
}

/// Makes cargo remove from the lock file what a student's workspace does not need. With
/// `--locked`, as in CI, it would refuse to do so later.
fn prune_lock(folder: &Path, checkout: &Checkout) -> Result<()> {
    let mut cargo = cargo_on(folder, checkout, "update");
    cargo.args(["--workspace", "--offline"]);
    let failed = Error::environment(
        "cargo cannot prune the lock file",
        "run `cargo fetch` in the checkout, then run this command again",
    );
    let output = cargo.output().or_fail(&failed)?;
    match output.status.success() {
        true => Ok(()),
        false => Err(failed.because(String::from_utf8_lossy(&output.stderr).trim())),
    }
}

fn hashes(files: &Files) -> Hashes {
    let hash = |(path, bytes): (&String, &Vec<u8>)| {
        (path.clone(), hash_of(Path::new(path), bytes.clone()))
    };
    files.iter().map(hash).collect()
}

fn put(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::create_dir_all(path.parent().unwrap_or(Path::new("")))
        .and_then(|()| fs::write(path, bytes))
        .or_fail(&cannot(path))
}

fn cannot(path: &Path) -> Error {
    Error::input(
        format!("cannot write {}", path.display()),
        "name a folder you may write to, on a disk with some space",
    )
}
