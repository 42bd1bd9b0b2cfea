//! What a submission is asked, read from the goldens: groups of question films for each task, and
//! a film for each scene.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError};

use pinhole::job::Job;
use pinhole::judge::Golden;
use pinhole::kind::{self, CameraQuestion};
use pinhole::{Resolution, Scene};

use crate::assignment::{EarlierAnswer, GroupPoints, Task};
use crate::error::{Error, Result};
use crate::goldens::{GoldenScene, Goldens};
use crate::timings::timed;

/// All questions of a task.
#[derive(Debug)]
pub struct Questions {
    pub groups: Vec<Group>,
    /// The groups in order, split into batches. One process is asked about each batch.
    pub batches: Vec<Batch>,
}

/// Groups that one process is asked about. A process that sees pixels of scenes, which may be
/// withheld, is asked about nothing else. Otherwise, its code could hide what it has seen in a
/// wrong answer to a public question, which results show.
#[derive(Debug)]
pub struct Batch {
    /// How many groups.
    pub groups: usize,
    /// The jobs of all their films as one; `None` if their kinds differ or there is no film.
    pub job: Option<Job>,
}

impl Questions {
    fn in_batches(groups: Vec<Group>, of_scenes: impl Fn(&Group) -> bool) -> Questions {
        let batches = groups.chunk_by(|a, b| of_scenes(a) == of_scenes(b));
        let batches = batches.map(|groups| Batch {
            groups: groups.len(),
            job: join(groups),
        });
        let batches = batches.collect();
        Questions { groups, batches }
    }

    /// The groups of each batch, and the jobs of all of them as one.
    pub fn batches(&self) -> impl Iterator<Item = (&[Group], Option<&Job>)> {
        let mut next = 0;
        self.batches.iter().map(move |batch| {
            let first = next;
            next += batch.groups;
            (&self.groups[first..next], batch.job.as_ref())
        })
    }
}

/// Questions that earn their points together or not at all.
#[derive(Debug)]
pub struct Group {
    /// The group's name in `assignment.toml`.
    pub name: String,
    /// Points.
    pub worth: u32,
    /// What it asks, in words.
    pub about: String,
    /// Its films: usually one, but the group of all scenes' viewing rays has one for each
    /// scene.
    pub films: Vec<QuestionFilm>,
}

/// Questions laid out as a film, and the golden film of their answers.
#[derive(Debug)]
pub struct QuestionFilm {
    /// The group's name, or the scene's.
    pub name: String,
    /// The questions, in image order.
    pub job: Job,
    /// How they are laid out.
    pub resolution: Resolution,
    /// Mitsuba's answers.
    pub golden: Golden,
    /// The file of those answers.
    pub golden_path: PathBuf,
}

impl Goldens {
    /// All groups of a task, in the assignment's order.
    pub fn groups(&self, task: &Task) -> Result<Vec<Group>> {
        let groups = task.points.iter();
        groups.map(|points| self.group(task, points)).collect()
    }

