//! An autograder for Gradescope: the course, and the two scripts that Gradescope runs.
//!
//! It contains every golden and our answers, so it is for instructors only and never part of a
//! student's repository.

use std::io::Write;
use std::path::Path;
use std::time::Duration;

use clap::ValueEnum;
use tempfile::NamedTempFile;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::course::add_earlier_goldens;
use super::sources::{add_folder_as, add_top, read};
use super::workspace::{CLI, INSTRUCTOR, Workspace};
use super::{Files, HandoutSize, place_of};
use crate::grade::grader::fresh::{Purpose, refuse_exposed, reserve};
use crate::grade::redact::Reveal;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::manifest::Manifest;

/// Gradescope runs the first when it builds the container's image, and the second for each
/// submission. The third is for people who unpack the archive.
const RECIPE: [(&str, &str, u32); 3] = [
    (
        "setup.sh",
        include_str!("../../templates/handout/gradescope/setup.sh"),
        0o755,
    ),
    (
        "run_autograder",
        include_str!("../../templates/handout/gradescope/run_autograder.sh"),
        0o755,
    ),
    (
        "README.md",
        include_str!("../../templates/handout/gradescope/README.md"),
        0o644,
    ),
];

/// The folder of the course in the archive.
const COURSE: &str = "pinhole";

/// Writes the archive. It appears at `path` only when it is complete.
pub fn write(
    assignment: &Assignment,
    checkout: &Checkout,
    fresh: Option<&Path>,
    reveal: Reveal,
    path: &Path,
) -> Result<HandoutSize> {
    let course = course(assignment, checkout, fresh, reveal)?;
    let minutes = worst_case(assignment).as_secs().div_ceil(60).to_string();
    let recipe =
        RECIPE.map(|(name, text, mode)| (name, text.replace("{{ minutes }}", &minutes), mode));
    let recipe = recipe.iter();
    let recipe = recipe.map(|(name, text, mode)| ((*name).to_owned(), text.as_bytes(), *mode));
    let course = course.iter();
    let course = course.map(|(name, bytes)| (format!("{COURSE}/{name}"), bytes.as_slice(), 0o644));
    let failed = Error::input(
        format!("cannot write {}", path.display()),
        "name a file in a folder you may write to",
    );
    let beside = path.parent().filter(|it| !it.as_os_str().is_empty());
    let fresh = NamedTempFile::new_in(beside.unwrap_or(Path::new("."))).or_fail(&failed)?;
    let mut archive = ZipWriter::new(fresh);
    let mut files = 0;
    for (name, bytes, mode) in recipe.chain(course) {
        // Films are compressed already, and sources are small.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .unix_permissions(mode);
        archive.start_file(name, options).or_fail(&failed)?;
        archive.write_all(bytes).or_fail(&failed)?;
        files += 1;
    }
    let fresh = archive.finish().or_fail(&failed)?;
    let file = fresh.persist(path).or_fail(&failed)?;
    let bytes = file.metadata().or_fail(&failed)?.len();
    Ok(HandoutSize { files, bytes })
}

/// How long one process may take by the wall clock, for the default limit of processor time in
/// `grade`.
const LIMIT: Duration = Duration::from_secs(4 * 2 + 2);

/// The processor time that each process has once a submission has exceeded two limits. We assume
/// one thread. In most tasks, this is a hundred times what the reference takes.
const SHORTEST: Duration = Duration::from_secs(4);

/// How long a submission takes if no answer ever ends: one process at the full limit beside other
/// submissions, two more alone, and then, at the shortest limit and for both public and fresh
/// questions, one process for each task and for up to three of its groups.
fn worst_case(assignment: &Assignment) -> Duration {
    let groups = assignment.tasks.iter().map(|task| task.points.len().min(3));
    let processes = groups.sum::<usize>() + assignment.tasks.len();
    LIMIT + LIMIT * 2 + SHORTEST * 2 * processes as u32
}

/// The files for grading: the checkout without mistakes, variants and the scripts that render
/// goldens, plus fresh questions and the setting of what may be revealed.
pub fn course(
    assignment: &Assignment,
    checkout: &Checkout,
    fresh: Option<&Path>,
    reveal: Reveal,
) -> Result<Files> {
    let mut files = Files::new();
    let word = reveal.to_possible_value();
    let word = word.map_or(String::new(), |word| word.get_name().to_owned());
    files.insert("reveal".into(), word.into_bytes());
    if let Some(folder) = fresh {
        // Read the manifest first, to refuse a folder without goldens.
        Manifest::read(folder)?;
        refuse_exposed(folder)?;
        reserve(folder, Purpose::Feedback)?;
        add_folder_as(&mut files, folder, "fresh", &[])?;
    }
    add_top(&mut files, checkout)?;
    let programs = [CLI.to_owned(), INSTRUCTOR.to_owned()];
    let folder = place_of(assignment);
    let mut packages = programs.to_vec();
    for part in ["handout", "reference", "tests", "scenes"] {
        let own = assignment.folder.join(part);
        if own.join("Cargo.toml").is_file() {
            packages.push(format!("{folder}/{part}"));
        }
        if own.is_dir() {
            add_folder_as(&mut files, &own, &format!("{folder}/{part}"), &[])?;
        }
    }
    let tasks = read(&assignment.folder.join("assignment.toml"))?;
    files.insert(format!("{folder}/assignment.toml"), tasks);
    let golden = format!("golden/{}", assignment.name);
    add_folder_as(&mut files, &assignment.golden(), &golden, &[])?;
    add_earlier_goldens(&mut files, assignment)?;
    let workspace = Workspace {
        assignment,
        packages: &packages,
        default: &programs,
    };
    workspace.add(&mut files, checkout)?;
    Ok(files)
}
