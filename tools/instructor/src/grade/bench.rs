//! One submission, from what was handed in to its record and its report.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use super::again::{deny, most_for_scenes, worth_asking_again};
use super::clock::{Pace, SubmissionClock};
use super::intake::Entry;
use super::kept::{flagged, scenes, tasks};
use super::kind::Kind;
use super::provenance::{MadeWith, Provenance};
use super::record::{Record, SCHEMA, Timings};
use super::withheld::{self, Withheld};
use pinhole_course::assignment::Assignment;
use pinhole_course::compile::{Compiler, Program};
use pinhole_course::error::Result;
use pinhole_course::examination::Examination;
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::goldens::Goldens;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::submission::Submission;
use pinhole_report::html::{Again, Report};

/// More of what a student's code prints is not kept.
const MOST_PRINTED: usize = 16 * 1024;

/// What the whole class is graded with.
pub struct Bench<'a> {
    pub assignment: &'a Assignment,
    pub goldens: &'a Goldens,
    /// Questions nobody has seen; a group counts only if it passes these too.
    pub fresh: Option<&'a Goldens>,
    /// What is withheld; of fresh questions as much is shown.
    pub withheld: Withheld,
    pub compiler: &'a Compiler,
    pub sandbox: &'a Sandbox,
    pub pace: &'a Pace,
    /// Where programs lie while they are asked.
    pub rooms: &'a Path,
    pub made_with: &'a MadeWith,
}

/// A folder for one submission's programs, gone when it is graded: a class's would fill the
/// disk, and nobody is to find another's.
struct Room {
    folder: PathBuf,
}

impl Room {
    fn new(rooms: &Path) -> Room {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        Room {
            folder: rooms.join(number.to_string()),
        }
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        let _left_for_the_next_run = fs::remove_dir_all(&self.folder);
    }
}

/// A record, and its report if there is a grade.
pub struct Graded {
    pub record: Record,
    pub report: Option<String>,
}

