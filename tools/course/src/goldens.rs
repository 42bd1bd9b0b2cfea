//! A folder of goldens and the scenes that it can judge.

pub mod questions;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use crate::assignment::Assignment;
use crate::diagnosis::known::{self, KnownMistakes};
use crate::error::{Error, Result};
use crate::goldens::questions::{QuestionFilm, Questions};
use crate::manifest::Manifest;

/// Golden films, question films, and the scenes they were made from.
#[derive(Clone, Debug)]
pub struct Goldens {
    /// The folder of the films.
    pub folder: PathBuf,
    /// The scenes, in the order they are cast.
    pub scenes: Vec<GoldenScene>,
    /// The known mistakes.
    pub known: KnownMistakes,
    /// Questions that have been read, by task.
    pub kept: Arc<Mutex<BTreeMap<String, Arc<Questions>>>>,
    /// Films of scenes that have been read, by name.
    pub scene_cache: Arc<Mutex<BTreeMap<String, Arc<QuestionFilm>>>>,
    /// The goldens whose questions are asked if this folder has only scenes.
    pub probes: Option<Box<Goldens>>,
}

/// A scene with a golden film.
#[derive(Clone, Debug)]
pub struct GoldenScene {
    /// The film is `NAME.exr`.
    pub name: String,
    /// How to name the scene on the command line: by its name if it belongs to the assignment,
    /// otherwise by its file.
    pub argument: String,
    /// The scene file.
    pub file: PathBuf,
    /// Points for a film that passes.
    pub worth: u32,
}

impl Goldens {
    /// The goldens in `folder`.
    ///
    /// A folder with scenes of its own, such as `golden render --seed` makes, is judged on those,
    /// which share the points of the assignment's scenes. Any other folder is judged on the
    /// assignment's scenes.
    pub fn read(folder: &Path, assignment: &Assignment) -> Result<Goldens> {
        if !folder.is_dir() {
            return Err(Error::input(
                format!("there is no folder of goldens {}", folder.display()),
                "make one: cargo pinhole golden render --seed 1 --out DIR",
            ));
        }
        let entries = fs::read_dir(folder.join("scenes"))
            .into_iter()
            .flatten()
            .flatten();
        let is_scene = |path: &PathBuf| path.extension().is_some_and(|end| end == "toml");
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(is_scene).collect();
        files.sort();
        let scenes = match files.len() {
            0 => assignment
                .scenes
                .iter()
                .map(|scene| GoldenScene {
                    name: scene.name.clone(),
                    argument: scene.name.clone(),
                    file: assignment.scene(&scene.name),
                    worth: scene.points,
                })
                .collect(),
            count => {
                let all: u32 = assignment.scenes.iter().map(|scene| scene.points).sum();
                let shares = shares(all, count as u32);
                files
                    .into_iter()
                    .zip(shares)
                    .map(|(file, worth)| own(file, worth))
                    .collect()
            }
        };
        Ok(Goldens {
            scenes,
            known: KnownMistakes::read(folder)?,
            ..Goldens::bare(folder)
        })
    }

    /// Goldens of an assignment from any folder, even one with scenes alone, such as `golden
    /// render my.toml --out DIR` makes. Its scenes share the points of the assignment's scenes,
    /// and the assignment's public questions are asked.
    pub fn find(folder: &Path, assignment: &Assignment) -> Result<Goldens> {
        let manifest = Manifest::read_or_new(folder)?;
        if manifest.probe_seed.is_some() || manifest.sources.is_empty() {
            return Goldens::read(folder, assignment);
        }
        let files = manifest.scenes(folder, assignment);
        let mut goldens = Goldens::of_scenes(folder, &files)?;
        let all: u32 = assignment.scenes.iter().map(|scene| scene.points).sum();
        for (scene, worth) in goldens
            .scenes
            .iter_mut()
            .zip(shares(all, files.len() as u32))
        {
            scene.worth = worth;
        }
        let public = Goldens::read(&assignment.golden(), assignment)?;
        goldens.probes = Some(Box::new(public));
        Ok(goldens)
    }

