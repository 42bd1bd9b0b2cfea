//! Runs a submission through every group of questions and every scene.

mod asking;
mod diagnose;
mod earlier;
mod judged_film;
mod scenes;
#[cfg(all(test, unix))]
mod tests;

use std::time::Duration;

use pinhole::Fact;
use pinhole::ask::{MOST_PRINTED, Reply};
use pinhole::job::Job;
use pinhole::judge::Verdict;
use rayon::prelude::*;

use crate::assignment::{Assignment, Task};
use crate::compile::Program;
use crate::describe;
use crate::diagnosis::Diagnosis;
use crate::diagnosis::measure::{measure, single_precision};
use crate::error::{Error, Result};
use crate::goldens::questions::{Group, QuestionFilm};
use crate::goldens::{GoldenScene, Goldens};
use crate::outcome::{
    EarlierOutcome, Examination, FilmOutcome, GroupOutcome, GroupPicture, Outcome, SceneFilm,
    SceneOutcome, TaskOutcome,
};
use crate::sandbox::Sandbox;
use crate::second_judge::SecondJudge;
use crate::submission::Submission;
use crate::submission::flags::flags;
use crate::timings::timed;
pub use asking::{Clock, KnownReplies, run};
use diagnose::Cast;
pub use diagnose::asked;
pub use judged_film::failure;
use judged_film::without_overflows;

/// The most bytes that are shown of an answer's output for one question.
const MOST_PRINTED_BY_ONE: usize = 1000;

/// Examines a built submission.
pub struct Examiner<'a> {
    /// The assignment whose tasks are asked.
    pub assignment: &'a Assignment,
    /// The golden films, and the scenes they show.
    pub goldens: &'a Goldens,
    /// The submission's program.
    pub program: &'a Program,
    /// The sandbox that it runs in.
    pub sandbox: &'a Sandbox,
    /// How long each process may take. If nobody waits for the result, see
    /// [`Limits::of_answers`](crate::sandbox::Limits::of_answers).
    pub wall: Duration,
    /// Whether someone waits for the result. If so, trusted code is asked several things at a
    /// time, and a process that sends nothing for a fifteenth of `wall` (but at least 2 s) is
    /// ended.
    pub interactive: bool,
    /// The second judge, if it is to judge every film too. Disagreement is an error.
    pub second_judge: Option<&'a SecondJudge>,
    /// Limits for each process, in place of the usual ones.
    pub clock: Option<&'a dyn Clock>,
    /// The names of the scenes that students don't have. If someone waits for the result, they may
    /// see everything about these scenes, too.
    pub withheld: &'a [String],
    /// Replies that are known already, if there are any.
    pub known: Option<&'a dyn KnownReplies>,
    /// Called with what is being asked, and the share of answers so far, from 0 to 1.
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

/// Groups of a task that were asked about, and how each was judged.
struct JudgedGroups<'q> {
    outcomes: Vec<GroupOutcome>,
    casts: Vec<Cast<'q>>,
    pictures: Vec<GroupPicture>,
    /// What the code printed.
    printed: String,
}

/// An examination that has asked everything except what is withheld.
pub struct Begun<'a> {
    examiner: &'a Examiner<'a>,
    submission: &'a Submission,
    selection: &'a Selection,
    /// The selected tasks, and what became of their groups that are not withheld.
    tasks: Vec<(&'a Task, TaskOutcome)>,
    selected_scenes: Vec<&'a GoldenScene>,
    /// What became of the selected scenes that are not withheld.
    scenes: Vec<(SceneOutcome, SceneFilm, String)>,
    /// The program that casts scenes.
    caster: Program,
    earlier: Option<EarlierOutcome>,
    pictures: Vec<GroupPicture>,
    /// What the code printed, by process.
    printed: Vec<String>,
}

