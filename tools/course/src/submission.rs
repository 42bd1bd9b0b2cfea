//! A submission as it comes from a student: the answer files in a folder or a ZIP file, and
//! nothing else.

pub mod allow_list;
pub mod archive;
pub mod flags;
mod pack;
pub mod text;
pub(crate) mod tokens;

use std::fs;
use std::path::{Path, PathBuf};

use crate::assignment::{Assignment, Task, examples_file};
use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::shell::from_here;
use text::Text;

/// The answers found in a folder or a ZIP file.
#[derive(Clone, Debug)]
pub struct Submission {
    /// The folder or ZIP file as the user named it.
    pub folder: PathBuf,
    /// Where the answers were read, without links: a name may lead to another place a moment later.
    pub read_from: PathBuf,
    /// The folder inside it that holds the answer files.
    pub place: PathBuf,
    /// One for each task, in the assignment's order. Then the answer of an earlier assignment, if
    /// it was handed in again.
    pub answers: Vec<Answer>,
    /// The examples of each task that gives points for them.
    pub examples: Vec<Answer>,
}

/// The answer file of one task.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The task, which is also the file's name without `.rs`.
    pub task: String,
    /// Its text, or why there is none.
    pub text: Text,
}

/// Why an answer file does not count.
#[derive(Clone, Debug, PartialEq)]
pub enum AnswerFileProblem {
    /// It is not there.
    Missing,
    /// The file was not accepted, because it is too long or not a regular UTF-8 file. The text
    /// says which.
    Refused(String),
}

impl Answer {
    /// The answer to a task of this assignment or of an earlier one. `None` if it belongs to an
    /// earlier assignment, and is missing or the same as the file that was handed out.
    pub fn of(assignment: &Assignment, task: &Task, text: Text) -> Option<Answer> {
        let folders = [assignment.reference(), assignment.pristine()];
        let is_given = |text: &String| {
            folders.iter().any(|folder| {
                let given = fs::read_to_string(folder.join("src").join(task.file()));
                given.is_ok_and(|given| given == *text)
            })
        };
        let is_handed_in = match &text {
            _ if assignment.task(&task.name).is_some() => true,
            Ok(text) => !is_given(text),
            Err(problem) => *problem != AnswerFileProblem::Missing,
        };
        let task = task.name.clone();
        is_handed_in.then_some(Answer { task, text })
    }
}

impl Submission {
    /// Finds the answer files of `assignment` in `folder`, in its `src`, or in the same two
    /// places of the only folder inside. A ZIP file counts as a folder.
    ///
    /// # Errors
    /// If there is none, or the machine cannot read the files.
    pub fn find(folder: &Path, assignment: &Assignment) -> Result<Submission> {
        Submission::find_any(folder, assignment)?.ok_or_else(|| empty(folder, assignment))
    }

    /// The submission in a folder or an archive; `None` if it holds no answer file.
    pub fn find_any(folder: &Path, assignment: &Assignment) -> Result<Option<Submission>> {
        let read_from = folder.canonicalize().unwrap_or_default();
        if read_from.is_file() {
            return Submission::unpack(folder, read_from, assignment);
        }
        if !read_from.is_dir() {
            return Err(Error::input(
                format!("there is no folder {}", folder.display()),
                "name the folder or ZIP file that holds the answer files",
            ));
        }
        let holds_any = |place: &PathBuf| {
            assignment
                .tasks
                .iter()
                .any(|task| place.join(task.file()).symlink_metadata().is_ok())
        };
        let Some(place) = places(&read_from)?.into_iter().find(holds_any) else {
            return Ok(None);
        };
        let mut answers = Vec::new();
        for task in assignment.answerable() {
            let text = text::read(&place.join(task.file()))?;
            answers.extend(Answer::of(assignment, task, text));
        }
        let mut examples = Vec::new();
        for task in assignment.with_examples() {
            let task = task.name.clone();
            let text = text::read(&place.join(examples_file(&task)))?;
            examples.push(Answer { task, text });
        }
        let inside = place.strip_prefix(&read_from).unwrap_or(&place);
        let named = folder.components().chain(inside.components());
        Ok(Some(Submission {
            folder: folder.into(),
            answers,
            examples,
            place: named.collect(),
            read_from,
        }))
    }

    /// The submission in the folder that the user named, or else in the current one, or else in
    /// the handout's.
    ///
    /// # Errors
    /// See [`Submission::find`].
    pub fn named_or(named: Option<&Path>, assignment: &Assignment) -> Result<Submission> {
        match named {
            Some(folder) => Submission::find(folder, assignment),
            None => Submission::unnamed(Path::new("."), assignment),
        }
    }

    /// The submission that a command takes in a folder.
    fn unnamed(here: &Path, assignment: &Assignment) -> Result<Submission> {
        Submission::find(here, assignment)
            .or_else(|_| Submission::find(&from_here(&assignment.handout()), assignment))
    }

    /// Whether a command takes the answers in `folder` if it names no folder and no assignment,
    /// both in the current folder and at the top of the repository.
    pub fn is_default(folder: &Path) -> bool {
        let is_taken = |checkout: &Checkout, here: &Path| -> Result<bool> {
            let assignment = Assignment::find(checkout, None, here)?;
            let taken = Submission::unnamed(here, &assignment)?.place.canonicalize();
            let asked = Submission::find(folder, &assignment)?.place.canonicalize();
            Ok(matches!((taken, asked), (Ok(taken), Ok(asked)) if taken == asked))
        };
        Checkout::find().is_ok_and(|checkout| {
            let places = [Path::new("."), checkout.root()];
            let mut taken = places.map(|here| is_taken(&checkout, here)).into_iter();
            taken.all(|taken| taken.unwrap_or(false))
        })
    }

