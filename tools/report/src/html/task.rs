//! A task on the page.

use serde::Serialize;

use super::belief::Beliefs;
use super::heat::HeatMaps;
use super::ray_drawing::RayDrawing;
use super::tree::TreeDrawings;
use crate::escape::printable;
use crate::passage::Passage;
use crate::terminal;
use pinhole::Fact;
use pinhole_course::assignment::EXAMPLES;
use pinhole_course::outcome::{
    AnswerFile, FilmOutcome, GroupOutcome, GroupPicture, Picture, TaskOutcome,
};

/// One answer, judged alone.
#[derive(Debug, Serialize)]
pub struct TaskSection {
    /// The page's own id for it, because a task's name could break a link.
    pub id: String,
    pub name: String,
    pub passes: bool,
    pub earned: u32,
    pub possible: u32,
    /// The verdict in a line.
    pub said: String,
    /// Whether anything was answered. If not, there is no more to say.
    pub attempted: bool,
    /// Its groups, but only that of its examples if the code was not asked.
    pub groups: Vec<GroupRow>,
    /// The compiler's messages about its file: errors, or else warnings.
    pub compiler: Option<String>,
    pub beliefs: Option<Beliefs>,
    /// What is measurably wrong, sentence by sentence.
    pub measured: Vec<String>,
    pub chapter: Passage,
    /// The command that shows this again; none if the public questions pass.
    pub command: Option<String>,
}

/// One group of questions.
#[derive(Debug, Serialize)]
pub struct GroupRow {
    pub name: String,
    pub passes: bool,
    pub worth: u32,
    pub said: String,
    /// Whether it has answers, and therefore a worst one.
    pub judged: bool,
    /// The worst question, or the one that the code did not get past, fact by fact.
    pub worst: Vec<Fact>,
    /// Heat maps of how many tests each question took, if they are counted.
    pub heat: Option<HeatMaps>,
    /// The worst of its trees, if it asks for trees.
    pub tree: Option<TreeDrawings>,
    /// Where its worst ray meets the image plane, if it asks for rays.
    pub ray: Option<RayDrawing>,
}

impl TaskSection {
    /// The `k`-th task; `pictures` are those of all tasks, and `again` is the command that
    /// examined it.
    pub fn of(k: usize, task: &TaskOutcome, pictures: &[GroupPicture], again: &str) -> TaskSection {
        let compiler = match &task.file {
            AnswerFile::DoesNotCompile { compiler } => Some(plain(compiler)),
            _ => (!task.warnings.is_empty()).then(|| plain(&task.warnings)),
        };
        let replaced = task.file != AnswerFile::Compiled;
        let mut groups = rows(task, pictures);
        if replaced || task.is_unanswered() {
            groups.retain(|row| row.name == EXAMPLES);
        }
        TaskSection {
            id: format!("task-{k}"),
            name: task.name.clone(),
            passes: task.points == task.possible,
            earned: task.points,
            possible: task.possible,
            said: terminal::task_in_words(task),
            attempted: replaced || !groups.is_empty(),
            groups,
            compiler,
            beliefs: Beliefs::of(&task.diagnosis, &[]),
            measured: task.measured.iter().map(|it| it.says.clone()).collect(),
            chapter: Passage::chapter(&task.chapter),
            command: shows_again(task).then(|| format!("{again} --task {}", task.name)),
        }
    }
}

/// Whether a student can see the failure. Only the grader has the fresh questions.
fn shows_again(task: &TaskOutcome) -> bool {
    let mut failing = task.groups.iter().filter(|group| !group.outcome.passes());
    failing.any(|group| !group.fails_fresh)
}

/// The rows of a task's groups. A row that would repeat an earlier failure word for word says "the
/// same".
fn rows(task: &TaskOutcome, pictures: &[GroupPicture]) -> Vec<GroupRow> {
    let mut told: Vec<String> = Vec::new();
    let row = |group: &GroupOutcome| {
        let said = terminal::group_in_words(group);
        let is_judged = matches!(group.outcome, FilmOutcome::Judged(_));
        let again = !is_judged && told.contains(&said);
        told.push(said.clone());
        let is_its = |it: &&GroupPicture| it.task == task.name && it.group == group.name;
        let shows = pictures.iter().find(is_its).map(|it| &it.shows);
        let (heat, tree) = match shows {
            Some(Picture::Tests { golden, film }) => (HeatMaps::beside(golden, film), None),
            Some(Picture::Tree {
                primitives,
                expected,
                got,
            }) => (None, TreeDrawings::beside(primitives, expected, got)),
            Some(Picture::Ray { .. }) | None => (None, None),
        };
        GroupRow {
            name: group.name.clone(),
            passes: group.outcome.passes(),
            worth: group.possible,
            judged: is_judged,
            said: if again { "the same".into() } else { said },
            worst: match again {
                true => Vec::new(),
                false => group.worst.iter().map(printable_fact).collect(),
            },
            heat,
            tree,
            ray: shows.and_then(RayDrawing::of),
        }
    };
    task.groups.iter().map(row).collect()
}

/// A fact that may hold what a student's code printed.
fn printable_fact(fact: &Fact) -> Fact {
    let lines: Vec<String> = fact.text.lines().map(printable).collect();
    Fact::new(&fact.label, lines.join("\n"))
}

/// The compiler's messages without their colours.
fn plain(text: &str) -> String {
    let text = anstream::adapter::strip_str(text.trim_end()).to_string();
    let lines: Vec<String> = text.lines().map(printable).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use pinhole_course::outcome::FilmOutcome;

    #[test]
    fn command_that_would_pass_is_not_offered() {
        let group = |outcome, fails_fresh| GroupOutcome {
            name: "inside".into(),
            about: String::new(),
            points: 0,
            possible: 1,
            outcome,
            worst: Vec::new(),
            fails_fresh,
        };
        let task = |groups| TaskOutcome {
            name: "sphere".into(),
            chapter: "Sphere".into(),
            points: 0,
            possible: 1,
            file: AnswerFile::Compiled,
            groups,
            diagnosis: Default::default(),
            measured: Vec::new(),
            warnings: Default::default(),
        };
        let command = |groups| TaskSection::of(0, &task(groups), &[], "pinhole check").command;
        let fresh = || group(FilmOutcome::Unanswered, true);
        let public = || group(FilmOutcome::Unanswered, false);
        assert_eq!(command(vec![fresh()]), None);
        let again = Some("pinhole check --task sphere".to_owned());
        assert_eq!(command(vec![fresh(), public()]), again);
        assert!(terminal::group_in_words(&fresh()).contains("Ask your instructor"));
    }

    #[test]
    fn the_compilers_colours_and_what_hides_its_neighbours_stay_out() {
        assert_eq!(
            plain("\u{1b}[31merror\u{1b}[0m: a\u{202e}b\n"),
            "error: a\\u{202e}b"
        );
    }
}