impl Examiner<'_> {
    /// Asks everything that is selected.
    ///
    /// Fails if a golden or a scene cannot be read, or the program cannot be started. The
    /// examination reports anything that the submission does wrong.
    pub fn examine(&self, submission: &Submission, selection: &Selection) -> Result<Examination> {
        self.begin(submission, selection)?.finish()
    }

    /// Asks everything that is selected and not withheld. [`Begun::finish`] asks the rest.
    ///
    /// Everything withheld is asked last. Otherwise, code that has seen it could make its process
    /// end at a certain time, from which a later process could tell what it has seen.
    ///
    /// # Errors
    /// The same as those of [`Examiner::examine`].
    pub fn begin<'b>(
        &'b self,
        submission: &'b Submission,
        selection: &'b Selection,
    ) -> Result<Begun<'b>> {
        let tasks = self.assignment.tasks.iter();
        let tasks: Vec<&Task> = tasks
            .filter(|task| selection.has_task(&task.name))
            .collect();
        let (mut pictures, mut printed) = (Vec::new(), Vec::new());
        let mut answered = Vec::new();
        for (outcome, drawn, text) in self.each(&tasks, |task| self.task(task))? {
            answered.push(outcome);
            pictures.extend(drawn);
            printed.push(text);
        }
        let selected_scenes = self.goldens.scenes.iter();
        let selected_scenes: Vec<&GoldenScene> = selected_scenes
            .filter(|scene| selection.has_scene(&scene.name))
            .collect();
        let (caster, earlier) = match selected_scenes.is_empty() {
            true => (self.program.clone(), None),
            false => self.judge_earlier()?,
        };
        let public = selected_scenes.iter().filter(|it| self.shows(&it.name));
        let public: Vec<&GoldenScene> = public.copied().collect();
        let scenes = self.casting(&caster).scenes(&public, &answered)?;
        Ok(Begun {
            examiner: self,
            submission,
            selection,
            tasks: tasks.into_iter().zip(answered).collect(),
            selected_scenes,
            scenes,
            caster,
            earlier,
            pictures,
            printed,
        })
    }

    /// The same examiner with another program.
    fn casting<'b>(&'b self, program: &'b Program) -> Examiner<'b> {
        Examiner { program, ..*self }
    }

    /// Whether the result may say everything about this scene.
    fn shows(&self, scene: &str) -> bool {
        self.interactive || self.is_public(scene)
    }

    /// Reads the selected goldens into memory, for instance while a submission is being
    /// compiled. Errors are left to [`Examiner::examine`].
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

    /// Whether students have this scene.
    fn is_public(&self, scene: &str) -> bool {
        !self.withheld.iter().any(|name| name == scene)
    }

    /// Whether a group asks about pixels of a scene that students don't have. What a result says
    /// about anything else must not depend on it.
    fn withholds(&self, task: &Task, group: &str) -> bool {
        let mut scenes = self.goldens.scenes.iter();
        !self.interactive
            && task.is_of_scenes(group)
            && scenes.any(|scene| !self.is_public(&scene.name))
    }

    /// Whether to ask several things at a time: only if someone waits for the result of their own
    /// code.
    fn asks_several(&self) -> bool {
        self.interactive && matches!(self.sandbox, Sandbox::Trusted)
    }

    /// Does some work on each item and keeps the items' order. Works on several items at a time
    /// if someone waits for the result of their own code. Processes of untrusted code run one by
    /// one, because they share a user id and its limits.
    fn each<T: Sync, R: Send>(
        &self,
        items: &[T],
        work: impl Fn(&T) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        match self.asks_several() {
            true => items.par_iter().with_max_len(1).map(&work).collect(),
            false => items.iter().map(work).collect(),
        }
    }

    /// Asks about all groups of a task that are not withheld.
    fn task(&self, task: &Task) -> Result<(TaskOutcome, Vec<GroupPicture>, String)> {
        let questions = self.goldens.cached_questions(task)?;
        let asked_groups = self.ask_task(task, &questions, false)?;
        let judged = self.judge_groups(task, &asked_groups)?;
        let passes = judged.outcomes.iter().all(|group| group.outcome.passes());
        let diagnosis = match passes {
            true => Diagnosis::default(),
            false => timed("diagnose tasks", || {
                self.goldens.diagnose_task(&task.name, &judged.casts)
            })?,
        };
        let measured = timed("measure errors", || {
            let asked = asked(task, &asked_groups);
            match passes {
                false => measure(&asked),
                true if self.interactive => single_precision(&asked).into_iter().collect(),
                true => Vec::new(),
            }
        });
        let replaced = self.program.replaced.get(&task.name);
        let findings = measured.into_iter().map(|measured| measured.finding);
        let findings = findings.collect();
        let mut outcome = TaskOutcome::new(task, replaced, judged.outcomes, diagnosis, findings);
        if self.interactive && !passes && !outcome.is_unanswered() {
            let warnings = self.program.warnings.get(&task.name);
            outcome.warnings = warnings.cloned().unwrap_or_default();
        }
        Ok((outcome, judged.pictures, judged.printed))
    }

    /// Asks about the groups of a task that are withheld, and adds them to the outcome of the
    /// others. What the outcome says of the others, such as a diagnosis, does not depend on them.
    fn withheld_groups(
        &self,
        task: &Task,
        outcome: &mut TaskOutcome,
    ) -> Result<(Vec<GroupPicture>, String)> {
        let questions = self.goldens.cached_questions(task)?;
        let asked = self.ask_task(task, &questions, true)?;
        let judged = self.judge_groups(task, &asked)?;
        outcome.groups.extend(judged.outcomes);
        let groups = &questions.groups;
        let place = |name: &str| groups.iter().position(|group| group.name == name);
        outcome.groups.sort_by_key(|group| place(&group.name));
        Ok((judged.pictures, judged.printed))
    }

    fn judge_groups<'q>(
        &self,
        task: &Task,
        asked: &[(&'q Group, Vec<Reply>)],
    ) -> Result<JudgedGroups<'q>> {
        let replies = asked.iter().flat_map(|(_, replies)| replies);
        let printed: String = replies.map(|reply| reply.printed.as_str()).collect();
        let mut outcomes = Vec::new();
        let mut casts = Vec::new();
        let mut pictures: Vec<GroupPicture> = Vec::new();
        for (group, replies) in asked {
            let Group {
                name,
                worth,
                about,
                films,
            } = *group;
            let mut result = None;
            for (film, reply) in films.iter().zip(replies) {
                let judged = self.judge(reply, film, Some(&task.name))?;
                let worst = match &judged.verdict {
                    Some(Ok(verdict)) => {
                        let mut facts = describe::worst(verdict, film, reply);
                        if self.interactive && !printed.is_empty() {
                            facts.extend(self.printed_by_worst(task, verdict, film)?);
                        }
                        facts
                    }
                    Some(Err(refusal)) => describe::refused(refusal, film, reply),
                    // Only the student's code says at which question it stopped, and when a class
                    // is graded, we don't believe it.
                    None if self.interactive => describe::unanswered(film, reply),
                    None => Vec::new(),
                };
                let outcome = judged.outcome.clone();
                // The first film that fails is reported for its group.
                let is_reported = result
                    .as_ref()
                    .is_none_or(|(earlier, _): &(FilmOutcome, _)| earlier.passes());
                if is_reported && let Some(shows) = judged.picture(film, reply) {
                    pictures.retain(|other| other.group != *name);
                    pictures.push(GroupPicture {
                        task: task.name.clone(),
                        group: name.clone(),
                        shows,
                    });
                }
                casts.push(Cast {
                    asked: film,
                    film: judged.film,
                    end: outcome.clone(),
                });
                if is_reported {
                    result = Some((outcome, worst));
                }
            }
            let (outcome, worst) = result.ok_or_else(|| {
                Error::environment(
                    format!("group `{name}` of task `{}` has no questions", task.name),
                    "restore the goldens: git checkout -- golden",
                )
            })?;
            outcomes.push(GroupOutcome::new(
                name.clone(),
                about.clone(),
                *worth,
                outcome,
                worst,
            ));
        }
        Ok(JudgedGroups {
            outcomes,
            casts,
            pictures,
            printed,
        })
    }

    /// What the answer prints when it is asked only the worst question of a verdict.
    fn printed_by_worst(
        &self,
        task: &Task,
        verdict: &Verdict,
        film: &QuestionFilm,
    ) -> Result<Option<Fact>> {
        let questions = film.job.questions();
        let Some((questions, (_, mismatch))) = questions.zip(describe::worst_of(verdict)) else {
            return Ok(None);
        };
        let index = verdict.resolution.index(mismatch.pixel);
        let job = Job::Ask(questions.part(index..index + 1));
        let reply = self.ask(&task.name, &job, self.wall)?;
        let text = reply.printed.trim_end();
        let text = &text[..text.floor_char_boundary(MOST_PRINTED_BY_ONE)];
        Ok((!text.is_empty()).then(|| Fact::new("printed", text)))
    }
}

