//! The rows of scenes: what is wrong with a film, and where to look.

use pinhole::judge::ChannelVerdict;

use super::words::{diagnosis, percent, scene_in_words};
use super::{QUIET, heading, indent, line, row};
use crate::escape::printable_word;
use pinhole_course::diagnosis::{Diagnosis, Explanation};
use pinhole_course::outcome::{Examination, FilmOutcome, SceneFilm, SceneOutcome};

/// All scenes, under their heading; `width` is that of the names' column.
pub fn rows(text: &mut String, examination: &Examination, width: usize) {
    let Examination { outcome, films } = examination;
    if !outcome.scenes.is_empty() {
        line(text, heading("scene", width));
    }
    let known = outcome.tasks.iter().any(|task| !task.passes());
    for (scene, film) in outcome.scenes.iter().zip(films) {
        scene_rows(text, scene, film, width, &outcome.submission, known);
    }
}

fn scene_rows(
    text: &mut String,
    scene: &SceneOutcome,
    film: &SceneFilm,
    width: usize,
    submission: &str,
    known_by_tasks: bool,
) {
    let points = (scene.points, scene.possible);
    row(text, &scene.name, width, points, scene_in_words(scene));
    if let FilmOutcome::Judged(comparison) = &scene.outcome
        && let Some((channel, mismatch)) = worst_pixel(&comparison.channels)
    {
        let rows = comparison
            .channels
            .iter()
            .filter(|channel| channel.failing > 0)
            .map(ToString::to_string);
        indent(text, &rows.collect::<Vec<_>>().join("\n"));
        scene_diagnosis(text, &scene.diagnosis, known_by_tasks);
        let (i, j) = (mismatch.i, mismatch.j);
        let (name, folder) = (printable_word(&film.argument), printable_word(submission));
        let command = format!("cargo pinhole explain {name} {i} {j} --submission {folder}");
        line(
            text,
            format!("    {QUIET}look at {}: {command}{QUIET:#}", channel.name),
        );
    }
}

/// Beliefs that a task's row spelled out already are only counted.
fn scene_diagnosis(text: &mut String, of_scene: &Diagnosis, known_by_tasks: bool) {
    if !known_by_tasks {
        indent(text, &diagnosis(of_scene));
        return;
    }
    for Explanation {
        mistake, explained, ..
    } in &of_scene.beliefs
    {
        let tasks = mistake.fails.join(", ");
        let share = percent(*explained);
        indent(
            text,
            &format!("what you believe in {tasks} explains {share} of it"),
        );
    }
}

/// The pixel to look at first, and the channel it is wrong in.
pub fn worst_pixel(channels: &[ChannelVerdict]) -> Option<(&ChannelVerdict, pinhole::Pixel)> {
    channels
        .iter()
        .find_map(|channel| Some((channel, channel.worst?.pixel)))
}
