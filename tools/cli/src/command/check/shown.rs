//! Shows what `check` has found out.

use std::path::{Path, PathBuf};

use super::again;
use crate::cli::Check;
use crate::command::read;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::explanation::{Mitsuba, PixelAsker};
use pinhole_course::outcome::{AnswerFile, Examination, Outcome, TaskOutcome};
use pinhole_course::shell::from_here;
use pinhole_course::submission::Submission;
use pinhole_course::timings::Timings;
use pinhole_report::escape::printable;
use pinhole_report::finish::Finish;
use pinhole_report::html::{FinishSection, Report};
use pinhole_report::passage::{self, Passage};
use pinhole_report::{json, terminal};

/// What `check` has found out, to be shown.
pub struct Checked<'a> {
    pub arguments: &'a Check,
    pub checkout: &'a Checkout,
    pub examiner: &'a Examiner<'a>,
    pub submission: &'a Submission,
    pub selection: &'a Selection,
    pub examination: &'a Examination,
}

/// An archive for handing in, and how many files it holds.
pub type Packed<'a> = (&'a Path, usize);

impl Checked<'_> {
    /// The picture for a student who has all points.
    fn finish(&self) -> Option<Finish> {
        let again = again(self.arguments);
        Finish::of(self.examination, self.examiner.assignment, &again.part)
    }

    pub fn write_report(&self, path: PathBuf) -> Result<PathBuf> {
        let golden = &self.examiner.goldens.folder;
        let mut report = Report::of_examination(self.examination, golden, &again(self.arguments))?;
        report.book = passage::built(self.checkout.root());
        report.finish = self.finish().map(FinishSection::of);
        report.write(&path).map(|()| path)
    }

    pub fn print_json(&self, report: Option<&Path>, packed: Option<Packed>) {
        let mut document = json::document(&self.examination.outcome);
        document["report"] = report.map(|path| path.display().to_string()).into();
        if let Some((zip, _)) = packed {
            document["packed"] = zip.display().to_string().into();
        }
        if self.arguments.timings {
            document["timings"] = json::document(&Timings::so_far());
        }
        anstream::println!("{document:#}");
    }

    pub fn print(&self, report: Option<&Path>, packed: Option<Packed>) -> Result<()> {
        let outcome = &self.examination.outcome;
        anstream::print!("{}", terminal::examination(self.examination));
        if let Some(path) = report {
            let path = from_here(path).display().to_string();
            anstream::println!("\nreport: {}", printable(&path));
        }
        let zip = packed.map(|(zip, files)| {
            let zip = printable(&zip.display().to_string());
            let answers = match (files, self.submission.examples.is_empty()) {
                (1, _) => "answer",
                (_, true) => "answers",
                (_, false) => "files",
            };
            let rest = worth_of_packed(outcome, self.selection.is_everything());
            anstream::println!("packed: {zip} holds {files} {answers}; {rest}");
            zip
        });
        match self.finish() {
            Some(finish) => {
                let pack = zip.unwrap_or(finish.pack);
                show_finish(&Finish { pack, ..finish }, &self.checkout.scratch())?;
            }
            None => show_next(self.examiner, self.submission, self.examination)?,
        }
        if self.arguments.timings {
            anstream::print!("\n{}", Timings::so_far());
        }
        let wants_to_read = self.arguments.read;
        if let Some(passage) = wants_to_read.then(|| worth_reading(outcome)).flatten() {
            read::open(&passage, self.checkout);
        }
        Ok(())
    }
}

/// Prints the file to edit next. It belongs to the task to begin with, if that lacks points, or
/// else to the first task that does. If none does, it belongs to the task that makes a scene fail.
fn show_next(
    examiner: &Examiner,
    submission: &Submission,
    examination: &Examination,
) -> Result<()> {
    let tasks = examination.outcome.tasks.iter();
    let failing = || tasks.clone().filter(|task| !task.passes());
    let start = failing().find(|task| task.name == examiner.assignment.start);
    let next = match start.or_else(|| failing().next()) {
        Some(task) => Some((task.name.clone(), task.line())),
        None => task_at_fault(examiner, examination)?.map(|task| (task, None)),
    };
    let place = next.and_then(|(task, line)| submission.place_to_edit(&task, line));
    if let Some(place) = place {
        anstream::println!("edit: {}", printable(&place));
    }
    Ok(())
}