    /// Where to edit the answer to a task, as `file:line` from the current folder: at the line of
    /// the message about it, if there is one, or else at its first `todo!`, or else at its first
    /// function. `None` in an archive.
    pub fn place_to_edit(&self, task: &str, of_message: Option<usize>) -> Option<String> {
        let file = self.place.join(task).with_extension("rs");
        let text = self.answer(task)?.text.as_ref().ok()?;
        let line = |sign: &str| {
            let mut lines = text.lines().map(str::trim_start);
            Some(lines.position(|line| line.starts_with(sign))? + 1)
        };
        let mut signs = ["todo!", "pub fn ", "fn "].into_iter();
        let line = of_message.or_else(|| signs.find_map(line)).unwrap_or(1);
        let file = from_here(&file).display().to_string();
        self.place.is_dir().then(|| format!("{file}:{line}"))
    }

    fn unpack(
        path: &Path,
        read_from: PathBuf,
        assignment: &Assignment,
    ) -> Result<Option<Submission>> {
        let mut archive = archive::open(&read_from)?;
        let holds_any = |place: &String| {
            let mut tasks = assignment.tasks.iter();
            tasks.any(|task| archive.holds(&format!("{place}{}", task.file())))
        };
        let Some(place) = archive.places().into_iter().find(holds_any) else {
            return Ok(None);
        };
        let answers = assignment.answerable().filter_map(|task| {
            let text = archive.text(&format!("{place}{}", task.file()));
            Answer::of(assignment, task, text)
        });
        let answers = answers.collect();
        let examples = assignment.with_examples().map(|task| Answer {
            task: task.name.clone(),
            text: archive.text(&format!("{place}{}", examples_file(&task.name))),
        });
        Ok(Some(Submission {
            answers,
            examples: examples.collect(),
            folder: path.into(),
            place: path.into(),
            read_from,
        }))
    }

    /// The answers and the examples: the name of each file, and its text.
    pub fn files(&self) -> impl Iterator<Item = (String, &Text)> {
        let answers = self.answers.iter();
        let answers = answers.map(|it| (format!("{}.rs", it.task), &it.text));
        let examples = self.examples.iter();
        answers.chain(examples.map(|it| (examples_file(&it.task), &it.text)))
    }

    /// The text of the answer file or the file of examples that has this name.
    pub fn text(&self, file: &str) -> Option<&Text> {
        let (_, text) = self.files().find(|(name, _)| name == file)?;
        Some(text)
    }

    /// The answer to this task.
    pub fn answer(&self, task: &str) -> Option<&Answer> {
        self.answers.iter().find(|answer| answer.task == task)
    }
}

fn empty(folder: &Path, assignment: &Assignment) -> Error {
    let files: Vec<String> = assignment.tasks.iter().map(|task| task.file()).collect();
    Error::input(
        format!("{} holds no answer file", folder.display()),
        format!(
            "name a folder or ZIP file that has one of these, at its top or in `src`: {}",
            files.join(", ")
        ),
    )
}

/// Whether a folder may hold answers. Folders left by archivers and version control may not.
fn is_ordinary(name: &str) -> bool {
    !name.starts_with('.') && !name.starts_with("__")
}

fn places(folder: &Path) -> Result<Vec<PathBuf>> {
    // A link could lead to another student's answers.
    let is_own = |place: &PathBuf| !place.is_symlink();
    let mut places = vec![folder.into()];
    places.extend(Some(folder.join("src")).filter(is_own));
    let inside = fs::read_dir(folder).or_fail(&text::unreadable(folder))?;
    let folders: Vec<PathBuf> = inside
        .flatten()
        .filter(|entry| entry.file_name().to_str().is_some_and(is_ordinary))
        .map(|entry| entry.path())
        .filter(|path| path.is_dir() && !path.is_symlink())
        .filter(|path| *path != folder.join("src"))
        .collect();
    if let [only] = folders.as_slice() {
        places.push(only.clone());
        places.extend(Some(only.join("src")).filter(is_own));
    }
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn answers_are_not_trusted_because_their_name_leads_into_the_checkout_later() {
        use std::os::unix::fs::symlink;

        let checkout = Checkout::find().unwrap();
        let name = checkout.default_assignment().unwrap();
        let assignment = Assignment::read(&checkout, &name).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let [own, link] = ["own/src", "link"].map(|name| folder.path().join(name));
        fs::create_dir_all(&own).unwrap();
        fs::write(own.join(assignment.tasks[0].file()), "").unwrap();
        for (target, is_trusted) in [("own".into(), false), (assignment.reference(), true)] {
            symlink(&target, &link).unwrap();
            let submission = Submission::find(&link, &assignment).unwrap();
            assert_eq!(submission.place, link.join("src"));
            fs::remove_file(&link).unwrap();
            symlink(assignment.handout(), &link).unwrap();
            assert_eq!(checkout.contains(&submission.read_from), is_trusted);
            fs::remove_file(&link).unwrap();
        }
    }

    #[test]
    fn only_the_answers_that_a_command_takes_by_itself_need_no_name() {
        let assignments = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assignments");
        let is_default = |folder: &str| Submission::is_default(&assignments.join(folder));
        assert!(is_default("ray_casting/handout"));
        assert!(is_default("ray_casting/handout/src"));
        assert!(!is_default("ray_casting/reference"));
        // Commands at the top take another assignment.
        assert!(!is_default("bounding_volumes/handout"));
        assert!(!is_default("no-such-folder"));
    }
}
