//! Runs a submission through every group of questions and every scene.

mod asking;
mod diagnose;
mod judged;

use std::time::{Duration, Instant};

use pinhole::ask::MOST_PRINTED;
use rayon::prelude::*;

use crate::assignment::{Assignment, Task};
use crate::compile::Program;
use crate::describe;
use crate::diagnosis::Diagnosis;
use crate::error::{Error, Result};
use crate::goldens::questions::Group;
use crate::goldens::{GoldenScene, Goldens};
use crate::outcome::{
    Examination, FilmOutcome, GroupOutcome, Outcome, SceneFilm, SceneOutcome, Status, TaskOutcome,
};
use crate::sandbox::Sandbox;
use crate::second_judge::SecondJudge;
use crate::submission::Submission;
use crate::submission::flags::flags;
use crate::timings::timed;
pub use asking::{Clock, KnownReplies, run};
use diagnose::Cast;
pub use judged::failure;

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
    /// Whether somebody waits for the result. Then trusted code is asked several things at a
    /// time, a process that sends nothing for a fifteenth of `wall` (2 s at least) is given
    /// up, and no scene is cast that needs an answer which did not come in time.
    pub interactive: bool,
    /// Asked about every film too, if there is one; a disagreement is an error.
    pub second_judge: Option<&'a SecondJudge>,
    /// Says how long each process may take, in place of the usual limits, if there is one.
    pub clock: Option<&'a dyn Clock>,
    /// Replies that need not be asked for again, if there are any.
    pub known: Option<&'a dyn KnownReplies>,
    /// Told what is being asked, and the share of its answers so far, 0 to 1.
    pub progress: &'a (dyn Fn(&str, f64) + Sync),
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

    /// Whether this task is selected.
    pub fn has_task(&self, name: &str) -> bool {
        match self.tasks.is_empty() {
            true => self.scenes.is_empty(),
            false => self.tasks.iter().any(|task| task == name),
        }
    }

    /// Whether this scene is selected.
    pub fn has_scene(&self, name: &str) -> bool {
        match self.scenes.is_empty() {
            true => self.tasks.is_empty(),
            false => self.scenes.iter().any(|scene| scene == name),
        }
    }
}

