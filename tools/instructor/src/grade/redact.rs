//! Removes what students must not see from an outcome and its report.
//!
//! From detailed results, a student who may hand in often could reconstruct a withheld scene: from
//! pictures, panic messages, exit codes or times. So no text from the student's code is shown if
//! it could be about withheld questions, however much `--reveal` shows.

#[cfg(test)]
mod tests;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use pinhole_course::diagnosis::Diagnosis;
use pinhole_course::outcome::{FilmOutcome, GroupOutcome, Outcome, SceneOutcome, Status};
use pinhole_report::html::{Report, SceneSection};

/// How much results and reports show about withheld questions.
#[derive(
    Clone, Copy, Debug, Default, Deserialize, Eq, Ord, PartialEq, PartialOrd, Serialize, ValueEnum,
)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Reveal {
    /// Only whether each group of questions and each scene passes
    #[default]
    Points,
    /// In addition, how each ended: wrong, panicked, timed out
    Message,
    /// In addition, how much is wrong, and the pictures
    Picture,
    /// Everything, including each wrong pixel and each group's worst question
    Full,
}

/// Which parts of an outcome are withheld.
#[derive(Clone, Debug, PartialEq)]
pub struct Withheld {
    /// The withheld scenes. If there are any, the questions about pixels of scenes are withheld
    /// too.
    pub scenes: Vec<String>,
    /// Task and group of the questions about pixels of scenes.
    pub scene_groups: Vec<(String, String)>,
    /// Whether the questions about single tasks are withheld.
    pub probes: bool,
    pub reveal: Reveal,
}

impl Withheld {
    /// Whether anything is withheld.
    pub fn any(&self) -> bool {
        !self.scenes.is_empty() || self.probes
    }

    fn holds_group(&self, task: &str, group: &GroupOutcome) -> bool {
        // Examples are about public questions, and no code has seen them.
        if group.is_of_examples() {
            return false;
        }
        let mut scene_groups = self.scene_groups.iter();
        let is_withheld = match scene_groups.any(|own| (&*own.0, &*own.1) == (task, &group.name)) {
            true => !self.scenes.is_empty(),
            false => self.probes,
        };
        is_withheld || group.fails_fresh
    }

    fn holds_scene(&self, name: &str) -> bool {
        self.scenes.iter().any(|scene| scene == name)
    }

    /// Removes from an outcome what may not be shown.
    pub fn redact(&self, outcome: &mut Outcome) {
        for task in &mut outcome.tasks {
            for group in &mut task.groups {
                if !self.holds_group(&task.name, group) {
                    continue;
                }
                group.outcome = redacted(&group.outcome, self.reveal);
                if self.reveal < Reveal::Full {
                    group.worst.clear();
                }
            }
            if self.probes && self.reveal < Reveal::Picture {
                task.diagnosis = Diagnosis::default();
            }
            // The measured numbers could be a message from the student's code.
            if self.probes && self.reveal < Reveal::Full {
                task.measured.clear();
            }
        }
        for scene in &mut outcome.scenes {
            if self.holds_scene(&scene.name) {
                redact_scene(scene, self.reveal);
            }
        }
        if self.any() {
            outcome.printed.clear();
        }
    }

    /// Takes the report of a redacted outcome and removes what only a report shows.
    pub fn redact_report(&self, report: &mut Report, outcome: &Outcome) {
        for (section, task) in report.tasks.iter_mut().zip(&outcome.tasks) {
            for (row, group) in section.groups.iter_mut().zip(&task.groups) {
                // They show one of the questions.
                if self.holds_group(&task.name, group) && self.reveal < Reveal::Full {
                    (row.heat, row.tree, row.ray) = (None, None, None);
                }
            }
        }
        for (section, scene) in report.scenes.iter_mut().zip(&outcome.scenes) {
            if self.holds_scene(&scene.name) {
                redact_pictures(section, self.reveal);
            }
        }
        let mut groups = outcome.tasks.iter().flat_map(|task| &task.groups);
        if self.any() || groups.any(|group| group.fails_fresh) {
            report.printed.clear();
            report.more_printed = 0;
            report.on_printed = None;
        }
    }
}

/// Removes from a scene's outcome what may not be shown of it.
pub fn redact_scene(scene: &mut SceneOutcome, reveal: Reveal) {
    scene.outcome = redacted(&scene.outcome, reveal);
    scene.seconds = None;
    // A diagnosis says how much of what is wrong it explains.
    if reveal < Reveal::Picture {
        scene.diagnosis = Diagnosis::default();
    }
}

/// The outcome of a film, without any text from the student.
fn redacted(outcome: &FilmOutcome, reveal: Reveal) -> FilmOutcome {
    match outcome {
        // Code can choose how many questions it answers wrongly, and send a message with that
        // number.
        FilmOutcome::Judged(comparison) if reveal > Reveal::Message => {
            let mut comparison = comparison.clone();
            if reveal < Reveal::Full {
                comparison.channels.clear();
            }
            FilmOutcome::Judged(comparison)
        }
        FilmOutcome::Unanswered | FilmOutcome::Blocked { .. } if reveal > Reveal::Points => {
            outcome.clone()
        }
        _ => FilmOutcome::Withheld {
            passes: outcome.passes(),
            ended: match reveal {
                Reveal::Points => Status::Graded,
                _ => outcome.status(),
            },
            points_only: reveal == Reveal::Points,
        },
    }
}

fn redact_pictures(section: &mut SceneSection, reveal: Reveal) {
    // The command would name the instructor's own file.
    section.explain = None;
    section.command = "this scene is withheld".into();
    if reveal < Reveal::Full {
        section.viewer = None;
        section.channels.clear();
        section.remarks.clear();
    }
    if reveal < Reveal::Picture {
        section.expected = None;
        section.yours = None;
        section.difference = None;
        section.heat = None;
        section.cut = None;
        section.causes.clear();
    }
}
