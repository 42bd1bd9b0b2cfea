//! The rows of scenes: what is wrong with a film, and which pixel to look at.

use std::collections::BTreeSet;
use std::path::Path;

use pinhole::Pixel;
use pinhole::judge::ChannelVerdict;

use super::words::{diagnosis, scene_in_words, share};
use super::{QUIET, heading, indent, line, row};
use crate::escape::printable_word;
use pinhole_course::diagnosis::{Diagnosis, Explanation};
use pinhole_course::outcome::{Examination, FilmOutcome, SceneFilm, SceneOutcome};
use pinhole_course::shell::PINHOLE;
use pinhole_course::submission::Submission;

/// All scenes under their heading. `width` is that of the column of names.
pub fn rows(text: &mut String, examination: &Examination, width: usize) {
    let Examination { outcome, films, .. } = examination;
    if !outcome.scenes.is_empty() {
        line(text, heading("scene", width));
    }
    let mut told: BTreeSet<String> = BTreeSet::new();
    let mut failures: Vec<String> = Vec::new();
    for task in &outcome.tasks {
        told.extend(task.diagnosis.beliefs.iter().map(|held| held.slug.clone()));
    }
    for (scene, film) in outcome.scenes.iter().zip(films) {
        let said = failure_in_words(scene, &mut failures);
        let points = (scene.points, scene.possible);
        row(text, &scene.name, width, points, said);
        scene_rows(text, scene, film, &outcome.submission, &mut told);
        if !scene.outcome.passes() {
            let note = note(film).filter(|note| told.insert(note.clone()));
            for remark in note.into_iter().chain(remarks(examination, film)) {
                line(text, format!("    {remark}"));
            }
        }
    }
}

/// A hint about the pixel without a usable answer.
pub fn note(film: &SceneFilm) -> Option<String> {
    let note = film.unanswered?.note?;
    Some(format!("note: {note}"))
}

/// What is remarkable in the answers that a failing scene needs, although they pass their tasks.
pub fn remarks(examination: &Examination, film: &SceneFilm) -> Vec<String> {
    let suspects = examination.suspects(film).into_iter();
    suspects
        .map(|(task, finding)| format!("The task `{task}` passes, but: {}", finding.says))
        .collect()
}

fn scene_rows(
    text: &mut String,
    scene: &SceneOutcome,
    film: &SceneFilm,
    submission: &str,
    told: &mut BTreeSet<String>,
) {
    let look_at = |why: &str, Pixel { i, j }: Pixel| {
        let [before, after] = explain(&film.argument, submission);
        format!("    {QUIET}{why}: {before} {i} {j}{after}{QUIET:#}")
    };
    // Leave out the channels if a belief from a row above explains all that is wrong here.
    let mut beliefs = scene.diagnosis.beliefs.iter();
    let is_explained = beliefs.any(|held| held.explained >= 1.0 && told.contains(&held.slug));
    if is_explained {
        scene_diagnosis(text, &scene.diagnosis, told);
    } else if let FilmOutcome::Judged(comparison) = &scene.outcome
        && let Some((channel, mismatch)) = worst_pixel(&comparison.channels)
    {
        let rows = comparison
            .channels
            .iter()
            .filter(|channel| channel.failing > 0)
            .map(ToString::to_string);
        indent(text, &rows.collect::<Vec<_>>().join("\n"));
        scene_diagnosis(text, &scene.diagnosis, told);
        let worst = format!("worst pixel in {}", channel.name);
        line(text, look_at(&worst, mismatch));
    } else if let Some(unanswered) = film.unanswered {
        line(
            text,
            look_at("no usable answer at this pixel", unanswered.pixel),
        );
    }
}

/// The command that explains a pixel of a scene, in two parts: what comes before the pixel's
/// column, and what comes after its row.
pub fn explain(scene: &str, submission: &str) -> [String; 2] {
    let option = match Submission::is_default(Path::new(submission)) {
        true => String::new(),
        false => format!(" --submission {}", printable_word(submission)),
    };
    [
        format!("{PINHOLE} explain {}", printable_word(scene)),
        option,
    ]
}

/// A scene in one line. A failure that a row above has spelled out is "the same".
fn failure_in_words(scene: &SceneOutcome, failures: &mut Vec<String>) -> String {
    let said = scene_in_words(scene);
    if matches!(
        scene.outcome,
        FilmOutcome::Judged(_) | FilmOutcome::Blocked { .. }
    ) {
        return said;
    }
    match failures.contains(&said) {
        true => "the same".into(),
        false => {
            failures.push(said.clone());
            said
        }
    }
}

/// If a row above has already spelled out a belief, this gives only its share.
fn scene_diagnosis(text: &mut String, of_scene: &Diagnosis, told: &mut BTreeSet<String>) {
    let beliefs = &of_scene.beliefs;
    if !beliefs.iter().all(|held| told.contains(&held.slug)) {
        told.extend(beliefs.iter().map(|held| held.slug.clone()));
        indent(text, &diagnosis(of_scene));
        return;
    }
    let explained = |held: &Explanation| {
        let (tasks, share) = (
            held.mistake.fails.join(", "),
            share(held.explained, of_scene),
        );
        format!("the belief above about {tasks} explains {share} is wrong here")
    };
    let mut lines: Vec<String> = beliefs.iter().map(explained).collect();
    // Two beliefs about one task can explain the same share.
    lines.dedup();
    indent(text, &lines.join("\n"));
}

/// The pixel to look at first, and the channel it is wrong in.
pub fn worst_pixel(channels: &[ChannelVerdict]) -> Option<(&ChannelVerdict, pinhole::Pixel)> {
    channels
        .iter()
        .find_map(|channel| Some((channel, channel.worst?.pixel)))
}
