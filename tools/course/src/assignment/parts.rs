//! What an assignment consists of and what each part is worth: tasks with their groups of
//! questions, and scenes.

use pinhole::{Kind, ShapeKind};
use serde::Deserialize;
use toml::Spanned;

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
    /// Points for examples that students may hand in; `None` if there are none.
    pub examples: Option<Spanned<ExamplePoints>>,
}

/// What the examples that a student hands in for a task are worth, all or nothing.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExamplePoints {
    /// Points, at least 1.
    pub points: u32,
    /// The share of the task's known mistakes that they must catch: more than 0, at most 1.
    pub catch: f64,
}

/// The name of the group that stands for a task's examples.
pub const EXAMPLES: &str = "examples";

/// The name of the file with the examples of a task.
pub fn examples_file(task: &str) -> String {
    format!("{task}.examples.toml")
}

/// An answer to a task of an earlier assignment, which students may hand in again. Scenes are cast
/// with it if it passes that task's public questions.
#[derive(Clone, Debug, Deserialize)]
#[serde(from = "EarlierEntry")]
pub struct EarlierAnswer {
    /// The name of the earlier assignment.
    pub assignment: String,
    /// The task. It earns no points here, and its groups of questions are not listed.
    pub task: Task,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EarlierEntry {
    assignment: String,
    task: String,
    kind: Kind,
    shape: Option<ShapeKind>,
}

impl From<EarlierEntry> for EarlierAnswer {
    fn from(entry: EarlierEntry) -> EarlierAnswer {
        EarlierAnswer {
            assignment: entry.assignment,
            task: Task {
                name: entry.task,
                kind: entry.kind,
                shape: entry.shape,
                chapter: String::new(),
                points: Vec::new(),
                examples: None,
            },
        }
    }
}

/// A group of questions and what it is worth: `["inside", 3, "what is asked"]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(from = "(String, u32, String)")]
pub struct GroupPoints {
    /// Its name.
    pub group: String,
    /// Points for a group without a wrong answer.
    pub worth: u32,
    /// What it asks, in words for a student who fails it.
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

/// A group of questions that does not count, for instance because it was ambiguous.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DroppedGroup {
    /// The group, as `task.group`.
    pub group: String,
    /// What becomes of its points.
    pub points: DroppedPoints,
}

/// What becomes of the points of a group that was dropped.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq)]
#[serde(rename_all = "lowercase")]
pub enum DroppedPoints {
    /// Everybody gets them.
    Given,
    /// They are left out: the mark is out of fewer points, so everything else counts for more.
    Rescaled,
}

/// A scene and what casting it right is worth.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScenePoints {
    /// The file is `scenes/NAME.toml`.
    pub name: String,
    /// Points for a film that passes.
    pub points: u32,
    /// Whether students get it. A withheld scene is cast only for grading.
    #[serde(default = "is_public")]
    pub public: bool,
}

fn is_public() -> bool {
    true
}

impl Task {
    /// Its answer file's name.
    pub fn file(&self) -> String {
        format!("{}.rs", self.name)
    }

    /// Everything that earns points: the groups of questions, then the examples.
    pub fn all_points(&self) -> impl Iterator<Item = GroupPoints> {
        let examples = self.examples.iter().map(|examples| GroupPoints {
            group: EXAMPLES.into(),
            worth: examples.get_ref().points,
            about: "questions whose answers you work out by hand".into(),
        });
        self.points.iter().cloned().chain(examples)
    }

    /// Whether somebody could earn its points for examples, if there are any.
    pub(super) fn has_fair_examples(&self) -> bool {
        let Some(ExamplePoints { points, catch }) = self.examples.as_ref().map(Spanned::get_ref)
        else {
            return true;
        };
        let is_free = self.points.iter().all(|points| points.group != EXAMPLES);
        let is_share = *catch > 0.0 && *catch <= 1.0;
        *points > 0 && is_share && is_free && self.kind.has_one_answer()
    }

    pub(super) fn has_shape_if_it_takes_one(&self) -> bool {
        self.kind.takes_shape() == self.shape.is_some()
    }

    /// Whether this group asks about every pixel of every scene.
    pub fn is_of_scenes(&self, group: &str) -> bool {
        self.kind.gives_rays() && group == SCENES_GROUP
    }
}

/// The group of the viewing rays of all scenes.
const SCENES_GROUP: &str = "scenes";

#[cfg(test)]
mod tests {
    use super::*;

    fn task(kind_and_shape: &str) -> Task {
        let rest = "name = \"a\"\nchapter = \"A\"\npoints = []";
        toml::from_str(&format!("{kind_and_shape}\n{rest}")).expect("a task")
    }

    #[test]
    fn only_intersection_tasks_name_a_shape() {
        for (text, is_right) in [
            ("kind = \"intersect\"\nshape = \"disk\"", true),
            ("kind = \"intersect\"", false),
            ("kind = \"soup\"", true),
            ("kind = \"soup\"\nshape = \"soup\"", false),
        ] {
            assert_eq!(task(text).has_shape_if_it_takes_one(), is_right, "{text}");
        }
    }

    #[test]
    fn examples_earn_points_only_if_somebody_could_earn_them() {
        for (kind, points, catch, is_right) in [
            ("soup", 1, 0.5, true),
            ("soup", 0, 0.5, false),
            ("soup", 1, 0.0, false),
            ("soup", 1, 1.1, false),
            ("tree", 1, 0.5, false),
        ] {
            let examples = format!("{{ points = {points}, catch = {catch:?} }}");
            let text = format!("kind = {kind:?}\nexamples = {examples}");
            assert_eq!(task(&text).has_fair_examples(), is_right, "{text}");
        }
    }
}

/// What to show a student who has earned all points.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Finish {
    /// The public scene whose picture, cast by the student's own answers, is shown.
    pub scene: String,
    /// The chapter to read next.
    pub chapter: String,
}
