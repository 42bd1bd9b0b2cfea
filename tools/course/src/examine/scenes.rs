//! Casts scenes with a submission's answers, and judges the films.

use std::collections::BTreeMap;
use std::time::Instant;

use pinhole::ask::{Ending, Reply};
use pinhole::job::Job;
use pinhole::kind::{CameraQuestion, Questions};

use super::Examiner;
use crate::assignment::Task;
use crate::describe;
use crate::error::Result;
use crate::goldens::GoldenScene;
use crate::goldens::questions::QuestionFilm;
use crate::outcome::{
    FilmOutcome, GroupOutcome, OwnRays, SceneFilm, SceneOutcome, Status, TaskOutcome,
};

/// What the process that casts several scenes is called. It gets the shortest limits, because
/// scenes that take longer can be cast again, one by one.
const SEVERAL: &str = "several scenes";

impl Examiner<'_> {
    /// Casts scenes after their tasks were judged.
    pub(super) fn scenes(
        &self,
        scenes: &[&GoldenScene],
        tasks: &[TaskOutcome],
    ) -> Result<Vec<(SceneOutcome, SceneFilm, String)>> {
        // Scenes that need a late answer would be late too, so they are not cast.
        let late = self.with_a_group(tasks, |task, group| {
            group.outcome.status() == Status::TimedOut && !self.withholds(task, &group.name)
        });
        let rays_pass = self.rays_pass(tasks);
        let together = self.cast_together(scenes, tasks)?;
        self.each(scenes, |scene| {
            self.scene(scene, together.get(&scene.name), &late, rays_pass)
        })
    }

    /// The tasks with a group like this.
    fn with_a_group(
        &self,
        tasks: &[TaskOutcome],
        is_like_this: impl Fn(&Task, &GroupOutcome) -> bool,
    ) -> Vec<&Task> {
        let tasks = tasks.iter().filter_map(|outcome| {
            let task = self.assignment.task(&outcome.name)?;
            let mut groups = outcome.groups.iter();
            groups
                .any(|group| is_like_this(task, group))
                .then_some(task)
        });
        tasks.collect()
    }

    /// Replies to the scenes that one process can cast, by name. Starting a process for each would
    /// take a tenth more time. A withheld scene is cast in a process of its own. Otherwise, code
    /// that has seen it could put what it saw into wrong pixels of a public scene, which results
    /// show.
    fn cast_together(
        &self,
        scenes: &[&GoldenScene],
        tasks: &[TaskOutcome],
    ) -> Result<BTreeMap<String, Reply>> {
        if self.interactive || self.known.is_some() {
            return Ok(BTreeMap::new());
        }
        // An answer that gave no film for its questions would end the process for all scenes.
        let broken = self.with_a_group(tasks, |_, group| {
            !matches!(group.outcome, FilmOutcome::Judged(_))
        });
        let mut films = Vec::new();
        for scene in scenes {
            let film = self.goldens.cached_scene(scene)?;
            let needs = |task: &&Task| film.job.needs(task.kind, task.shape);
            if self.is_public(&scene.name) && !broken.iter().any(needs) {
                films.push(film);
            }
        }
        if films.len() < 2 {
            return Ok(BTreeMap::new());
        }
        let jobs = films.iter().filter_map(|film| match &film.job {
            Job::Film(scene) => Some(scene.clone()),
            _ => None,
        });
        let job = Job::Films(jobs.collect());
        let mut reply = self.ask_without_check(SEVERAL, &job, self.wall)?;
        if let Ending::TimedOut(_) = reply.ending {
            self.sandbox.forgive();
        }
        if !reply.is_whole() {
            return Ok(BTreeMap::new());
        }
        let printed = std::mem::take(&mut reply.printed);
        let mut replies = reply.split(films.iter().map(|film| film.job.len()));
        if let Some(first) = replies.first_mut() {
            first.printed = printed;
        }
        let names = films.iter().map(|film| film.name.clone());
        Ok(names.zip(replies).collect())
    }

    /// Whether the answer that gives rays was judged, and passes.
    fn rays_pass(&self, tasks: &[TaskOutcome]) -> bool {
        let is_asked = |task: &&TaskOutcome| {
            let task = self.assignment.task(&task.name);
            task.is_some_and(|task| task.kind.gives_rays())
        };
        tasks.iter().find(is_asked).is_some_and(TaskOutcome::passes)
    }

    /// The rays that a submission sends through the pixels of a scene.
    fn own_rays(&self, name: &str, film: &QuestionFilm) -> Result<OwnRays> {
        let Job::Film(scene) = &film.job else {
            return Ok(OwnRays::Unknown);
        };
        let pixels = 0..scene.resolution.pixels();
        let questions = pixels.map(|index| CameraQuestion::of_scene(scene, index));
        let job = Job::Ask(Questions::ViewingRay(questions.collect()));
        let reply = self.ask(name, &job, self.wall)?;
        Ok(match reply.is_whole() {
            true => OwnRays::Asked(reply.film(scene.resolution)),
            false => OwnRays::Unknown,
        })
    }

    fn scene(
        &self,
        scene: &GoldenScene,
        cast: Option<&Reply>,
        late: &[&Task],
        rays_pass: bool,
    ) -> Result<(SceneOutcome, SceneFilm, String)> {
        let film = self.goldens.cached_scene(scene)?;
        let mut late = late
            .iter()
            .filter(|task| film.job.needs(task.kind, task.shape));
        let start = Instant::now();
        let (mut tests, mut unanswered) = (None, None);
        let (outcome, printed, judged) = match late.next() {
            Some(task) => {
                let by = task.name.clone();
                (FilmOutcome::Blocked { by }, String::new(), None)
            }
            None => {
                let mut reply = match cast {
                    Some(reply) => reply.clone(),
                    None => self.ask_whole(&scene.name, &film.job)?,
                };
                self.find_death(&scene.name, &film.job, self.wall, &mut reply)?;
                let judged = self.judge(&reply, &film, None)?;
                tests = reply.own_tests(film.resolution);
                // Like the question at which an answer stopped, see `Examiner::judge_groups`.
                if self.interactive {
                    let judged = judged.verdict.as_ref();
                    unanswered = describe::unanswered_pixel(&reply, judged, film.resolution);
                }
                (judged.outcome.clone(), reply.printed, Some(judged))
            }
        };
        let seconds = cast.is_none().then(|| start.elapsed().as_secs_f64());
        let is_wrong = judged.as_ref().is_some_and(|judged| judged.film.is_some());
        let rays = match is_wrong && self.interactive && !outcome.passes() {
            true if rays_pass => OwnRays::Right,
            true => self.own_rays(&scene.name, &film)?,
            false => OwnRays::Unknown,
        };
        let outcome = SceneOutcome::new(scene.name.clone(), scene.worth, outcome, seconds);
        let (cast, verdict) = match judged {
            Some(judged) => (judged.film, judged.verdict.and_then(|verdict| verdict.ok())),
            None => (None, None),
        };
        let tasks = self.assignment.tasks.iter();
        let needs = tasks.filter(|task| film.job.needs(task.kind, task.shape));
        let film = SceneFilm {
            file: scene.file.clone(),
            argument: scene.argument.clone(),
            golden: film.golden.clone(),
            film: cast,
            verdict,
            rays,
            tests,
            needs: needs.map(|task| task.name.clone()).collect(),
            unanswered,
        };
        Ok((outcome, film, printed))
    }
}
