//! Decides which of a person's files answers which task.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use super::hand_in::Upload;
use super::reader::Content;
use super::reader::file_names::{first, quoted};
use super::task_names::{file_of, is_similar};
use pinhole_course::assignment::{Assignment, Task, examples_file};
use pinhole_course::stubs;
use pinhole_course::submission::text::Text;
use pinhole_course::submission::{Answer, AnswerFileProblem, Submission};

/// The answers that were found, and notes on how they were read.
#[derive(Clone, Debug)]
pub struct Choice {
    pub submission: Submission,
    /// What had to be done to read them. It is certain that these answers were meant.
    pub notes: Vec<String>,
    /// Why other answers may have been meant, which the instructor should check.
    pub doubts: Vec<String>,
}

/// A file that may answer a task.
struct Candidate<'a> {
    upload: &'a Upload,
    text: &'a Text,
    note: Option<&'static str>,
    is_exact: bool,
}

impl Candidate<'_> {
    fn path(&self) -> String {
        self.upload.path.join("/")
    }

    /// The depth of the folder that contains the file, or of its package if the file is in `src`.
    fn depth(&self) -> usize {
        let folders = &self.upload.path[..self.upload.path.len() - 1];
        folders.len() - usize::from(folders.last().is_some_and(|last| last == "src"))
    }

    /// The folder of the course's repository, if the file is where the repository keeps a student's
    /// answers.
    fn repository(&self, assignment: &Assignment) -> Option<&[String]> {
        match &self.upload.path[..] {
            [root @ .., assignments, name, handout, src, _]
                if assignments == "assignments" && handout == "handout" && src == "src" =>
            {
                (*name == assignment.name).then_some(root)
            }
            [root @ .., handout, src, _] if handout == "handout" && src == "src" => Some(root),
            _ => None,
        }
    }
}

/// A person's files, by what they may be.
struct Files<'a> {
    /// Files that may answer tasks, each with the name of the answer file that it may be.
    candidates: Vec<(String, Candidate<'a>)>,
    /// Copies of the course's repository. If there are any, candidates are only in them, because a
    /// copy contains files of the same names elsewhere too.
    roots: BTreeSet<Vec<String>>,
    /// Files beside these copies that would be candidates otherwise.
    elsewhere: Vec<(String, Candidate<'a>)>,
    refused: Vec<String>,
    others: Vec<String>,
}

impl<'a> Files<'a> {
    /// `Err` if the machine could not read a file that may be an answer.
    fn sort(
        submission: &str,
        uploads: &'a [Upload],
        assignment: &Assignment,
    ) -> Result<Files<'a>, String> {
        let mut refused = Vec::new();
        let mut others = Vec::new();
        let mut candidates: Vec<(String, Candidate)> = Vec::new();
        for upload in uploads {
            let path = upload.name(submission);
            match &upload.content {
                Content::Unreadable(why) => return Err(format!("`{path}`: {why}")),
                Content::Refused(why) => refused.push(format!("`{path}`: {why}")),
                Content::Answer { text, note } => {
                    let name = upload.path.last().map(String::as_str).unwrap_or_default();
                    let Some((file, is_exact)) = file_of(name, assignment) else {
                        others.push(path);
                        continue;
                    };
                    let candidate = Candidate {
                        upload,
                        text,
                        note: *note,
                        is_exact,
                    };
                    candidates.push((file, candidate));
                }
                Content::Other => others.push(path),
                Content::Folder => {}
            }
        }
        let all = candidates.iter();
        let roots = all.filter_map(|(_, one)| one.repository(assignment));
        let roots: BTreeSet<Vec<String>> = roots.map(<[String]>::to_vec).collect();
        let is_elsewhere = |(_, one): &mut (_, Candidate)| {
            !roots.is_empty() && one.repository(assignment).is_none()
        };
        let elsewhere = candidates.extract_if(.., is_elsewhere).collect();
        Ok(Files {
            candidates,
            roots,
            elsewhere,
            refused,
            others,
        })
    }

    fn candidates(&self, file: &str) -> Vec<&Candidate<'a>> {
        let own = self.candidates.iter().filter(|(other, _)| other == file);
        own.map(|(_, candidate)| candidate).collect()
    }

    /// Whether the course's repository has a file in the same place.
    fn is_of_course(&self, path: &[String], assignment: &Assignment) -> bool {
        let inside = (0..path.len()).filter(|at| self.roots.contains(&path[..*at]));
        let course = assignment.course();
        let mut places = inside.map(|at| course.join(path[at..].iter().collect::<PathBuf>()));
        places.any(|place| place.is_file())
    }
}

