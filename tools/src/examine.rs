//! Runs a submission through every group of questions and every scene.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use pinhole::ask::{Ending, Reply, ask};
use pinhole::job::{CameraQuestion, Job, Panic};
use pinhole::judge::{Golden, judge};
use pinhole::{Resolution, Scene, probe};

use crate::assignment::{Assignment, Task};
use crate::compile::Program;
use crate::describe;
use crate::error::{Error, Result};
use crate::examination::{Examination, GroupResult, Outcome, SceneResult, TaskResult};
use crate::goldens::{GoldenScene, Goldens};
use crate::sandbox::Sandbox;
use crate::second_judge::SecondJudge;
use crate::submission::Submission;

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
    /// Told what is being asked, and the share of its answers so far, 0 to 1.
    pub progress: &'a dyn Fn(&str, f64),
}

/// What to examine; empty lists mean everything.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Only these tasks.
    pub tasks: Vec<String>,
    /// Only these scenes.
    pub scenes: Vec<String>,
}

/// The group of the viewing rays of the assignment's own scenes.
const SCENES_GROUP: &str = "scenes";

/// A group of questions with its golden film.
struct Group {
    name: String,
    worth: u32,
    parts: Vec<Part>,
}

/// One question film.
struct Part {
    name: String,
    job: Job,
    resolution: Resolution,
    golden: Standard,
}

/// A golden and where it lies.
struct Standard {
    golden: Golden,
    path: PathBuf,
}

impl Standard {
    fn read(path: PathBuf) -> Result<Standard> {
        Ok(Standard {
            golden: Golden::read(&path)?,
            path,
        })
    }
}

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
        for scene in &self.goldens.scenes {
            let wanted = match selection {
                Selection { tasks, scenes } if scenes.is_empty() => tasks.is_empty(),
                Selection { scenes, .. } => scenes.contains(&scene.name),
            };
            if wanted {
                scenes.push(self.scene(scene, &mut printed)?);
            }
        }
        Ok(Examination {
            submission: submission.folder.display().to_string(),
            title: self.assignment.title.clone(),
            tasks,
            scenes,
            printed,
        })
    }

    fn task(&self, task: &Task, printed: &mut String) -> Result<TaskResult> {
        let mut groups = Vec::new();
        for (name, worth) in &task.points {
            let parts = self.parts(task, name)?;
            groups.push(Group {
                name: name.clone(),
                worth: *worth,
                parts,
            });
        }
        // All groups in one process, unless some answer fails in a way that could
        // hide the others; then each alone, so that it costs its own group only.
        let together = join(
            groups
                .iter()
                .flat_map(|group| &group.parts)
                .map(|part| &part.job),
        );
        let mut replies: Option<Vec<Reply>> = None;
        if let Some(job) = together {
            let reply = self.ask(&task.name, &job)?;
            let lengths = groups
                .iter()
                .flat_map(|group| &group.parts)
                .map(|part| part.job.len());
            if matches!(reply.ending, Ending::Complete | Ending::TimedOut(_)) {
                printed.push_str(&reply.printed);
                replies = Some(reply.split(lengths));
            }
        }
        let mut replies = replies.map(Vec::into_iter);
        let mut results = Vec::new();
        for group in groups {
            let mut outcome = None;
            let mut worst = None;
            for part in &group.parts {
                let reply = match &mut replies {
                    Some(replies) => replies.next().expect("a reply was split off for each part"),
                    None => self.ask(&task.name, &part.job)?,
                };
                if replies.is_none() {
                    printed.push_str(&reply.printed);
                }
                let judged = self.judge(&reply, part.resolution, &part.golden, Some(&task.name))?;
                if outcome.as_ref().is_none_or(Outcome::passes) {
                    worst = match &judged {
                        Outcome::Judged(verdict) => describe::worst(
                            verdict,
                            &part.job,
                            &reply,
                            &part.golden.golden,
                            &part.name,
                        ),
                        _ => None,
                    };
                    outcome = Some(judged);
                }
            }
            let outcome = outcome.ok_or_else(|| {
                Error::environment(
                    format!(
                        "group `{}` of task `{}` has no questions",
                        group.name, task.name
                    ),
                    "make the goldens again: cargo run --release -- golden render",
                )
            })?;
            results.push(GroupResult {
                name: group.name,
                worth: group.worth,
                outcome,
                worst,
            });
        }
        Ok(TaskResult {
            name: task.name.clone(),
            chapter: task.chapter.clone(),
            replaced: self.program.replaced.get(&task.name).cloned(),
            groups: results,
        })
    }

    fn parts(&self, task: &Task, group: &str) -> Result<Vec<Part>> {
        if task.name == "viewing_ray" && group == SCENES_GROUP {
            return self
                .goldens
                .scenes
                .iter()
                .map(|scene| self.scene_rays(scene))
                .collect();
        }
        let stem = self
            .goldens
            .folder
            .join("probes")
            .join(format!("{}.{group}", task.name));
        let (job, resolution) = probe::read(&with_suffix(&stem, ".ask.exr"), &task.name)?;
        let golden = Standard::read(with_suffix(&stem, ".exr"))?;
        Ok(vec![Part {
            name: group.into(),
            job,
            resolution,
            golden,
        }])
    }

    fn scene_rays(&self, scene: &GoldenScene) -> Result<Part> {
        let name = &scene.name;
        let scene = Scene::read(&scene.file)?;
        let golden = Standard::read(self.goldens.folder.join(name).with_extension("rays.exr"))?;
        let resolution = scene.resolution;
        Ok(Part {
            name: name.clone(),
            job: viewing_rays(&scene),
            resolution,
            golden,
        })
    }

    fn scene(&self, scene: &GoldenScene, printed: &mut String) -> Result<SceneResult> {
        let GoldenScene { name, file, worth } = scene;
        let scene = Scene::read(file)?;
        let golden = Standard::read(self.goldens.folder.join(name).with_extension("exr"))?;
        let resolution = scene.resolution;
        let start = Instant::now();
        let reply = self.ask(name, &Job::Film(scene))?;
        let seconds = start.elapsed().as_secs_f64();
        printed.push_str(&reply.printed);
        let outcome = self.judge(&reply, resolution, &golden, None)?;
        Ok(SceneResult {
            name: name.clone(),
            worth: *worth,
            outcome,
            seconds,
        })
    }

    fn ask(&self, what: &str, job: &Job) -> Result<Reply> {
        run(self.program, self.sandbox, self.wall, job, &mut |done| {
            (self.progress)(what, done as f64 / job.len().max(1) as f64);
        })
    }

    /// An outcome from a reply; `task` if one answer was asked alone.
    fn judge(
        &self,
        reply: &Reply,
        size: Resolution,
        standard: &Standard,
        task: Option<&str>,
    ) -> Result<Outcome> {
        let complete = reply.answers.iter().all(Option::is_some);
        if let Some(failure) = failure(&reply.ending, self.assignment, task).filter(|_| !complete) {
            return Ok(failure);
        }
        let film = reply.film(size);
        let outcome = match judge(&standard.golden, &film) {
            Ok(verdict) => Outcome::Judged(verdict),
            Err(refusal) => Outcome::Refused(refusal),
        };
        if let Some(second) = self.second_judge {
            second.confirm(&film, &standard.path, outcome.passes())?;
        }
        Ok(outcome)
    }
}