    /// All public questions about the task of an earlier assignment.
    pub fn of_earlier(course: &Path, earlier: &EarlierAnswer) -> Result<Questions> {
        let goldens = Goldens::bare(&course.join("golden").join(&earlier.assignment));
        let start = format!("{}.", earlier.task.name);
        let name = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().ok()?;
            let group = name.strip_prefix(&start)?.strip_suffix(".ask.exr")?;
            Some(group.to_owned())
        };
        let entries = fs::read_dir(goldens.folder.join("probes"));
        let entries = entries.into_iter().flatten().flatten();
        let mut names: Vec<String> = entries.filter_map(name).collect();
        names.sort();
        if names.is_empty() {
            return Err(Error::environment(
                format!(
                    "{} has no questions about `{}`",
                    goldens.folder.display(),
                    earlier.task.name
                ),
                "restore the goldens: git checkout -- golden",
            ));
        }
        let group = |name: &String| {
            Ok(Group {
                name: name.clone(),
                worth: 0,
                about: String::new(),
                films: vec![goldens.probe(&earlier.task, name)?],
            })
        };
        let groups = names.iter().map(group).collect::<Result<Vec<_>>>()?;
        Ok(Questions::in_batches(groups, |_| false))
    }

    /// The questions of a task, cached, because one run may examine many submissions.
    pub fn cached_questions(&self, task: &Task) -> Result<Arc<Questions>> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(questions) = kept().get(&task.name) {
            return Ok(Arc::clone(questions));
        }
        let groups = timed("read goldens", || self.groups(task))?;
        let of_scenes = |group: &Group| task.is_of_scenes(&group.name);
        let questions = Arc::new(Questions::in_batches(groups, of_scenes));
        kept().insert(task.name.clone(), Arc::clone(&questions));
        Ok(questions)
    }

    fn group(&self, task: &Task, points: &GroupPoints) -> Result<Group> {
        let films = match task.is_of_scenes(&points.group) {
            true => self
                .scenes
                .iter()
                .map(|scene| self.ray_film(scene))
                .collect::<Result<_>>()?,
            false => vec![self.judge_of_probes().probe(task, &points.group)?],
        };
        Ok(Group {
            name: points.group.clone(),
            worth: points.worth,
            about: points.about.clone(),
            films,
        })
    }

    /// The groups of a task that ask about pixels of scenes.
    pub fn scene_groups(&self, task: &Task) -> Result<Vec<Group>> {
        let points = task.points.iter();
        let of_scenes = points.filter(|points| task.is_of_scenes(&points.group));
        of_scenes.map(|points| self.group(task, points)).collect()
    }

    /// The groups of a task that do not ask about pixels of scenes.
    pub fn groups_without_scenes(&self, task: &Task) -> Result<Vec<Group>> {
        let points = task.points.iter();
        let others = points.filter(|points| !task.is_of_scenes(&points.group));
        others.map(|points| self.group(task, points)).collect()
    }

    /// The film of a scene.
    pub fn scene_film(&self, scene: &GoldenScene) -> Result<QuestionFilm> {
        let golden_path = self.folder.join(&scene.name).with_extension("exr");
        let name = scene.name.clone();
        let scene = read_scene(&scene.file)?;
        let resolution = scene.resolution;
        let golden = read_golden(&golden_path)?;
        Ok(QuestionFilm {
            name,
            job: Job::Film(scene),
            resolution,
            golden,
            golden_path,
        })
    }

    /// The film of a scene, cached.
    pub fn cached_scene(&self, scene: &GoldenScene) -> Result<Arc<QuestionFilm>> {
        let kept = || {
            self.scene_cache
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        if let Some(film) = kept().get(&scene.name) {
            return Ok(Arc::clone(film));
        }
        let film = Arc::new(timed("read goldens", || self.scene_film(scene))?);
        kept().insert(scene.name.clone(), Arc::clone(&film));
        Ok(film)
    }

    fn ray_film(&self, scene: &GoldenScene) -> Result<QuestionFilm> {
        let golden_path = self.folder.join(&scene.name).with_extension("rays.exr");
        let name = scene.name.clone();
        let scene = read_scene(&scene.file)?;
        let resolution = scene.resolution;
        let questions =
            (0..resolution.pixels()).map(|index| CameraQuestion::of_scene(&scene, index));
        let job = Job::Ask(kind::Questions::ViewingRay(questions.collect()));
        let golden = read_golden(&golden_path)?;
        Ok(QuestionFilm {
            name,
            job,
            resolution,
            golden,
            golden_path,
        })
    }

    /// The film of a task's group, unless the group asks about scenes.
    pub fn probe(&self, task: &Task, group: &str) -> Result<QuestionFilm> {
        let stem = self
            .folder
            .join("probes")
            .join(format!("{}.{group}", task.name));
        let golden_path = with_suffix(&stem, ".exr");
        let film = with_suffix(&stem, ".ask.exr");
        let (questions, resolution) =
            kind::Questions::read(&film, &task.name, task.kind, task.shape).map_err(ours)?;
        let golden = read_golden(&golden_path)?;
        Ok(QuestionFilm {
            name: group.into(),
            job: Job::Ask(questions),
            resolution,
            golden,
            golden_path,
        })
    }
}

/// The questions of all films as one job.
fn join(groups: &[Group]) -> Option<Job> {
    let mut joined: Option<kind::Questions> = None;
    for film in groups.iter().flat_map(|group| &group.films) {
        let Job::Ask(questions) = &film.job else {
            return None;
        };
        match &mut joined {
            None => joined = Some(questions.clone()),
            Some(all) => all.append(questions).then_some(())?,
        }
    }
    joined.map(Job::Ask)
}

fn with_suffix(stem: &Path, suffix: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}

fn read_scene(path: &Path) -> Result<Scene> {
    Scene::read(path).map_err(ours)
}

fn read_golden(path: &Path) -> Result<Golden> {
    Golden::read(path).map_err(ours)
}

/// An unusable golden is Pinhole's fault, not that of the submission.
fn ours(error: pinhole::Error) -> Error {
    Error::environment(
        format!("{}: {}", error.path.display(), error.problem),
        "restore the goldens: git checkout -- golden",
    )
}
