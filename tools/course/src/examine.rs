//! Runs a submission through every group of questions and every scene.

mod diagnose;

use std::path::Path;
use std::time::{Duration, Instant};

use pinhole::Film;
use pinhole::ask::{Ending, MOST_PRINTED, Reply};
use pinhole::job::{Job, Panic};
use pinhole::judge::{Verdict, judge};

use crate::assignment::{Assignment, Task};
use crate::compile::Program;
use crate::describe;
use crate::diagnosis::Diagnosis;
use crate::error::{Error, Result, ResultExt};
use crate::goldens::questions::{Group, QuestionFilm, Questions};
use crate::goldens::{GoldenScene, Goldens};
use crate::outcome::{
    Examination, FilmOutcome, GroupOutcome, Outcome, SceneFilm, SceneOutcome, TaskOutcome,
};
use crate::sandbox::{Limits, Sandbox};
use crate::second_judge::SecondJudge;
use crate::submission::Submission;
use crate::submission::flags::flags;
use diagnose::Cast;

/// A built submission and what it is measured against.
pub struct Examiner<'a> {
    /// Whose tasks.
    pub assignment: &'a Assignment,
    /// The golden films, and the scenes they show.
    pub goldens: &'a Goldens,
    /// What runs.
    pub program: &'a Program,
    /// Where it runs.
    pub sandbox: &'a Sandbox,
    /// How long each process may take.
    pub wall: Duration,
    /// Asked about every film too, if there is one; a disagreement is an error.
    pub second_judge: Option<&'a SecondJudge>,
    /// Says how long each process may take, in place of the usual limits, if there is one.
    pub clock: Option<&'a dyn Clock>,
    /// Told what is being asked, and the share of its answers so far, 0 to 1.
    pub progress: &'a dyn Fn(&str, f64),
}

/// Limits that differ from one task or scene to another.
pub trait Clock {
    /// The limits of the process that is asked about `what`, a task or a scene.
    fn limits(&self, what: &str) -> Limits;

    /// Sees every reply; an error ends the examination.
    fn check(&self, reply: &Reply) -> Result<()>;
}

/// What to examine; empty lists mean everything.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Only these tasks.
    pub tasks: Vec<String>,
    /// Only these scenes.
    pub scenes: Vec<String>,
}

impl Selection {
    /// Whether nothing is left out.
    pub fn is_everything(&self) -> bool {
        self.tasks.is_empty() && self.scenes.is_empty()
    }
}

/// The least time for a group that is asked alone: starting a process takes some of it, and
/// that must not count against the student.
const LEAST_WALL: Duration = Duration::from_secs(2);

