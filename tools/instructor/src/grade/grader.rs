//! Grades one submission, from its files to its record and report.

pub mod clock;
pub mod fresh;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use self::clock::{Pace, SubmissionClock};
use self::fresh::revoke_failing_fresh;
use super::evidence::Evidence;
use super::intake::Entry;
use super::points;
use super::provenance::{GradingInputs, Provenance};
use super::record::{Record, SceneNeeds, Timings, explained};
use super::redact::{Withheld, redact_scene};
use super::shared_answers;
use pinhole_course::assignment::{Assignment, Task};
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::{Attempt, Compiler, Program};
use pinhole_course::error::{Error, Result};
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::examples::add_handed_in;
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::{Examination, Outcome, Status};
use pinhole_course::sandbox::Sandbox;
use pinhole_course::submission::Submission;
use pinhole_course::timings::timed;
use pinhole_report::escape::printable;
use pinhole_report::html::{RepeatCommands, Report};

/// The most bytes that are kept of what a student's code prints.
const MOST_PRINTED: usize = 16 * 1024;

/// Everything that the whole class is graded with.
pub struct Grader<'a> {
    pub assignment: &'a Assignment,
    pub checkout: &'a Checkout,
    pub goldens: &'a Goldens,
    /// Fresh questions; a group earns its points only if it passes these too.
    pub fresh: Option<&'a Goldens>,
    /// What is withheld, and how much of it is shown. As much is shown of fresh questions.
    pub withheld: Withheld,
    pub compiler: &'a Compiler,
    pub sandbox: &'a Sandbox,
    pub pace: &'a Pace,
    /// The folder that contains each submission's programs while they run.
    pub programs: &'a Path,
    pub made_with: &'a GradingInputs,
}

/// A folder for one submission's programs, which is removed after grading. Otherwise, the
/// programs of a class would fill the disk, and a submission might find another's.
struct ProgramFolder {
    folder: PathBuf,
}

impl ProgramFolder {
    fn new(programs: &Path) -> ProgramFolder {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        ProgramFolder {
            folder: programs.join(number.to_string()),
        }
    }
}

impl Drop for ProgramFolder {
    fn drop(&mut self) {
        let _left_for_the_next_run = fs::remove_dir_all(&self.folder);
    }
}

/// A record, and its report if there is a grade.
pub struct Grade {
    pub record: Record,
    pub report: Option<String>,
    pub evidence: Option<Evidence>,
}

