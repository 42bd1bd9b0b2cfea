//! Finds the assignment that a user means, and reads its `assignment.toml`.

use std::fs;
use std::path::{Path, is_separator};

use serde::Deserialize;

use super::{Assignment, DroppedGroup, EarlierAnswer, Finish, ScenePoints, Task};
use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: String,
    start: Option<String>,
    #[serde(default)]
    withheld: u32,
    solutions_read: Option<u32>,
    finish: Option<Finish>,
    task: Vec<Task>,
    earlier: Option<EarlierAnswer>,
    scene: Vec<ScenePoints>,
    #[serde(default)]
    dropped: Vec<DroppedGroup>,
}

impl Assignment {
    /// Finds an assignment by its name or by the path of its folder. Without a name, finds the
    /// one that contains `folder`, or else the checkout's default.
    ///
    /// # Errors
    /// If no assignment has this name, or its `assignment.toml` is wrong.
    pub fn find(checkout: &Checkout, name: Option<&str>, folder: &Path) -> Result<Assignment> {
        match name {
            Some(name) => Assignment::named(checkout, name),
            None => Assignment::around(checkout, folder),
        }
    }

    /// All assignments of a checkout, by name.
    ///
    /// # Errors
    /// If an `assignment.toml` is wrong.
    pub fn read_all(checkout: &Checkout) -> Result<Vec<Assignment>> {
        let names = names(checkout);
        names
            .iter()
            .map(|name| Assignment::read(checkout, name))
            .collect()
    }

    fn named(checkout: &Checkout, name: &str) -> Result<Assignment> {
        // A mere name is one of our own, even if the shell has put a slash at its end. The current
        // folder may be a student's, and the reference in an assignment's folder runs without a
        // sandbox.
        let name = name.trim_end_matches(is_separator);
        let is_path = name.starts_with('.') || name.contains(is_separator);
        // The path must be absolute, because the goldens are found relative to a folder above it.
        let folder = Path::new(name).canonicalize().ok();
        let folder = folder.filter(|folder| is_path && folder.join("assignment.toml").is_file());
        match folder
            .as_deref()
            .and_then(|folder| Some((folder, folder.file_name()?)))
        {
            Some((folder, own)) => Assignment::in_folder(checkout, folder, &own.to_string_lossy()),
            None => Assignment::read(checkout, name),
        }
    }

    /// The assignment of this name.
    pub fn read(checkout: &Checkout, name: &str) -> Result<Assignment> {
        Assignment::in_folder(checkout, &checkout.assignments().join(name), name)
    }

    fn in_folder(checkout: &Checkout, folder: &Path, name: &str) -> Result<Assignment> {
        let path = folder.join("assignment.toml");
        let text = fs::read_to_string(&path).or_input(
            format_args!("cannot read {}", path.display()),
            format!(
                "name an assignment of this checkout ({}), or a folder by its path, such as ./NAME",
                names(checkout).join(", ")
            ),
        )?;
        let file: File = toml::from_str(&text).or_input(
            format_args!("{}", path.display()),
            "correct the assignment file",
        )?;
        let earlier = file.earlier.iter().map(|earlier| &earlier.task);
        if let Some(task) = file
            .task
            .iter()
            .chain(earlier)
            .find(|task| !task.has_shape_if_it_takes_one())
        {
            return Err(Error::input(
                format!(
                    "{}: task `{}` of kind `{}` names {}",
                    path.display(),
                    task.name,
                    task.kind,
                    task.shape
                        .map_or("no shape".into(), |shape| format!("the shape `{shape}`")),
                ),
                "give a `shape` to a task that intersects a shape, and to no other task",
            ));
        }
        let mut unfair = file.task.iter().filter(|task| !task.has_fair_examples());
        if let Some((task, examples)) = unfair
            .next()
            .and_then(|it| Some((it, it.examples.as_ref()?)))
        {
            let line = text[..examples.span().start].matches('\n').count() + 1;
            return Err(Error::input(
                format!(
                    "{}:{line}: `{}` can't have these `examples`",
                    path.display(),
                    task.name
                ),
                "give 1 point or more, and a `catch` above 0 and at most 1, to a task whose \
                 questions have only one right answer each, and that has no group `examples`",
            ));
        }
        let is_group = |dropped: &DroppedGroup| {
            file.task.iter().any(|task| {
                let mut groups = task.all_points().map(|points| points.group);
                groups.any(|group| dropped.group == format!("{}.{group}", task.name))
            })
        };
        if let Some(dropped) = file.dropped.iter().find(|dropped| !is_group(dropped)) {
            return Err(Error::input(
                format!(
                    "{}: there is no group `{}` to drop",
                    path.display(),
                    dropped.group
                ),
                "name a task and one of its groups: TASK.GROUP",
            ));
        }
        let first = file.task.first().map(|task| task.name.clone());
        Ok(Assignment {
            start: file.start.or(first).unwrap_or_default(),
            name: name.into(),
            folder: folder.into(),
            title: file.title,
            tasks: file.task,
            earlier: file.earlier,
            scenes: file.scene,
            withheld: file.withheld,
            solutions_read: file.solutions_read,
            finish: file.finish,
            dropped: file.dropped,
        })
    }

    /// The assignment that contains a folder, or else the default.
    fn around(checkout: &Checkout, folder: &Path) -> Result<Assignment> {
        let folder = folder.canonicalize();
        let holds = |name: &String| {
            let own = checkout.assignments().join(name).canonicalize();
            own.is_ok_and(|own| folder.as_ref().is_ok_and(|folder| folder.starts_with(own)))
        };
        match names(checkout).into_iter().find(holds) {
            Some(name) => Assignment::read(checkout, &name),
            None => Assignment::read(checkout, &checkout.default_assignment()?),
        }
    }
}

/// The assignments of a checkout, by name.
fn names(checkout: &Checkout) -> Vec<String> {
    let entries = fs::read_dir(checkout.assignments())
        .into_iter()
        .flatten()
        .flatten();
    let mut names: Vec<String> = entries
        .filter(|entry| entry.path().join("assignment.toml").is_file())
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}

#[cfg(test)]
#[test]
fn a_folder_of_the_current_folder_is_no_assignment_unless_its_path_is_given() {
    let checkout = Checkout::find().unwrap();
    let name = checkout.default_assignment().unwrap();
    let own = Assignment::read(&checkout, &name).unwrap();
    let folder = tempfile::Builder::new()
        .prefix("mine")
        .tempdir_in(".")
        .unwrap();
    let file = "assignment.toml";
    fs::copy(own.folder.join(file), folder.path().join(file)).unwrap();
    let name = folder.path().file_name().unwrap().to_str().unwrap();
    let find = |name: &str| Assignment::find(&checkout, Some(name), Path::new(".")).is_ok();
    assert!(!find(name) && !find(&format!("{name}/")) && find(&format!("./{name}")));
}