impl Examiner<'_> {
    /// Asks everything that is selected.
    ///
    /// # Errors
    /// If a golden or a scene cannot be read, or the program cannot be started;
    /// whatever the submission does wrong is in the examination.
    pub fn examine(&self, submission: &Submission, selection: &Selection) -> Result<Examination> {
        let mut printed = String::new();
        let mut tasks = Vec::new();
        let wants_task = |task: &&Task| match selection {
            Selection { tasks, scenes } if tasks.is_empty() => scenes.is_empty(),
            Selection { tasks, .. } => tasks.contains(&task.name),
        };
        for task in self.assignment.tasks.iter().filter(wants_task) {
            tasks.push(self.task(task, &mut printed)?);
        }
        let mut scenes = Vec::new();
        let mut films = Vec::new();
        for scene in &self.goldens.scenes {
            let wanted = match selection {
                Selection { tasks, scenes } if scenes.is_empty() => tasks.is_empty(),
                Selection { scenes, .. } => scenes.contains(&scene.name),
            };
            if wanted {
                let (scene, film) = self.scene(scene, &mut printed)?;
                scenes.push(scene);
                films.push(film);
            }
        }
        // Each process may print this much; all together are cut to the same length.
        printed.truncate(printed.floor_char_boundary(MOST_PRINTED));
        let folder = submission.folder.display().to_string();
        let mut outcome = Outcome {
            withheld: match selection.is_everything() {
                true => self.assignment.withheld,
                false => 0,
            },
            tasks,
            scenes,
            printed,
            flags: flags(submission),
            ..Outcome::new(&self.assignment.title, folder, self.sandbox.name())
        };
        outcome.add_up();
        let mut examination = Examination { outcome, films };
        self.goldens.diagnose_scenes(&mut examination)?;
        Ok(examination)
    }

    fn task(&self, task: &Task, printed: &mut String) -> Result<TaskOutcome> {
        let questions = self.goldens.cached_questions(task)?;
        let together = self.ask_together(task, &questions, printed)?;
        let mut together = together.map(Vec::into_iter);
        // An endless loop shall cost no more than twice the limit, whichever group it is in.
        let films = questions
            .groups
            .iter()
            .map(|group| group.films.len())
            .sum::<usize>()
            .max(1);
        let share = (self.wall / films as u32).max(LEAST_WALL);
        let mut results = Vec::new();
        let mut casts = Vec::new();
        for Group {
            name,
            worth,
            about,
            films,
        } in &questions.groups
        {
            let mut result = None;
            for film in films {
                let reply = match &mut together {
                    Some(replies) => replies.next().expect("a reply was split off for each film"),
                    None => self.ask(&task.name, &film.job, share)?,
                };
                printed.push_str(&reply.printed);
                let judged = self.judge(&reply, film, Some(&task.name))?;
                let worst = match &judged.verdict {
                    Some(verdict) => describe::worst(verdict, film, &reply),
                    None => Vec::new(),
                };
                let outcome = judged.outcome;
                casts.push(Cast {
                    asked: film,
                    film: judged.film,
                    end: outcome.clone(),
                });
                // The first film that fails speaks for its group.
                if result
                    .as_ref()
                    .is_none_or(|(earlier, _): &(FilmOutcome, _)| earlier.passes())
                {
                    result = Some((outcome, worst));
                }
            }
            let (outcome, worst) = result.ok_or_else(|| {
                Error::environment(
                    format!("group `{name}` of task `{}` has no questions", task.name),
                    "make the goldens again: cargo pinhole golden render",
                )
            })?;
            results.push(GroupOutcome::new(
                name.clone(),
                about.clone(),
                *worth,
                outcome,
                worst,
            ));
        }
        let passes = results.iter().all(|group| group.outcome.passes());
        let diagnosis = match passes {
            true => Diagnosis::default(),
            false => self.goldens.diagnose_task(&task.name, &casts)?,
        };
        let replaced = self.program.replaced.get(&task.name);
        Ok(TaskOutcome::new(task, replaced, results, diagnosis))
    }

    /// All groups of a task in one process; `None` if some answer fails in a way that
    /// could hide the others. Then each is to be asked alone, so that it costs its own
    /// group only.
    fn ask_together(
        &self,
        task: &Task,
        questions: &Questions,
        printed: &mut String,
    ) -> Result<Option<Vec<Reply>>> {
        let Some(job) = &questions.together else {
            return Ok(None);
        };
        let mut reply = self.ask(&task.name, job, self.wall)?;
        if reply.ending != Ending::Complete {
            return Ok(None);
        }
        printed.push_str(&std::mem::take(&mut reply.printed));
        let films = questions.groups.iter().flat_map(|group| &group.films);
        Ok(Some(reply.split(films.map(|film| film.job.len()))))
    }

    fn scene(
        &self,
        scene: &GoldenScene,
        printed: &mut String,
    ) -> Result<(SceneOutcome, SceneFilm)> {
        let film = self.goldens.cached_scene(scene)?;
        let start = Instant::now();
        let reply = self.ask(&scene.name, &film.job, self.wall)?;
        let seconds = start.elapsed().as_secs_f64();
        printed.push_str(&reply.printed);
        let judged = self.judge(&reply, &film, None)?;
        let outcome = SceneOutcome::new(scene.name.clone(), scene.worth, judged.outcome, seconds);
        let film = SceneFilm {
            file: scene.file.clone(),
            argument: scene.argument.clone(),
            golden: film.golden.clone(),
            film: judged.film,
            verdict: judged.verdict,
        };
        Ok((outcome, film))
    }

    fn ask(&self, what: &str, job: &Job, wall: Duration) -> Result<Reply> {
        let limits = match self.clock {
            Some(clock) => clock.limits(what),
            None => Limits::of_answers(wall),
        };
        let reply = run(self.program, self.sandbox, &limits, job, &mut |done| {
            (self.progress)(what, done as f64 / job.len().max(1) as f64);
        })?;
        if let Some(clock) = self.clock {
            clock.check(&reply)?;
        }
        Ok(reply)
    }

    /// How the film of a reply fares; `task` if one answer was asked alone.
    fn judge(&self, reply: &Reply, asked: &QuestionFilm, task: Option<&str>) -> Result<JudgedFilm> {
        let complete = reply.answers.iter().all(Option::is_some);
        if let Some(failure) = failure(&reply.ending, self.assignment, task).filter(|_| !complete) {
            return Ok(JudgedFilm {
                outcome: failure,
                film: None,
                verdict: None,
            });
        }
        let film = reply.film(asked.resolution);
        let verdict = judge(&asked.golden, &film);
        let outcome = FilmOutcome::from(&verdict);
        if let Some(second) = self.second_judge {
            second.confirm(&film, &asked.golden_path, outcome.passes())?;
        }
        Ok(JudgedFilm {
            outcome,
            film: Some(film),
            verdict: verdict.ok(),
        })
    }
}

