//! What may be shown of questions that students are not to see.
//!
//! A withheld scene would be an oracle if its results said too much: whoever may hand in
//! often could read it out, by pictures, by panic texts, by exit codes, by time. So a
//! student's own words never travel from there, whatever is revealed.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use pinhole_course::examination::{Examination, Outcome};
use pinhole_report::html::{Report, SceneSection};
use pinhole_report::terminal;

/// How much of withheld questions results and reports show.
#[derive(
    Clone, Copy, Debug, Default, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize, ValueEnum,
)]
#[serde(rename_all = "lowercase")]
pub enum Reveal {
    /// Points alone
    Points,
    /// And what went wrong, in a line
    #[default]
    Message,
    /// And the pictures
    Picture,
    /// And every pixel, and the worst question
    Full,
}

/// Which parts of an examination are withheld.
#[derive(Clone, Debug, PartialEq)]
pub struct Withheld {
    /// These scenes, and, if there are any, the questions made of scenes' pixels.
    pub scenes: Vec<String>,
    /// Task and group of the questions made of scenes' pixels.
    pub scene_groups: Vec<(String, String)>,
    /// The questions to single tasks.
    pub probes: bool,
    pub reveal: Reveal,
}

impl Withheld {
    /// What may be shown of a group; `None` if all.
    pub fn group(&self, task: &str, group: &str) -> Option<Reveal> {
        let mut scene_groups = self.scene_groups.iter();
        let withheld = match scene_groups.any(|own| (&*own.0, &*own.1) == (task, group)) {
            true => !self.scenes.is_empty(),
            false => self.probes,
        };
        withheld.then_some(self.reveal)
    }

    /// What may be shown of a scene; `None` if all.
    pub fn scene(&self, name: &str) -> Option<Reveal> {
        let withheld = self.scenes.iter().any(|scene| scene == name);
        withheld.then_some(self.reveal)
    }

    /// Whether anything is.
    pub fn any(&self) -> bool {
        !self.scenes.is_empty() || self.probes
    }
}

/// An outcome in one line, without a word of the student's where that is withheld.
pub fn said(outcome: &Outcome, what: &str, reveal: Option<Reveal>) -> String {
    match (reveal, outcome) {
        (None, _) => terminal::outcome_of(outcome, what),
        (Some(Reveal::Points), _) if outcome.passes() => "passes".into(),
        (Some(Reveal::Points), _) => "does not pass; what was asked is withheld".into(),
        (Some(_), Outcome::Panicked(_)) => "your code panicked; where is withheld".into(),
        (Some(_), Outcome::Died(_)) => "your program did not finish; how is withheld".into(),
        (Some(_), Outcome::Garbled(_) | Outcome::Refused(_)) => {
            "your program's answers could not be read".into()
        }
        (Some(_), Outcome::TimedOut { .. }) => "gave no answer in time".into(),
        (Some(_), Outcome::OutOfMemory { .. }) => "asked for too much memory".into(),
        (Some(_), _) => terminal::outcome_of(outcome, what),
    }
}

/// The worst question, if it may be shown.
pub fn worst(worst: Option<&String>, reveal: Option<Reveal>) -> Option<String> {
    worst
        .filter(|_| reveal.is_none_or(|reveal| reveal == Reveal::Full))
        .cloned()
}

/// Takes from a report what may not be shown. `fresh` names the groups that fail on fresh
/// questions alone: task and group.
pub fn veil(
    report: &mut Report,
    examination: &Examination,
    withheld: &Withheld,
    fresh: &[(String, String)],
) {
    for (section, task) in report.tasks.iter_mut().zip(&examination.tasks) {
        for (row, group) in section.groups.iter_mut().zip(&task.groups) {
            let is_fresh = fresh.contains(&(task.name.clone(), group.name.clone()));
            let reveal = match is_fresh {
                true => Some(withheld.reveal),
                false => withheld.group(&task.name, &group.name),
            };
            if reveal.is_none() {
                continue;
            }
            row.said = said(&group.outcome, "questions", reveal);
            if is_fresh {
                row.said = format!("the public questions pass, fresh ones do not: {}", row.said);
            }
            if worst(group.worst.as_ref(), reveal).is_none() {
                row.worst.clear();
            }
        }
        if withheld.probes && withheld.reveal == Reveal::Points {
            section.beliefs = None;
        }
    }
    for (section, scene) in report.scenes.iter_mut().zip(&examination.scenes) {
        if let Some(reveal) = withheld.scene(&scene.name) {
            section.said = said(&scene.outcome, "pixels", Some(reveal));
            veil_scene(section, reveal);
        }
    }
    if withheld.any() || !fresh.is_empty() {
        report.printed.clear();
        report.more_printed = 0;
    }
}

fn veil_scene(section: &mut SceneSection, reveal: Reveal) {
    // The instructor's own file is named there.
    section.explain = None;
    section.command = "this scene is withheld".into();
    if reveal < Reveal::Full {
        section.viewer = None;
        section.channels.clear();
    }
    if reveal < Reveal::Picture {
        section.expected = None;
        section.yours = None;
        section.difference = None;
        section.cut = None;
        section.causes.clear();
    }
    if reveal < Reveal::Message {
        section.beliefs = None;
    }
}

#[cfg(test)]
mod tests {
    use pinhole::job::Panic;

    use super::*;

    #[test]
    fn no_word_of_a_students_comes_from_a_withheld_question() {
        let words = "0.5 0.25";
        let spoken = [
            Outcome::Panicked(Panic {
                message: words.into(),
                file: words.into(),
                line: 7,
                index: 0,
            }),
            Outcome::Died(words.into()),
            Outcome::Garbled(words.into()),
        ];
        for outcome in spoken {
            for reveal in [
                Reveal::Points,
                Reveal::Message,
                Reveal::Picture,
                Reveal::Full,
            ] {
                let said = said(&outcome, "pixels", Some(reveal));
                assert!(!said.contains(words) && !said.contains('7'), "{said}");
            }
            assert!(said(&outcome, "pixels", None).contains(words));
        }
    }

    #[test]
    fn one_withheld_scene_withholds_itself_and_what_is_asked_of_pixels() {
        let withheld = |scenes: &[&str]| Withheld {
            scenes: scenes.iter().map(|name| (*name).to_owned()).collect(),
            scene_groups: vec![("viewing_ray".into(), "scenes".into())],
            probes: false,
            reveal: Reveal::Message,
        };
        let one = withheld(&["exam"]);
        assert_eq!(one.scene("exam"), Some(Reveal::Message));
        assert_eq!(one.scene("bunny"), None);
        assert_eq!(one.group("viewing_ray", "scenes"), Some(Reveal::Message));
        assert_eq!(one.group("viewing_ray", "corners"), None);
        assert!(one.any());
        let none = withheld(&[]);
        assert_eq!(none.group("viewing_ray", "scenes"), None);
        assert!(!none.any());
    }
}
