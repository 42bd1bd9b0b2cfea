//! An assignment: its tasks, scenes and points, read from `assignment.toml`.

mod find;
mod parts;

use std::fs;
use std::path::{Path, PathBuf};

use pinhole::{Kind, Scene, ShapeKind};

use crate::error::{Error, Result};

pub use self::parts::{
    DroppedGroup, DroppedPoints, EXAMPLES, EarlierAnswer, ExamplePoints, Finish, GroupPoints,
    ScenePoints, Task, examples_file,
};

/// An assignment: what students are asked to do, and the folder that defines it.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// The name of its folder.
    pub name: String,
    /// The folder that defines it.
    pub folder: PathBuf,
    /// The title that people read.
    pub title: String,
    /// The tasks, in the order students meet them.
    pub tasks: Vec<Task>,
    /// The answer of an earlier assignment that students may hand in again, if there is one.
    pub earlier: Option<EarlierAnswer>,
    /// The name of the task to begin with.
    pub start: String,
    /// The scenes, in the order they are cast.
    pub scenes: Vec<ScenePoints>,
    /// Points for withheld scenes that are missing from this checkout.
    pub withheld: u32,
    /// How many public solutions we read to see how common its mistakes are; `None` if we read
    /// none.
    pub solutions_read: Option<u32>,
    /// What to show a student who has earned all points.
    pub finish: Option<Finish>,
    /// Groups of questions that do not count when a class is graded.
    pub dropped: Vec<DroppedGroup>,
}

impl Assignment {
    /// The folder of stubs that students start from.
    pub fn handout(&self) -> PathBuf {
        self.folder.join("handout")
    }

    /// The folder of golden films: for `X/assignments/NAME`, `X/golden/NAME`.
    pub fn golden(&self) -> PathBuf {
        self.course().join("golden").join(&self.name)
    }

    /// The folder of assignments and goldens: `X` of `X/assignments/NAME`.
    pub fn course(&self) -> &Path {
        self.folder.ancestors().nth(2).unwrap_or(Path::new(""))
    }

    /// The folder of the reference answers.
    pub fn reference(&self) -> PathBuf {
        self.folder.join("reference")
    }

    /// The folder with untouched copies of the stubs, in a student's repository. Students write
    /// their answers into the handout's folder.
    pub fn pristine(&self) -> PathBuf {
        self.folder.join("stubs")
    }

    /// The tasks that a submission may answer: those of this assignment, then the one of an earlier
    /// assignment.
    pub fn answerable(&self) -> impl Iterator<Item = &Task> {
        let earlier = self.earlier.iter().map(|earlier| &earlier.task);
        self.tasks.iter().chain(earlier)
    }

    /// The tasks that give points for examples.
    pub fn with_examples(&self) -> impl Iterator<Item = &Task> {
        self.tasks.iter().filter(|task| task.examples.is_some())
    }

    /// The files around the answers, which are the same in every submission.
    pub fn fixed_files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.reference().join("src"))
            .into_iter()
            .flatten()
            .flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let is_answer = |name: &String| self.tasks.iter().any(|task| task.file() == *name);
        let mut fixed: Vec<String> = names
            .filter(|name| name.ends_with(".rs") && !is_answer(name))
            .collect();
        fixed.sort();
        fixed
    }

    /// The path of a scene's file.
    pub fn scene(&self, name: &str) -> PathBuf {
        self.folder.join("scenes").join(name).with_extension("toml")
    }

    /// Finds the scene that a user named, by its file or by its name in the assignment. Also
    /// returns the path of its golden film, if one is committed.
    pub fn find_scene(&self, named: &str) -> Result<(Scene, Option<PathBuf>)> {
        let path = self.find_scene_file(named)?;
        let golden = path.file_stem().map(|stem| {
            let golden = self.golden().join(stem);
            golden.with_extension("exr")
        });
        let folder = path.canonicalize().ok();
        let folder = folder.and_then(|path| Some(path.parent()?.to_owned()));
        let is_own = folder == self.folder.join("scenes").canonicalize().ok();
        Ok((
            Scene::read(&path)?,
            golden.filter(|golden| is_own && golden.is_file()),
        ))
    }

    /// The file of the scene that a user named.
    pub fn find_scene_file(&self, named: &str) -> Result<PathBuf> {
        let file = Path::new(named);
        let own = self.scene(named);
        match (file.is_file(), own.is_file()) {
            (true, _) => Ok(file.into()),
            (false, true) => Ok(own),
            (false, false) => {
                let scenes = self.scenes.iter();
                let names: Vec<&str> = scenes.map(|scene| scene.name.as_str()).collect();
                Err(Error::input(
                    format!("there is no scene {named}"),
                    format!("name a TOML file, or one of: {}", names.join(", ")),
                ))
            }
        }
    }

    /// The scenes that students do not get.
    pub fn withheld_scenes(&self) -> impl Iterator<Item = &ScenePoints> {
        self.scenes.iter().filter(|scene| !scene.public)
    }

    /// Whether a film shows a withheld scene. Takes the film's name without `.exr`, or the
    /// name of any file that belongs to it.
    pub fn withholds(&self, film: &str) -> bool {
        let scene = film.split('.').next().unwrap_or(film);
        self.withheld_scenes()
            .any(|withheld| withheld.name == scene)
    }

    /// The task of this name.
    pub fn task(&self, name: &str) -> Option<&Task> {
        self.tasks.iter().find(|task| task.name == name)
    }

    /// The groups of questions about the pixels of scenes: task and group.
    pub fn scene_groups(&self) -> Vec<(String, String)> {
        let groups = self.tasks.iter().flat_map(|task| {
            let groups = task.points.iter().map(|points| &points.group);
            let of_scenes = groups.filter(|group| task.is_of_scenes(group));
            of_scenes.map(|group| (task.name.clone(), group.clone()))
        });
        groups.collect()
    }

    /// The task of this kind, and about this shape if the kind takes one.
    pub fn task_of_kind(&self, kind: Kind, shape: Option<ShapeKind>) -> Option<&Task> {
        let is_asked =
            |task: &&Task| task.kind == kind && (task.shape.is_none() || task.shape == shape);
        self.tasks.iter().find(is_asked)
    }
}
