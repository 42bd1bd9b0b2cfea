//! An assignment: its tasks, scenes and points, read from `assignment.toml`.

use std::fs;
use std::path::{Path, PathBuf};

use pinhole::{Kind, Scene, ShapeKind};
use serde::Deserialize;

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};

/// What students are asked, and where it lies.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// The folder's name.
    pub name: String,
    /// The folder.
    pub folder: PathBuf,
    /// As people say it.
    pub title: String,
    /// In the order students meet them.
    pub tasks: Vec<Task>,
    /// The task that is good to begin with.
    pub start: String,
    /// In the order they are cast.
    pub scenes: Vec<ScenePoints>,
    /// Points of scenes that students do not have here.
    pub withheld: u32,
}

/// One answer file and what it is worth.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// The file is `NAME.rs`.
    pub name: String,
    /// What kind of questions it answers.
    pub kind: Kind,
    /// Which shape it intersects, if it is of that kind.
    pub shape: Option<ShapeKind>,
    /// The chapter of the book that teaches it.
    pub chapter: String,
    /// Groups of questions and their points, in the order they are shown.
    pub points: Vec<GroupPoints>,
}

/// A group of questions and what it is worth: `["inside", 3, "what is asked"]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(from = "(String, u32, String)")]
pub struct GroupPoints {
    /// Its name.
    pub group: String,
    /// Points for a group without a wrong answer.
    pub worth: u32,
    /// What it asks, in words for somebody who fails it.
    pub about: String,
}

impl From<(String, u32, String)> for GroupPoints {
    fn from((group, worth, about): (String, u32, String)) -> GroupPoints {
        GroupPoints {
            group,
            worth,
            about,
        }
    }
}

/// A scene and what casting it right is worth.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScenePoints {
    /// The file is `scenes/NAME.toml`.
    pub name: String,
    /// Points for a film that passes.
    pub points: u32,
    /// Whether students get it; a withheld scene is cast when it is graded only.
    #[serde(default = "is_public")]
    pub public: bool,
}

fn is_public() -> bool {
    true
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: String,
    start: Option<String>,
    #[serde(default)]
    withheld: u32,
    task: Vec<Task>,
    scene: Vec<ScenePoints>,
}

impl Assignment {
    /// The assignment that is meant: the one of this name, or in the folder of this name;
    /// without a name, the one that `folder` lies in, or else the checkout's default.
    ///
    /// # Errors
    /// If there is no such assignment, or its file is wrong.
    pub fn find(checkout: &Checkout, name: Option<&str>, folder: &Path) -> Result<Assignment> {
        match name {
            Some(name) => Assignment::named(checkout, name),
            None => Assignment::around(checkout, folder),
        }
    }

    fn named(checkout: &Checkout, name: &str) -> Result<Assignment> {
        // The whole path, as goldens lie beside the folder above.
        let folder = Path::new(name).canonicalize().ok();
        let folder = folder.filter(|folder| folder.join("assignment.toml").is_file());
        match folder
            .as_deref()
            .and_then(|folder| Some((folder, folder.file_name()?)))
        {
            Some((folder, own)) => Assignment::in_folder(checkout, folder, &own.to_string_lossy()),
            None => Assignment::read(checkout, name),
        }
    }

    /// The assignment of this name.
    pub fn read(checkout: &Checkout, name: &str) -> Result<Assignment> {
        Assignment::in_folder(checkout, &checkout.assignments().join(name), name)
    }

    fn in_folder(checkout: &Checkout, folder: &Path, name: &str) -> Result<Assignment> {
        let path = folder.join("assignment.toml");
        let text = fs::read_to_string(&path).or_input(
            format_args!("cannot read {}", path.display()),
            format!(
                "name an assignment of this checkout: {}",
                names(checkout).join(", ")
            ),
        )?;
        let file: File = toml::from_str(&text).or_input(
            format_args!("{}", path.display()),
            "correct the assignment file",
        )?;
        if let Some(task) = file
            .task
            .iter()
            .find(|task| !task.has_shape_if_it_takes_one())
        {
            return Err(Error::input(
                format!(
                    "{}: task `{}` of kind `{}` names {}",
                    path.display(),
                    task.name,
                    task.kind,
                    task.shape
                        .map_or("no shape".into(), |shape| format!("the shape `{shape}`")),
                ),
                "give a `shape` to tasks that intersect one, and to no others",
            ));
        }
        let first = file.task.first().map(|task| task.name.clone());
        Ok(Assignment {
            start: file.start.or(first).unwrap_or_default(),
            name: name.into(),
            folder: folder.into(),
            title: file.title,
            tasks: file.task,
            scenes: file.scene,
            withheld: file.withheld,
        })
    }