impl Grader<'_> {
    /// Grades a submission. If the grader itself fails, the record says so, the submission gets
    /// no mark instead of a zero, and other submissions are still graded.
    ///
    /// `None` if an answer or the compiler took too long, or the grader failed, and the submission
    /// was not `alone`: see [`clock`].
    pub fn grade(&self, entry: &Entry, submission: &Submission, alone: bool) -> Option<Grade> {
        let clock = SubmissionClock::new(self.pace, alone);
        let work = AssertUnwindSafe(|| self.try_grade(entry, submission, &clock));
        let fault = match catch_unwind(work) {
            Ok(Ok(mut graded)) => {
                graded.record.timings.second_runs = u32::from(alone);
                return Some(graded);
            }
            // Perhaps there were too many processes for the machine.
            Ok(Err(_)) | Err(_) if !alone => return None,
            Ok(Err(error)) => error.to_string(),
            Err(_) => "the grader itself failed; please report it".into(),
        };
        Some(Grade {
            record: self.blank(entry, submission).not_graded(fault),
            report: None,
            evidence: None,
        })
    }

    /// The record of a submission before anything was asked.
    pub fn blank(&self, entry: &Entry, submission: &Submission) -> Record {
        let scenes = self.goldens.scenes.iter().map(|scene| scene.worth);
        let groups = self.assignment.tasks.iter().flat_map(Task::all_points);
        let (title, name) = (&self.assignment.title, entry.name.clone());
        let answers = submission.answers.iter().filter_map(|answer| {
            let hash = shared_answers::tokens(answer.text.as_ref().ok()?)?;
            Some((answer.task.clone(), hash))
        });
        Record {
            id: entry.id.clone(),
            status: Status::NotGraded,
            explanation: String::new(),
            got: Outcome {
                passes: false,
                points: None,
                possible: scenes.sum::<u32>() + groups.map(|points| points.worth).sum::<u32>(),
                ..Outcome::new(title, name, self.sandbox.name())
            },
            remarks: entry.remarks(),
            fresh_scenes: Vec::new(),
            most_for_scenes: None,
            needs: SceneNeeds::default(),
            tokens: answers.collect(),
            provenance: Provenance::of(submission, self.made_with),
            timings: Timings::default(),
        }
    }

    fn try_grade(
        &self,
        entry: &Entry,
        submission: &Submission,
        clock: &SubmissionClock,
    ) -> Result<Grade> {
        let start = Instant::now();
        let folder = ProgramFolder::new(self.programs);
        let sandbox = self.sandbox.new_instance(self.pace.whole())?;
        let compiler = self.compiler.apart(&sandbox, folder.folder.clone());
        let compiler = compiler.stopping_when_late(!clock.is_alone());
        let program = match compiler.compile_until(submission, &mut |_| false)? {
            Attempt::Late => return Err(SubmissionClock::late()),
            Attempt::Enough => unreachable!("compiling is never stopped early"),
            Attempt::Program(program) => program,
        };
        let compiled = start.elapsed();
        let (mut examination, fresh) = self.examine(submission, &program, &sandbox, clock)?;
        if sandbox.is_starved() {
            return Err(Error::environment(
                "other programs on this machine kept it from running",
                "grade it again when the machine is less busy",
            ));
        }
        let outcome = &mut examination.outcome;
        add_handed_in(outcome, submission, self.assignment, self.checkout, false)?;
        let asked = start.elapsed();

        let mut record = self.blank(entry, submission);
        let asked_fresh = fresh.as_ref().zip(self.fresh);
        let asked_fresh = asked_fresh.map(|(it, goldens)| (&it.outcome, goldens.folder.as_path()));
        let evidence = Evidence::new(&entry.id, submission, &examination.outcome, asked_fresh);
        let got = &mut examination.outcome;
        got.submission = entry.name.clone();
        if let Some(fresh) = &fresh {
            revoke_failing_fresh(got, &fresh.outcome);
        }
        self.withheld.redact(got);
        record.status = got.status();
        record.explanation = explained(record.status).into();
        record.got = got.clone();
        if let Some(fresh) = fresh {
            record.fresh_scenes = fresh.outcome.scenes;
            for scene in &mut record.fresh_scenes {
                redact_scene(scene, self.withheld.reveal);
            }
            record.needs = self.needs()?;
            record.most_for_scenes = Some(0);
        }
        points::compute(&mut record, self.assignment);
        examination.outcome = record.got.clone();
        let report = || Ok(self.report(&record, &examination)?.html());
        let page: Result<String> = timed("write the report", report);
        let page = page?;
        let printed = &mut record.got.printed;
        printed.truncate(printed.floor_char_boundary(MOST_PRINTED));
        let total = start.elapsed();
        record.timings = Timings {
            total: total.as_secs_f64(),
            compiling: compiled.as_secs_f64(),
            asking: (asked - compiled).as_secs_f64(),
            report: (total - asked).as_secs_f64(),
            second_runs: 0,
        };
        Ok(Grade {
            record,
            report: Some(page),
            evidence: Some(evidence),
        })
    }

    /// Asks the questions of the goldens and, if there are any, fresh questions.
    fn examine(
        &self,
        submission: &Submission,
        program: &Program,
        sandbox: &Sandbox,
        clock: &SubmissionClock,
    ) -> Result<(Examination, Option<Examination>)> {
        let examiner = |goldens, withheld| Examiner {
            assignment: self.assignment,
            goldens,
            program,
            sandbox,
            wall: Duration::MAX,
            interactive: false,
            second_judge: None,
            clock: Some(clock),
            withheld,
            known: None,
            progress: &|_, _| {},
        };
        let everything = Selection::default();
        let public = examiner(self.goldens, &self.withheld.scenes);
        let public = public.begin(submission, &everything)?;
        let Some(goldens) = self.fresh else {
            return Ok((public.finish()?, None));
        };
        let scenes = goldens.scenes.iter().map(|scene| scene.name.clone());
        let selection = Selection {
            tasks: public.promising_tasks(),
            scenes: scenes.collect(),
        };
        // Nobody has fresh scenes.
        let fresh = examiner(goldens, &selection.scenes);
        // Ask fresh questions about tasks before anything withheld. See `begin`.
        let fresh = fresh.begin(submission, &selection)?;
        let examination = public.finish()?;
        let mut scenes = examination.outcome.scenes.iter();
        let fresh = match scenes.any(|scene| scene.outcome.passes()) {
            true => fresh.finish()?,
            false => fresh.without_scenes().finish()?,
        };
        Ok((examination, Some(fresh)))
    }

    /// See [`crate::scene_cap`].
    fn needs(&self) -> Result<SceneNeeds> {
        let owned = |names: Vec<&str>| names.into_iter().map(str::to_owned).collect();
        let scenes = self.goldens.needs_of_scenes(self.assignment)?;
        let fresh = match self.fresh {
            Some(fresh) => fresh.needs_of_scenes(self.assignment)?.concat(),
            None => Vec::new(),
        };
        Ok(SceneNeeds {
            scenes: scenes.into_iter().map(owned).collect(),
            fresh: owned(fresh),
        })
    }

    fn report(&self, record: &Record, examination: &Examination) -> Result<Report> {
        let command = format!("{} check", pinhole_course::shell::PINHOLE);
        let again = RepeatCommands {
            whole: command.clone(),
            part: command,
        };
        let mut report = Report::of_examination(examination, &self.goldens.folder, &again)?;
        self.withheld.redact_report(&mut report, &record.got);
        let GradingInputs {
            judged_on, sandbox, ..
        } = &record.provenance.made_with;
        report.of.push(("judged on", judged_on.clone()));
        report.of.push(("sandbox", sandbox.clone()));
        if record.status != Status::Graded {
            report.said = format!("{} {}", report.said, record.explanation);
        }
        report.said += &points::dropped_in_words(self.assignment);
        for remark in &record.remarks {
            report.said.push_str(&format!(" {}.", printable(remark)));
        }
        if let Some(most) = record.most_for_scenes
            && record
                .got
                .scenes
                .iter()
                .map(|scene| scene.points)
                .sum::<u32>()
                > most
        {
            report.said.push_str(&format!(
                " All scenes together earn at most {most} points, because a scene earns no larger \
                 share of its points than the weakest of the tasks that it needs. Tasks must pass \
                 fresh questions too."
            ));
        }
        Ok(report)
    }
}