/// The task that makes a scene fail, as far as the first failing scene shows it: by what was
/// measured in its answers, or by the scene's first pixel without a usable answer, or its worst.
fn task_at_fault(examiner: &Examiner, examination: &Examination) -> Result<Option<String>> {
    let scenes = examination.outcome.scenes.iter().zip(&examination.films);
    let mut failing = scenes.filter(|(scene, _)| !scene.outcome.passes());
    let Some((_, film)) = failing.next() else {
        return Ok(None);
    };
    if let Some((task, _)) = examination.suspects(film).first() {
        return Ok(Some((*task).to_owned()));
    }
    let unanswered = film.unanswered.map(|unanswered| unanswered.pixel);
    let worst = || {
        let (_, pixel) = terminal::worst_pixel(&film.verdict.as_ref()?.channels)?;
        Some(pixel)
    };
    let Some(pixel) = unanswered.or_else(worst) else {
        return Ok(None);
    };
    let (scene, golden) = examiner.assignment.find_scene(&film.argument)?;
    let asker = PixelAsker {
        program: examiner.program,
        sandbox: examiner.sandbox,
        assignment: examiner.assignment,
        wall: examiner.wall,
    };
    let mitsuba = Mitsuba::read(golden, scene.resolution.index(pixel))?;
    let explanation = asker.explain(&scene, pixel, mitsuba)?;
    let task = explanation.task_at_fault(&scene.objects, examiner.assignment);
    Ok(task.map(|task| task.name.clone()))
}

/// What to know before handing in: which answers are still stubs and, if everything was judged, the
/// points.
fn worth_of_packed(outcome: &Outcome, is_everything: bool) -> String {
    let points = outcome.points.filter(|_| is_everything && !outcome.passes);
    let points = points.map(|points| format!("they have {points} of {} points", outcome.possible));
    let is_stub = |task: &&TaskOutcome| task.is_unanswered() && task.file == AnswerFile::Compiled;
    let tasks = outcome.tasks.iter().filter(is_stub);
    let stubs: Vec<String> = tasks.map(|task| format!("`{}`", task.name)).collect();
    let are = if stubs.len() == 1 {
        "is still the stub"
    } else {
        "are still stubs"
    };
    let stubs = (!stubs.is_empty()).then(|| format!("{} {are}", stubs.join(", ")));
    let known: Vec<String> = stubs.into_iter().chain(points).collect();
    match known.is_empty() {
        true if outcome.passes => "hand it in".into(),
        true => "not all of them are right yet".into(),
        false => known.join("; "),
    }
}

/// The picture of a student who has all points, and what to do next.
fn show_finish(finish: &Finish, folder: &Path) -> Result<()> {
    let path = folder.join("finish.png");
    finish.save(&path)?;
    if terminal::shows_pictures() {
        anstream::print!("\n{}", finish.in_blocks(MOST_COLUMNS));
    }
    anstream::print!("\n{}{}", finish.caption(&from_here(&path)), finish.words());
    Ok(())
}

/// Narrow enough for any usual terminal.
const MOST_COLUMNS: usize = 72;

/// The passage of the book about the first task or scene that fails.
fn worth_reading(outcome: &Outcome) -> Option<Passage> {
    let mut tasks = outcome.tasks.iter();
    let task = tasks.find(|task| !task.passes());
    let scenes = outcome.scenes.iter();
    let mut scenes = scenes.filter(|scene| !scene.diagnosis.is_empty());
    match (task, scenes.next()) {
        (Some(task), _) => Passage::against(&task.diagnosis, &task.chapter),
        (None, Some(scene)) => Passage::against(&scene.diagnosis, ""),
        (None, None) => Vec::new(),
    }
    .into_iter()
    .next()
}