    /// For each scene, the tasks whose answers it needs.
    pub fn needs_of_scenes<'a>(&self, assignment: &'a Assignment) -> Result<Vec<Vec<&'a str>>> {
        let needs = |scene: &GoldenScene| {
            let film = self.cached_scene(scene)?;
            let tasks = assignment.tasks.iter();
            let needed = tasks.filter(|task| film.job.needs(task.kind, task.shape));
            Ok(needed.map(|task| task.name.as_str()).collect())
        };
        self.scenes.iter().map(needs).collect()
    }

    /// Refuses a scene whose points everybody would get, because it needs no task.
    pub fn refuse_scene_without_tasks(&self, assignment: &Assignment) -> Result<()> {
        let needs = self.needs_of_scenes(assignment)?;
        let mut all = self.scenes.iter().zip(needs);
        match all.find(|(_, needs)| needs.is_empty()) {
            None => Ok(()),
            Some((scene, _)) => Err(Error::input(
                format!(
                    "the scene `{}` needs no answer to any task, so everybody would get its points",
                    scene.name
                ),
                "add an object that an answer is about, such as a mesh, or leave the scene out",
            )),
        }
    }

    /// The goldens that single tasks are judged by.
    pub fn judge_of_probes(&self) -> &Goldens {
        self.probes.as_deref().unwrap_or(self)
    }

    /// The goldens of these scene files in `folder`. Other files there are ignored.
    pub fn of_scenes(folder: &Path, files: &[PathBuf]) -> Result<Goldens> {
        Ok(Goldens {
            scenes: files.iter().cloned().map(|file| own(file, 0)).collect(),
            known: KnownMistakes::read(folder)?,
            ..Goldens::bare(folder)
        })
    }

    /// A folder of goldens without scenes and known mistakes.
    fn bare(folder: &Path) -> Goldens {
        Goldens {
            folder: folder.into(),
            scenes: Vec::new(),
            known: KnownMistakes::default(),
            kept: Arc::default(),
            scene_cache: Arc::default(),
            probes: None,
        }
    }

    /// The goldens of the folder that holds this film, which may be a question film.
    pub fn around(golden: &Path) -> Result<Goldens> {
        let beside = golden.parent().unwrap_or(Path::new(""));
        let above = beside.parent().unwrap_or(Path::new(""));
        let knows = |folder: &&Path| folder.join(known::FILE).is_file();
        let folder = [beside, above].into_iter().find(knows).unwrap_or(beside);
        Goldens::of_scenes(folder, &[])
    }

    /// These goldens, without this known mistake.
    pub fn unaware_of(&self, slug: &str) -> Goldens {
        let mut goldens = self.clone();
        goldens.known.mistake.remove(slug);
        goldens
    }

    /// These goldens without known mistakes, so that nothing is diagnosed.
    pub fn without_known(&self) -> Goldens {
        Goldens {
            known: KnownMistakes::default(),
            ..self.clone()
        }
    }

    /// A film's name: its path in the folder, without `.exr`.
    pub fn film_name(&self, golden: &Path) -> String {
        let inside = golden.strip_prefix(&self.folder).unwrap_or(golden);
        let name = inside.with_extension("");
        name.to_string_lossy().replace('\\', "/")
    }
}

/// The path of the film that says how many tests the reference took for each pixel of a golden's
/// scene. Only assignments that count tests have one.
pub fn tests_beside(golden: &Path) -> PathBuf {
    golden.with_extension("tests.exr")
}

fn own(file: PathBuf, worth: u32) -> GoldenScene {
    let name = file
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    GoldenScene {
        name,
        argument: file.display().to_string(),
        file,
        worth,
    }
}

/// Splits `all` points into `count` shares that differ by at most 1.
pub fn shares(all: u32, count: u32) -> impl Iterator<Item = u32> {
    (0..count).map(move |k| all / count + u32::from(k < all % count))
}

#[cfg(test)]
#[test]
fn scene_that_needs_no_task_is_refused() {
    use crate::checkout::Checkout;

    let checkout = Checkout::find().unwrap();
    let assignment = Assignment::read(&checkout, "bounding_volumes").unwrap();
    let folder = tempfile::tempdir().expect("there is room");
    let of = |objects: &str| {
        for end in ["exr", "tol.exr"] {
            let film = assignment.golden().join(format!("lone_triangle.{end}"));
            let copy = folder.path().join(format!("alone.{end}"));
            fs::copy(film, copy).expect("it is committed");
        }
        let scene = assignment.folder.join("scenes/lone_triangle.toml");
        let scene = fs::read_to_string(scene).expect("it is committed");
        let (camera, _) = scene.split_once("[[object]]").expect("it has objects");
        let file = folder.path().join("alone.toml");
        fs::write(&file, format!("{camera}{objects}")).expect("there is room");
        let goldens = Goldens::of_scenes(folder.path(), &[file]).expect("they are there");
        goldens.refuse_scene_without_tasks(&assignment)
    };
    let triangle = "[[object]]\ntype = \"triangle\"\ncorners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n";
    let refused = of(triangle).expect_err("only we answer questions about triangles");
    assert!(refused.to_string().contains("needs no answer"), "{refused}");
    let mesh = assignment.folder.join("scenes/meshes/lone_triangle.obj");
    let soup = format!("[[object]]\ntype = \"soup\"\nobj = {mesh:?}\n");
    of(&format!("{triangle}{soup}")).expect("the soup needs tasks");
}