/// Finds the answers to all tasks. The newest upload counts, and in it, the files at the top or
/// in `src`. `Err` if the machine could not read a file that may be an answer.
pub fn choose(name: &str, uploads: &[Upload], assignment: &Assignment) -> Result<Choice, String> {
    let files = Files::sort(name, uploads, assignment)?;
    let mut choice = Choice {
        submission: Submission {
            folder: PathBuf::from(name),
            read_from: PathBuf::from(name),
            place: PathBuf::from(name),
            answers: Vec::new(),
            examples: Vec::new(),
        },
        notes: Vec::new(),
        doubts: Vec::new(),
    };
    choice.take_answers(&files, assignment);
    choice.doubt_files_elsewhere(&files, assignment);
    let Files {
        candidates,
        refused,
        others,
        ..
    } = &files;
    let is_theirs = |path: &&String| {
        let path: Vec<String> = path.split('/').map(str::to_owned).collect();
        !files.is_of_course(&path, assignment)
    };
    let theirs: Vec<&String> = others.iter().filter(is_theirs).collect();
    for task in &assignment.tasks {
        choice.doubt_unanswered(task, &theirs, assignment);
    }
    if candidates.is_empty() && refused.is_empty() && !others.is_empty() {
        let note = format!(
            "no answer file was handed in, only {}",
            quoted(others).join(", ")
        );
        choice.doubts.push(note);
    } else if !candidates.is_empty() {
        choice.doubts.extend(first(refused));
    }
    Ok(choice)
}

impl Choice {
    /// Takes the answers to all tasks, and the files of examples.
    fn take_answers(&mut self, files: &Files, assignment: &Assignment) {
        let mut replaced = Vec::new();
        let answers = assignment.answerable().map(|task| (task, false));
        let examples = assignment.with_examples().map(|task| (task, true));
        for (task, is_of_examples) in answers.chain(examples) {
            let file = match is_of_examples {
                true => examples_file(&task.name),
                false => task.file(),
            };
            let own = files.candidates(&file);
            if own.is_empty() && assignment.task(&task.name).is_none() {
                continue;
            }
            let text = match own.is_empty() {
                true if files.refused.is_empty() => Err(AnswerFileProblem::Missing),
                true => Err(AnswerFileProblem::Refused(first(&files.refused).join("; "))),
                false => self.of(&file, &own),
            };
            let (submission, name) = (&mut self.submission, task.name.clone());
            match is_of_examples {
                true => submission.examples.push(Answer { task: name, text }),
                false => submission
                    .answers
                    .extend(Answer::of(assignment, task, text)),
            }
            let newest = own.iter().map(|one| one.upload.order).max();
            let is_older = |one: &&&Candidate| Some(one.upload.order) < newest;
            let text = self.submission.text(&file);
            let differs = |one: &&Candidate| text.is_some_and(|text| said(text) != said(one.text));
            if own.iter().filter(is_older).any(differs) {
                replaced.push(file);
            }
        }
        if !replaced.is_empty() {
            let (files, those) = match replaced.len() {
                1 => (replaced[0].clone(), "an earlier one"),
                _ => (replaced.join(", "), "earlier ones"),
            };
            let note = format!("{files}: the newest upload was taken, which differs from {those}");
            self.notes.push(note);
        }
    }