    /// The assignment a folder lies in, or else the default.
    fn around(checkout: &Checkout, folder: &Path) -> Result<Assignment> {
        let folder = folder.canonicalize();
        let holds = |name: &String| {
            let own = checkout.assignments().join(name).canonicalize();
            own.is_ok_and(|own| folder.as_ref().is_ok_and(|folder| folder.starts_with(own)))
        };
        match names(checkout).into_iter().find(holds) {
            Some(name) => Assignment::read(checkout, &name),
            None => Assignment::read(checkout, &checkout.default_assignment()?),
        }
    }

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

    /// The folder of our own answers.
    pub fn reference(&self) -> PathBuf {
        self.folder.join("reference")
    }

    /// The answers that cast when nobody says whose: our own, or, in a student's
    /// repository, which has none of ours, the student's.
    pub fn own_answers(&self) -> PathBuf {
        match self.reference().is_dir() {
            true => self.reference(),
            false => self.handout(),
        }
    }

    /// The stubs as they were handed out, in a student's repository: the handout's
    /// folder is where students write.
    pub fn pristine(&self) -> PathBuf {
        self.folder.join("stubs")
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

    /// The file of one of its scenes.
    pub fn scene(&self, name: &str) -> PathBuf {
        self.folder.join("scenes").join(name).with_extension("toml")
    }

    /// The scene a user means: a file, or one of the assignment's by name. With it comes
    /// its golden film's path, if one is committed.
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

    /// Where the scene lies that a user means.
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

    /// Whether a film, by its name without `.exr`, or a file of it shows a withheld scene.
    pub fn withholds(&self, film: &str) -> bool {
        let scene = film.split('.').next().unwrap_or(film);
        self.withheld_scenes()
            .any(|withheld| withheld.name == scene)
    }

    /// The task of this name.
    pub fn task(&self, name: &str) -> Option<&Task> {
        self.tasks.iter().find(|task| task.name == name)
    }

    /// Task and group of all questions that are made of scenes' pixels.
    pub fn scene_groups(&self) -> Vec<(String, String)> {
        let groups = self.tasks.iter().flat_map(|task| {
            let groups = task.points.iter().map(|points| &points.group);
            let of_scenes = groups.filter(|group| task.is_of_scenes(group));
            of_scenes.map(|group| (task.name.clone(), group.clone()))
        });
        groups.collect()
    }

    /// The task of this kind, and of this shape where the kind needs one.
    pub fn task_of_kind(&self, kind: Kind, shape: Option<ShapeKind>) -> Option<&Task> {
        let is_asked =
            |task: &&Task| task.kind == kind && (task.shape.is_none() || task.shape == shape);
        self.tasks.iter().find(is_asked)
    }
}

impl Task {
    /// Its answer file's name.
    pub fn file(&self) -> String {
        format!("{}.rs", self.name)
    }

    fn has_shape_if_it_takes_one(&self) -> bool {
        self.kind.takes_shape() == self.shape.is_some()
    }

    /// Whether a group of its questions is made of all pixels of all scenes.
    pub fn is_of_scenes(&self, group: &str) -> bool {
        self.kind.gives_rays() && group == SCENES_GROUP
    }
}

/// The group of the viewing rays of all scenes.
const SCENES_GROUP: &str = "scenes";

/// The assignments of a checkout, by name.
fn names(checkout: &Checkout) -> Vec<String> {
    let entries = fs::read_dir(checkout.assignments())
        .into_iter()
        .flatten()
        .flatten();
    let mut names: Vec<String> = entries
        .filter(|entry| entry.path().join("assignment.toml").is_file())
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn task(kind_and_shape: &str) -> Task {
        let rest = "name = \"a\"\nchapter = \"A\"\npoints = []";
        toml::from_str(&format!("{kind_and_shape}\n{rest}")).expect("a task")
    }

    #[test]
    fn who_intersects_says_what_and_nobody_else_does() {
        for (text, is_right) in [
            ("kind = \"intersect\"\nshape = \"disk\"", true),
            ("kind = \"intersect\"", false),
            ("kind = \"soup\"", true),
            ("kind = \"soup\"\nshape = \"soup\"", false),
        ] {
            assert_eq!(task(text).has_shape_if_it_takes_one(), is_right, "{text}");
        }
    }
}
