//! The handout, generated from the reference, so that a stub's documentation and
//! signature always match the answer's.

use std::fs;
use std::path::{Path, PathBuf};

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Result, ResultExt};
use crate::handout_record::{HandoutRecord, Package};

const ANSWER: &str = "// ANCHOR: answer";
const ANSWER_END: &str = "// ANCHOR_END: answer";

/// Generates the handout of an assignment.
///
/// # Errors
/// If a file of the reference cannot be read, or an answer is not enclosed by a pair of anchors,
/// because the answer might then leak.
pub fn generate(assignment: &Assignment) -> Result<Package> {
    let reference = assignment.reference();
    let mut package = Package::new();
    for file in assignment.fixed_files() {
        let text = read(&reference.join("src").join(&file))?;
        package.insert(Path::new("src").join(file), text);
    }
    for task in &assignment.tasks {
        let path = reference.join("src").join(task.file());
        let stub = stub(&read(&path)?, &task.name).or_environment(
            format_args!("{}", path.display()),
            format!("put each answer's whole body between `{ANSWER}` and `{ANSWER_END}`"),
        )?;
        package.insert(Path::new("src").join(task.file()), stub);
    }
    Ok(package)
}

/// The stubs as students got them. Where there is no reference to generate them from, these are
/// the copies that came with the handout.
pub fn pristine(assignment: &Assignment, checkout: &Checkout) -> Result<Package> {
    match HandoutRecord::read(checkout.root())? {
        None => generate(assignment),
        Some(record) => record.package(&assignment.pristine(), checkout),
    }
}

/// Replaces each answer between its anchors with `todo!`.
fn stub(text: &str, task: &str) -> std::result::Result<String, String> {
    let mut stub = String::new();
    let mut inside = false;
    let mut answers = 0;
    for line in text.lines() {
        match line.trim() {
            ANSWER if inside => return Err("an answer begins inside another".into()),
            ANSWER => {
                inside = true;
                answers += 1;
                let indent = &line[..line.len() - line.trim_start().len()];
                stub.push_str(&format!("{indent}todo!(\"{task}\")\n"));
            }
            ANSWER_END if !inside => return Err("an answer's end has no beginning".into()),
            ANSWER_END => inside = false,
            _ if inside => {}
            _ => {
                stub.push_str(line);
                stub.push('\n');
            }
        }
    }
    match (answers, inside) {
        (_, true) => Err("the answer has no end".into()),
        (0, _) => Err("there is no answer".into()),
        _ => Ok(stub),
    }
}

/// Writes the package to `folder`.
pub fn write(package: &Package, folder: &Path) -> Result<()> {
    for (path, text) in package {
        let path = folder.join(path);
        let parent = path.parent().unwrap_or(folder);
        fs::create_dir_all(parent)
            .and_then(|()| fs::write(&path, text))
            .or_input(
                format_args!("cannot write {}", path.display()),
                "check that you may write to the folder",
            )?;
    }
    Ok(())
}

/// The files of `folder` that differ from the package.
pub fn out_of_step(package: &Package, folder: &Path) -> Vec<PathBuf> {
    let differs = |(path, text): &(&PathBuf, &String)| {
        fs::read_to_string(folder.join(path)).map_or(true, |found| found != **text)
    };
    let mut paths: Vec<PathBuf> = package
        .iter()
        .filter(differs)
        .map(|(path, _)| path.clone())
        .collect();
    let entries = fs::read_dir(folder.join("src"))
        .into_iter()
        .flatten()
        .flatten();
    let extra = entries.map(|entry| Path::new("src").join(entry.file_name()));
    let is_source = |path: &PathBuf| path.extension().is_some_and(|end| end == "rs");
    paths.extend(extra.filter(|path| is_source(path) && !package.contains_key(path)));
    paths
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).or_environment(
        format_args!("cannot read {}", path.display()),
        "restore the assignment's `reference` folder",
    )
}

/// Whether a file is its stub, apart from comments on lines of their own, and from spaces.
pub fn is_unchanged(stub: &str, text: &str) -> bool {
    code_lines(stub).eq(code_lines(text))
}

fn code_lines(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.lines().map(str::trim);
    lines.filter(|line| !line.is_empty() && !line.starts_with("//"))
}
