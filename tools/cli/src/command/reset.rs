//! `pinhole reset`: replaces an answer with its stub and keeps the old text.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::cli::Reset;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::shell::from_here;
use pinhole_course::stubs;
use pinhole_course::submission::Submission;
use pinhole_report::escape::printable;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Reset) -> Result<Status> {
    let named = arguments.dir.as_deref();
    let assignment = arguments.assignment.find(checkout, named)?;
    let mut tasks = assignment.answerable();
    let Some(task) = tasks.find(|task| task.name == arguments.task) else {
        let names = assignment.answerable().map(|task| task.name.as_str());
        return Err(Error::input(
            format!("there is no task `{}`", arguments.task),
            format!("name one of: {}", names.collect::<Vec<_>>().join(", ")),
        ));
    };
    let submission = Submission::named_or(named, &assignment)?;
    let file = submission.place.join(task.file());
    let pristine = stubs::pristine(&assignment, checkout)?;
    let stub = pristine.get(&Path::new("src").join(task.file()));
    let stub = stub.ok_or_else(|| {
        let problem = format!("the stub of {} is missing", task.file());
        Error::environment(problem, "copy it from the repository that you were given")
    })?;
    let backup = put(stub, &file)?;
    let shown = |path: &Path| from_here(path).display().to_string();
    let (file, backup) = (shown(&file), backup.map(|backup| shown(&backup)));
    if arguments.json {
        let document = json!({ "task": task.name, "file": file, "backup": backup });
        anstream::println!("{document:#}");
        return Ok(Status::Well);
    }
    match backup {
        Some(backup) => anstream::println!(
            "{} is the stub again; your code is in {}",
            printable(&file),
            printable(&backup)
        ),
        None => anstream::println!("{} is the stub again", printable(&file)),
    }
    Ok(Status::Well)
}

/// Writes a stub over a file. If the file held anything else, it is first moved to another
/// name.
fn put(stub: &str, file: &Path) -> Result<Option<PathBuf>> {
    let failed = Error::file(file);
    if file.is_symlink() || file.exists() && !file.is_file() {
        return Err(failed.because("it is not a regular file"));
    }
    let old = file.is_file().then(|| fs::read(file)).transpose();
    let old = old.or_fail(&failed)?;
    if old.as_deref() == Some(stub.as_bytes()) {
        return Ok(None);
    }
    let backup = old.map(|_| free_name(file));
    if let Some(backup) = &backup {
        fs::rename(file, backup).or_fail(&failed)?;
    }
    // Another user may have put a link there meanwhile.
    let mut new = File::create_new(file).or_fail(&failed)?;
    new.write_all(stub.as_bytes()).or_fail(&failed)?;
    Ok(backup)
}

/// The first of `x.rs.old`, `x.rs.old2`, … that does not exist.
fn free_name(file: &Path) -> PathBuf {
    let name = |k: usize| match k {
        1 => file.with_extension("rs.old"),
        k => file.with_extension(format!("rs.old{k}")),
    };
    let mut names = (1..).map(name);
    let free = names.find(|name| fs::symlink_metadata(name).is_err());
    free.expect("a folder holds finitely many files")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_reset_loses_a_students_text() {
        let folder = tempfile::tempdir().expect("there is room");
        let file = folder.path().join("answer.rs");
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("it is there");
        assert_eq!(put("stub", &file).expect("it can be written"), None);
        assert_eq!(put("stub", &file).expect("nothing to do"), None);
        for (text, backup) in [("first", "answer.rs.old"), ("second", "answer.rs.old2")] {
            fs::write(&file, text).expect("there is room");
            let kept = put("stub", &file).expect("it can be written");
            assert_eq!(kept, Some(folder.path().join(backup)));
            assert_eq!(
                (read("answer.rs").as_str(), read(backup).as_str()),
                ("stub", text)
            );
        }
        assert_eq!(read("answer.rs.old"), "first");
    }
}