    /// Lists files outside of copies of the course's repository that differ from the answers in them.
    fn doubt_files_elsewhere(&mut self, files: &Files, assignment: &Assignment) {
        let differs = |(file, one): &&(String, Candidate)| {
            let own = self.submission.text(file);
            let is_other = own.is_some_and(|text| said(text) != said(one.text));
            is_other && !is_stub(one.text, file, assignment)
        };
        let differing = files.elsewhere.iter().filter(differs);
        let outside = differing.map(|(_, one)| one);
        let outside: Vec<String> = outside
            .filter(|one| !files.is_of_course(&one.upload.path, assignment))
            .map(Candidate::path)
            .collect();
        if !outside.is_empty() {
            self.doubts.push(format!(
                "the files in `handout/src` were taken instead of {}",
                quoted(&outside).join(", ")
            ));
        }
    }

    /// The text of the best candidate, if one is better than all others.
    fn of(&mut self, file: &str, all: &[&Candidate]) -> Text {
        let newest = all.iter().map(|one| one.upload.order).max();
        let mut best: Vec<&&Candidate> = all.iter().collect();
        best.retain(|one| Some(one.upload.order) == newest);
        let at_hand = best.clone();
        let depth = best.iter().map(|one| one.depth()).min();
        best.retain(|one| Some(one.depth()) == depth);
        let is_exact = best.iter().any(|one| one.is_exact);
        best.retain(|one| one.is_exact == is_exact);

        let texts: BTreeSet<&str> = best.iter().map(|one| said(one.text)).collect();
        if texts.len() > 1 {
            let paths: Vec<String> = best.iter().map(|one| one.path()).collect();
            return Err(AnswerFileProblem::Refused(format!(
                "there are {} files that could be `{file}`, and they differ: {}",
                paths.len(),
                quoted(&paths).join(", ")
            )));
        }
        let chosen = best[0];
        let differs = |one: &&&&Candidate| said(one.text) != said(chosen.text);
        let left: Vec<String> = at_hand
            .iter()
            .filter(differs)
            .map(|one| one.path())
            .collect();
        if !left.is_empty() {
            let taken = chosen.path();
            let role = match taken == file {
                true => String::new(),
                false => format!(" as `{file}`"),
            };
            let left = quoted(&left).join(", ");
            self.doubts
                .push(format!("`{taken}` was taken{role} instead of {left}"));
        } else if !chosen.is_exact {
            self.notes
                .push(format!("`{}` was taken as `{file}`", chosen.path()));
        }
        if let Some(note) = chosen.note {
            self.notes.push(format!("`{}` {note}", chosen.path()));
        }
        chosen.text.clone()
    }

    /// If the answer to a task is missing or the untouched stub, lists files with similar names.
    fn doubt_unanswered(&mut self, task: &Task, others: &[&String], assignment: &Assignment) {
        let mut answers = self.submission.answers.iter();
        let own = answers.find(|answer| answer.task == task.name);
        let why = match own.map(|own| &own.text) {
            Some(Err(AnswerFileProblem::Missing)) => "is missing",
            Some(text) if is_stub(text, &task.file(), assignment) => "is the stub, unchanged",
            _ => return,
        };
        let similar = others.iter().filter(|path| {
            let name = path.rsplit('/').next().unwrap_or_default();
            is_similar(name, task)
        });
        let similar: Vec<String> = similar.map(|path| format!("`{path}`")).collect();
        if !similar.is_empty() {
            self.doubts.push(format!(
                "`{}` {why}; is {} meant?",
                task.file(),
                first(&similar).join(" or ")
            ));
        }
    }
}

/// Whether this is the stub in `file`.
fn is_stub(text: &Text, file: &str, assignment: &Assignment) -> bool {
    let stub = assignment.handout().join("src").join(file);
    let stub = fs::read_to_string(stub).unwrap_or_default();
    let text = text.as_ref();
    text.is_ok_and(|text| stubs::is_unchanged(&stub, text))
}

/// What distinguishes two files: their texts or, if they were refused, the reasons.
fn said(text: &Text) -> &str {
    match text {
        Ok(text) => text,
        Err(AnswerFileProblem::Refused(why)) => why,
        Err(AnswerFileProblem::Missing) => "",
    }
}
