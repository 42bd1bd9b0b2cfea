//! The rows of scenes: what is wrong with a film, and where to look.

use pinhole::judge::{ChannelVerdict, Verdict};

use super::words::{diagnosis, percent, scene_in_words};
use super::{QUIET, heading, indent, line, row};
use pinhole_course::diagnosis::{Diagnosis, Explanation};
use pinhole_course::examination::{Examination, Outcome, SceneResult};
use pinhole_course::shell::in_shell;

/// All scenes, under their heading; `width` is that of the names' column.
pub fn rows(text: &mut String, examination: &Examination, width: usize) {
    if !examination.scenes.is_empty() {
        line(text, heading("scene", width));
    }
    let known = examination.tasks.iter().any(|task| !task.passes());
    for scene in &examination.scenes {
        scene_rows(text, scene, width, &examination.submission, known);
    }
}

fn scene_rows(
    text: &mut String,
    scene: &SceneResult,
    width: usize,
    submission: &str,
    known_by_tasks: bool,
) {
    let passes = scene.outcome.passes();
    let earned = if passes { scene.worth } else { 0 };
    row(
        text,
        &scene.name,
        width,
        (earned, scene.worth),
        scene_in_words(scene),
    );
    if let Outcome::Judged(verdict) = &scene.outcome
        && let Some((channel, mismatch)) = worst_pixel(verdict)
    {
        let rows = verdict
            .channels
            .iter()
            .filter(|channel| channel.failing > 0)
            .map(ToString::to_string);
        indent(text, &rows.collect::<Vec<_>>().join("\n"));
        scene_diagnosis(text, &scene.diagnosis, known_by_tasks);
        let (i, j) = (mismatch.i, mismatch.j);
        let (name, folder) = (in_shell(&scene.argument), in_shell(submission));
        let command =
            format!("cargo run --release -- explain {name} {i} {j} --submission {folder}");
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
pub fn worst_pixel(verdict: &Verdict) -> Option<(&ChannelVerdict, pinhole::Pixel)> {
    verdict
        .channels
        .iter()
        .find_map(|channel| Some((channel, channel.worst?.pixel)))
}