impl Begun<'_> {
    /// The tasks that may earn a point: those with a group that passes, or is not asked yet. All
    /// tasks if a scene passes, because fresh scenes that need a late task are not cast.
    pub fn promising_tasks(&self) -> Vec<String> {
        let scene_passes = self.scenes.iter().any(|it| it.0.outcome.passes());
        let promising = self.tasks.iter().filter(|(task, outcome)| {
            scene_passes
                || outcome.groups.iter().any(|group| group.outcome.passes())
                || outcome.groups.len() < task.points.len()
        });
        promising.map(|(task, _)| task.name.clone()).collect()
    }

    /// Leaves out the scenes.
    pub fn without_scenes(mut self) -> Self {
        self.selected_scenes.clear();
        self.scenes.clear();
        self
    }

    /// Asks the rest.
    ///
    /// # Errors
    /// The same as those of [`Examiner::examine`].
    pub fn finish(self) -> Result<Examination> {
        let examiner = self.examiner;
        let (mut pictures, mut printed) = (self.pictures, self.printed);
        let mut tasks = Vec::new();
        for (task, mut outcome) in self.tasks {
            let (drawn, text) = examiner.withheld_groups(task, &mut outcome)?;
            tasks.push(outcome);
            pictures.extend(drawn);
            printed.push(text);
        }
        let selected = self.selected_scenes;
        let hidden = selected.iter().filter(|it| !examiner.shows(&it.name));
        let hidden: Vec<&GoldenScene> = hidden.copied().collect();
        let mut cast = self.scenes;
        cast.extend(examiner.casting(&self.caster).scenes(&hidden, &tasks)?);
        let place = |name: &str| selected.iter().position(|scene| scene.name == name);
        cast.sort_by_key(|(outcome, ..)| place(&outcome.name));
        let (mut scenes, mut films) = (Vec::new(), Vec::new());
        for (outcome, film, text) in cast {
            scenes.push(outcome);
            films.push(film);
            printed.push(text);
        }
        // Each process may print this much. The output of all together is cut to the same length.
        let mut printed = without_overflows(&printed.concat());
        printed.truncate(printed.floor_char_boundary(MOST_PRINTED));
        let folder = self.submission.folder.display().to_string();
        let assignment = examiner.assignment;
        let mut outcome = Outcome {
            withheld: match self.selection.is_everything() {
                true => assignment.withheld,
                false => 0,
            },
            tasks,
            scenes,
            earlier: self.earlier,
            printed,
            flags: flags(self.submission),
            ..Outcome::new(&assignment.title, folder, examiner.sandbox.name())
        };
        outcome.add_up();
        let mut examination = Examination {
            outcome,
            films,
            pictures,
        };
        timed("diagnose scenes", || {
            let is_public = |scene: &str| examiner.shows(scene);
            let goldens = examiner.goldens;
            goldens.diagnose_scenes(&mut examination, &is_public)
        })?;
        Ok(examination)
    }
}