/// How a film fared, and the film if it is whole.
struct JudgedFilm {
    outcome: FilmOutcome,
    film: Option<Film>,
    verdict: Option<Verdict>,
}

/// What an ending means for the answers that were asked; `None` if all is well so far.
pub fn failure(
    ending: &Ending,
    assignment: &Assignment,
    task: Option<&str>,
) -> Option<FilmOutcome> {
    Some(match ending {
        Ending::Complete => return None,
        Ending::Panicked(panic) if panic.is_unanswered() => match task_of(panic, assignment) {
            Some(other) if Some(other) != task => FilmOutcome::Blocked { by: other.into() },
            _ => FilmOutcome::Unanswered,
        },
        Ending::Panicked(panic) => FilmOutcome::Panicked {
            message: panic.message.clone(),
            file: panic.file.clone(),
            line: panic.line,
        },
        Ending::Unregistered(missing) => FilmOutcome::Died {
            how: missing.to_string(),
        },
        Ending::TimedOut(limit) => FilmOutcome::TimedOut {
            seconds: limit.as_secs_f64(),
        },
        Ending::OutOfMemory(most) => FilmOutcome::OutOfMemory { most: *most },
        Ending::Died(death) => FilmOutcome::Died {
            how: death.to_string(),
        },
        Ending::Garbled(why) => FilmOutcome::Garbled { why: why.clone() },
    })
}

/// The task in whose file a panic happened.
fn task_of<'a>(panic: &Panic, assignment: &'a Assignment) -> Option<&'a str> {
    let stem = Path::new(&panic.file).file_stem()?.to_str()?;
    assignment.task(stem).map(|task| task.name.as_str())
}

/// Runs a program on one job.
pub fn run(
    program: &Program,
    sandbox: &Sandbox,
    limits: &Limits,
    job: &Job,
    progress: &mut dyn FnMut(usize),
) -> Result<Reply> {
    let stop = program.stop.clone();
    let asked = sandbox.ask(&program.executable, job, limits, stop, progress);
    asked.or_environment(
        format_args!("cannot ask {}", program.executable.display()),
        "run this command again; if it persists, remove target/pinhole",
    )
}