impl Bench<'_> {
    /// Grades a submission. Whatever goes wrong here is told in the record: it stops
    /// nobody else, and is nobody's zero.
    ///
    /// `None` if an answer came too late and it was not `alone`: see [`clock`](super::clock).
    pub fn grade(&self, entry: &Entry, submission: &Submission, alone: bool) -> Option<Graded> {
        let clock = SubmissionClock::new(self.pace, alone);
        let work = AssertUnwindSafe(|| self.try_grade(entry, submission, &clock));
        let fault = match catch_unwind(work) {
            Ok(Ok(mut graded)) => {
                graded.record.timings.second_runs = u32::from(alone);
                return Some(graded);
            }
            Ok(Err(_)) if clock.was_late() => return None,
            Ok(Err(error)) => error.to_string(),
            Err(_) => "the grader itself failed; please report it".into(),
        };
        Some(Graded {
            record: self.blank(entry, submission).not_graded(fault),
            report: None,
        })
    }

    /// What is known of a submission before anything was asked.
    pub fn blank(&self, entry: &Entry, submission: &Submission) -> Record {
        let scenes = self.goldens.scenes.iter().map(|scene| scene.worth);
        let groups = self.assignment.tasks.iter().flat_map(|task| &task.points);
        Record {
            schema: SCHEMA,
            id: entry.id.clone(),
            name: entry.name.clone(),
            assignment: self.assignment.title.clone(),
            outcome: Kind::NotGraded,
            explanation: String::new(),
            points: None,
            possible: scenes.sum::<u32>() + groups.map(|points| points.worth).sum::<u32>(),
            tasks: Vec::new(),
            scenes: Vec::new(),
            fresh_scenes: Vec::new(),
            most_for_scenes: None,
            flags: Vec::new(),
            provenance: Provenance::of(submission, self.made_with),
            timings: Timings::default(),
            printed: String::new(),
        }
    }

    fn try_grade(
        &self,
        entry: &Entry,
        submission: &Submission,
        clock: &SubmissionClock,
    ) -> Result<Graded> {
        let start = Instant::now();
        let room = Room::new(self.rooms);
        let sandbox = self.sandbox.anew();
        let compiler = self.compiler.apart(&sandbox, room.folder.clone());
        let program = compiler.compile(submission)?;
        let compiled = start.elapsed();
        let everything = Selection::default();
        let mut examination = self.examine(
            self.goldens,
            &program,
            &sandbox,
            submission,
            &everything,
            clock,
        )?;
        examination.submission = entry.name.clone();
        let fresh = match (self.fresh, worth_asking_again(&examination)) {
            (Some(goldens), Some(selection)) => {
                Some(self.examine(goldens, &program, &sandbox, submission, &selection, clock)?)
            }
            _ => None,
        };
        let failed = fresh.as_ref().map(|fresh| deny(&mut examination, fresh));
        let failed = failed.unwrap_or_default();
        let asked = start.elapsed();

        let mut record = self.blank(entry, submission);
        record.tasks = tasks(&examination, submission, &failed, &self.withheld);
        record.scenes = scenes(&examination.scenes, |name| self.withheld.scene(name));
        if let Some(fresh) = &fresh {
            record.fresh_scenes = scenes(&fresh.scenes, |_| Some(self.withheld.reveal));
            record.most_for_scenes = Some(most_for_scenes(&record));
        }
        let kinds = record.tasks.iter().map(|task| task.outcome);
        let kinds = kinds.chain(record.scenes.iter().map(|scene| scene.outcome));
        record.outcome = kinds.min().unwrap_or(Kind::Graded);
        record.explanation = record.outcome.explained().into();
        let by_tasks: u32 = record.tasks.iter().map(|task| task.points).sum();
        record.points = Some(by_tasks + record.scene_points().0);
        if !self.withheld.any() {
            let end = examination.printed.floor_char_boundary(MOST_PRINTED);
            record.printed = examination.printed[..end].into();
        }
        record.flags = flagged(submission);
        let page = self.report(&record, &examination, &failed)?.html();
        let total = start.elapsed();
        record.timings = Timings {
            total: total.as_secs_f64(),
            compiling: compiled.as_secs_f64(),
            asking: (asked - compiled).as_secs_f64(),
            report: (total - asked).as_secs_f64(),
            second_runs: 0,
        };
        Ok(Graded {
            record,
            report: Some(page),
        })
    }

    fn examine(
        &self,
        goldens: &Goldens,
        program: &Program,
        sandbox: &Sandbox,
        submission: &Submission,
        selection: &Selection,
        clock: &SubmissionClock,
    ) -> Result<Examination> {
        let examiner = Examiner {
            assignment: self.assignment,
            goldens,
            program,
            sandbox,
            wall: Duration::MAX,
            second_judge: None,
            clock: Some(clock),
            progress: &|_, _| {},
        };
        examiner.examine(submission, selection)
    }

    fn report(
        &self,
        record: &Record,
        examination: &Examination,
        failed: &[(String, String)],
    ) -> Result<Report> {
        let command = format!("{} check", pinhole_course::shell::PINHOLE);
        let again = Again {
            whole: command.clone(),
            part: command,
        };
        let mut report = Report::of_examination(examination, &self.goldens.folder, &again)?;
        withheld::veil(&mut report, examination, &self.withheld, failed);
        report
            .of
            .push(("judged on", record.provenance.made_with.judged_on.clone()));
        report
            .of
            .push(("sandbox", record.provenance.made_with.sandbox.clone()));
        report.points = record.points.map(|points| (points, record.possible));
        report.passes = record.points == Some(record.possible);
        if record.outcome != Kind::Graded {
            report.said = format!("{} {}", report.said, record.explanation);
        }
        if let Some(most) = record.most_for_scenes
            && record.scenes.iter().map(|scene| scene.points).sum::<u32>() > most
        {
            report.said.push_str(&format!(
                " The scenes earn {most} points at most, as the answers behind them did on \
                 questions that nobody had seen."
            ));
        }
        Ok(report)
    }
}