impl Examiner<'_> {
    /// Asks everything that is selected.
    ///
    /// # Errors
    /// If a golden or a scene cannot be read, or the program cannot be started;
    /// whatever the submission does wrong is in the examination.
    pub fn examine(&self, submission: &Submission, selection: &Selection) -> Result<Examination> {
        let tasks = self.assignment.tasks.iter();
        let tasks: Vec<&Task> = tasks
            .filter(|task| selection.has_task(&task.name))
            .collect();
        let (tasks, mut printed): (Vec<TaskOutcome>, Vec<String>) = self
            .each(&tasks, |task| self.task(task))?
            .into_iter()
            .unzip();
        let scenes = self.goldens.scenes.iter();
        let scenes: Vec<&GoldenScene> = scenes
            .filter(|scene| selection.has_scene(&scene.name))
            .collect();
        let late: Vec<&Task> = match self.interactive {
            true => self.late(&tasks).collect(),
            false => Vec::new(),
        };
        let mut outcomes = Vec::new();
        let mut films = Vec::new();
        for (outcome, film, text) in self.each(&scenes, |scene| self.scene(scene, &late))? {
            outcomes.push(outcome);
            films.push(film);
            printed.push(text);
        }
        // Each process may print this much; all together are cut to the same length.
        let mut printed = printed.concat();
        printed.truncate(printed.floor_char_boundary(MOST_PRINTED));
        let folder = submission.folder.display().to_string();
        let mut outcome = Outcome {
            withheld: match selection.is_everything() {
                true => self.assignment.withheld,
                false => 0,
            },
            tasks,
            scenes: outcomes,
            printed,
            flags: flags(submission),
            ..Outcome::new(&self.assignment.title, folder, self.sandbox.name())
        };
        outcome.add_up();
        let mut examination = Examination { outcome, films };
        timed("diagnose scenes", || {
            self.goldens.diagnose_scenes(&mut examination)
        })?;
        Ok(examination)
    }

    /// Reads the goldens of everything that is selected into memory, while a submission is
    /// being compiled, say. What cannot be read is told by [`Examiner::examine`].
    pub fn warm_up(assignment: &Assignment, goldens: &Goldens, selection: &Selection) {
        let wants_task = |task: &&Task| selection.has_task(&task.name);
        let wants_scene = |scene: &&GoldenScene| selection.has_scene(&scene.name);
        rayon::join(
            || {
                let tasks = assignment.tasks.par_iter().filter(wants_task);
                tasks.for_each(|task| drop(goldens.cached_questions(task)));
            },
            || {
                let scenes = goldens.scenes.par_iter().filter(wants_scene);
                scenes.for_each(|scene| drop(goldens.cached_scene(scene)));
            },
        );
    }

    /// The same work on all items, in their order: several at a time where somebody waits for
    /// code of their own. Processes of foreign code share a user id, and so what it may use.
    fn each<T: Sync, R: Send>(
        &self,
        items: &[T],
        work: impl Fn(&T) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        match self.interactive && matches!(self.sandbox, Sandbox::Trusted) {
            true => items.par_iter().with_max_len(1).map(&work).collect(),
            false => items.iter().map(work).collect(),
        }
    }

    /// The tasks that have an answer which did not come in time.
    fn late<'t>(&'t self, tasks: &'t [TaskOutcome]) -> impl Iterator<Item = &'t Task> {
        let is_late = |outcome: &&TaskOutcome| {
            let mut groups = outcome.groups.iter();
            groups.any(|group| group.outcome.status() == Status::TimedOut)
        };
        let late = tasks.iter().filter(is_late);
        late.filter_map(|outcome| self.assignment.task(&outcome.name))
    }

    fn task(&self, task: &Task) -> Result<(TaskOutcome, String)> {
        let questions = self.goldens.cached_questions(task)?;
        let replies = self.ask_task(task, &questions)?;
        let printed = replies.iter().map(|reply| reply.printed.as_str()).collect();
        let mut replies = replies.iter();
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
            for (film, reply) in films.iter().zip(replies.by_ref()) {
                let judged = self.judge(reply, film, Some(&task.name))?;
                let worst = match &judged.verdict {
                    Some(verdict) => describe::worst(verdict, film, reply),
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
            false => timed("diagnose tasks", || {
                self.goldens.diagnose_task(&task.name, &casts)
            })?,
        };
        let replaced = self.program.replaced.get(&task.name);
        let outcome = TaskOutcome::new(task, replaced, results, diagnosis);
        Ok((outcome, printed))
    }

    fn scene(
        &self,
        scene: &GoldenScene,
        late: &[&Task],
    ) -> Result<(SceneOutcome, SceneFilm, String)> {
        let film = self.goldens.cached_scene(scene)?;
        let mut late = late
            .iter()
            .filter(|task| film.job.needs(task.kind, task.shape));
        let start = Instant::now();
        let (outcome, printed, judged) = match late.next() {
            Some(task) => {
                let by = task.name.clone();
                (FilmOutcome::Blocked { by }, String::new(), None)
            }
            None => {
                let reply = self.ask_whole(&scene.name, &film.job)?;
                let judged = self.judge(&reply, &film, None)?;
                (judged.outcome.clone(), reply.printed, Some(judged))
            }
        };
        let seconds = start.elapsed().as_secs_f64();
        let outcome = SceneOutcome::new(scene.name.clone(), scene.worth, outcome, seconds);
        let (cast, verdict) = judged.map_or((None, None), |judged| (judged.film, judged.verdict));
        let film = SceneFilm {
            file: scene.file.clone(),
            argument: scene.argument.clone(),
            golden: film.golden.clone(),
            film: cast,
            verdict,
        };
        Ok((outcome, film, printed))
    }
}