/// What an ending means for whoever was asked; `None` if all is well so far.
pub fn failure(ending: &Ending, assignment: &Assignment, task: Option<&str>) -> Option<Outcome> {
    Some(match ending {
        Ending::Complete => return None,
        Ending::Panicked(panic) if panic.is_unanswered() => match task_of(panic, assignment) {
            Some(other) if Some(other) != task => Outcome::BlockedBy(other.into()),
            _ => Outcome::Unanswered,
        },
        Ending::Panicked(panic) => Outcome::Panicked(panic.clone()),
        Ending::TimedOut(limit) => Outcome::TimedOut {
            seconds: limit.as_secs_f64(),
        },
        Ending::Died(how) => Outcome::Died(how.clone()),
        Ending::Garbled(why) => Outcome::Garbled(why.clone()),
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
    wall: Duration,
    job: &Job,
    progress: &mut dyn FnMut(usize),
) -> Result<Reply> {
    // Two cores' worth of processor time and some to start with.
    let seconds = 4 * wall.as_secs() + 2;
    let command = sandbox.runner(&program.executable, seconds);
    ask(command, job, wall, progress).map_err(|error| {
        Error::environment(
            format!("cannot start {}: {error}", program.executable.display()),
            "run this command again; if it persists, remove target/pinhole",
        )
    })
}

/// The job of a scene's viewing rays, pixel by pixel in image order.
pub fn viewing_rays(scene: &Scene) -> Job {
    let Scene {
        camera, resolution, ..
    } = *scene;
    let question = |index| CameraQuestion {
        camera,
        pixel: resolution.pixel(index),
        resolution,
    };
    Job::ViewingRay((0..resolution.pixels()).map(question).collect())
}

/// Several jobs of one kind as one.
fn join<'a>(jobs: impl Iterator<Item = &'a Job>) -> Option<Job> {
    let mut joined: Option<Job> = None;
    for job in jobs {
        match (&mut joined, job) {
            (None, job) => joined = Some(job.clone()),
            (Some(Job::ViewingRay(all)), Job::ViewingRay(more)) => all.extend(more),
            (Some(Job::Intersect(all)), Job::Intersect(more)) => all.extend_from_slice(more),
            (Some(Job::FirstHit(all)), Job::FirstHit(more)) => all.extend_from_slice(more),
            (Some(Job::TriangleSoup(all)), Job::TriangleSoup(more)) => all.extend_from_slice(more),
            _ => return None,
        }
    }
    joined
}

fn with_suffix(stem: &Path, suffix: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}
