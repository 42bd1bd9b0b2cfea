//! The rows of scenes: what is wrong with a film, and which pixel to look at.

use std::collections::BTreeSet;
use std::path::Path;

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
    for task in &outcome.tasks {
        told.extend(task.diagnosis.beliefs.iter().map(|held| held.slug.clone()));
    }
    for (scene, film) in outcome.scenes.iter().zip(films) {
        scene_rows(text, scene, film, width, &outcome.submission, &mut told);
        if !scene.outcome.passes() {
            for remark in remarks(examination, film) {
                line(text, format!("    {remark}"));
            }
        }
    }
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
    width: usize,
    submission: &str,
    told: &mut BTreeSet<String>,
) {
    let points = (scene.points, scene.possible);
    row(text, &scene.name, width, points, scene_in_words(scene));
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
        let (i, j) = (mismatch.i, mismatch.j);
        let [before, after] = explain(&film.argument, submission);
        let command = format!("{before} {i} {j}{after}");
        line(
            text,
            format!(
                "    {QUIET}worst pixel in {}: {command}{QUIET:#}",
                channel.name
            ),
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
