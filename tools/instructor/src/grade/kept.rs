//! What is kept of an examination, without what is withheld.

use super::alike;
use super::kind::Kind;
use super::record::{BeliefRecord, FlagRecord, GroupRecord, SceneRecord, TaskRecord};
use super::withheld::{Reveal, Withheld, said, worst};
use pinhole_course::compile::Replaced;
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};
use pinhole_course::examination::{Examination, SceneResult, TaskResult};
use pinhole_course::submission::Submission;
use pinhole_course::submission::flags::{Flag, flags};

/// What is kept of the tasks; `failed` are the groups, by task and group, that fail only
/// questions nobody had seen.
pub fn tasks(
    examination: &Examination,
    submission: &Submission,
    failed: &[(String, String)],
    withheld: &Withheld,
) -> Vec<TaskRecord> {
    let record = |task: &TaskResult| {
        let groups = task.groups.iter().map(|group| {
            let fails_fresh = failed.contains(&(task.name.clone(), group.name.clone()));
            let reveal = match fails_fresh {
                true => Some(withheld.reveal),
                false => withheld.group(&task.name, &group.name),
            };
            GroupRecord {
                name: group.name.clone(),
                about: group.about.clone(),
                points: group.outcome.earns(group.worth),
                possible: group.worth,
                outcome: Kind::of(&group.outcome),
                said: said(&group.outcome, "questions", reveal),
                worst: worst(group.worst.as_ref(), reveal),
                fails_fresh,
            }
        });
        let (points, possible) = task.points();
        let text = submission
            .answer(&task.name)
            .and_then(|answer| answer.text.as_ref().ok());
        let hidden = withheld.probes && withheld.reveal == Reveal::Points;
        TaskRecord {
            name: task.name.clone(),
            points,
            possible,
            outcome: Kind::of_task(task),
            said: pinhole_report::terminal::task_in_words(task),
            compiler: match &task.replaced {
                Some(Replaced::DoesNotCompile(text)) => {
                    Some(anstream::adapter::strip_str(text).to_string())
                }
                _ => None,
            },
            groups: groups.collect(),
            diagnosis: if hidden {
                Vec::new()
            } else {
                beliefs(&task.diagnosis)
            },
            tokens: text.and_then(|text| alike::tokens(text)),
        }
    };
    examination.tasks.iter().map(record).collect()
}

/// What is kept of scenes, of which `reveal` says by name what may be shown.
pub fn scenes(
    results: &[SceneResult],
    reveal: impl Fn(&str) -> Option<Reveal>,
) -> Vec<SceneRecord> {
    let record = |scene: &SceneResult| {
        let reveal = reveal(&scene.name);
        SceneRecord {
            name: scene.name.clone(),
            points: scene.outcome.earns(scene.worth),
            possible: scene.worth,
            outcome: Kind::of(&scene.outcome),
            said: said(&scene.outcome, "pixels", reveal),
            diagnosis: match reveal {
                Some(Reveal::Points) => Vec::new(),
                _ => beliefs(&scene.diagnosis),
            },
        }
    };
    results.iter().map(record).collect()
}

fn beliefs(diagnosis: &Diagnosis) -> Vec<BeliefRecord> {
    let record = |held: &Explanation| BeliefRecord {
        mistake: held.slug.clone(),
        belief: held.mistake.belief.clone(),
        explained: held.explained,
        one_of: diagnosis.reading == Reading::OneOf,
        look: held.mistake.hint.look.clone(),
    };
    diagnosis.beliefs.iter().map(record).collect()
}

/// What an instructor may want to read.
pub fn flagged(submission: &Submission) -> Vec<FlagRecord> {
    let flags = flags(submission).into_iter();
    flags
        .map(|Flag { task, line, what }| FlagRecord { task, line, what })
        .collect()
}
