//! Where a student's code stands among the kernels.

use std::fmt::Write;

use super::ends;
use crate::result::{Breaking, Study};
use crate::theirs;

/// Whether there is any.
pub fn is_there(study: &Study) -> bool {
    study.breaking.iter().any(is_theirs) || !study.problems.is_empty()
}

fn is_theirs(breaking: &Breaking) -> bool {
    breaking.kernel == theirs::NAME
}

/// One family, and who holds out longer in it.
struct Place<'a> {
    theirs: &'a Breaking,
    /// Kernels with fewer wrong decisions, or as many and smaller errors.
    better: Vec<&'a str>,
    kernels: usize,
}

fn places(study: &Study) -> Vec<Place<'_>> {
    let all = study.breaking.iter().filter(|breaking| is_theirs(breaking));
    all.map(|theirs| place(study, theirs)).collect()
}

fn place<'a>(study: &'a Study, theirs: &'a Breaking) -> Place<'a> {
    let key = |b: &'a Breaking| (&b.shape, &b.family, &b.numbers);
    let others = study.breaking.iter();
    let others = others.filter(|other| key(other) == key(theirs) && !is_theirs(other));
    let better = others.clone().filter(|other| is_better(other, theirs));
    Place {
        theirs,
        better: better.map(|other| other.kernel.as_str()).collect(),
        kernels: others.count(),
    }
}

/// Twice as much counts as more: smaller differences are a matter of chance.
fn is_better(one: &Breaking, other: &Breaking) -> bool {
    let share = |b: &Breaking| b.wrong as f64 / b.asked.max(1) as f64;
    let error = |b: &Breaking| b.worst_median_ulp.unwrap_or(0.0);
    if one.wrong == 0 && other.wrong == 0 {
        return 2.0 * error(one) < error(other);
    }
    2.0 * share(one) < share(other)
}

/// Lines for a terminal: each family, and who is better in it.
pub fn terminal(study: &Study) -> String {
    let mut text = String::from("yours among the kernels; nothing of this is graded\n");
    for place in places(study) {
        let theirs = place.theirs;
        let family = format!("{}, {}", theirs.shape, theirs.family);
        let wrong = match theirs.wrong {
            0 => "no decision wrong".into(),
            wrong => format!(
                "{:.2} % wrong",
                100.0 * wrong as f64 / theirs.asked.max(1) as f64
            ),
        };
        let breaks = match ends(theirs) {
            never if never == "never" => "never breaks".into(),
            ends => format!("breaks at {ends}"),
        };
        let standing = standing(&place);
        let _ = writeln!(text, "  {family:22} {breaks:24} {wrong:18} {standing}");
    }
    for mesh in study
        .meshes
        .iter()
        .filter(|mesh| mesh.kernel == theirs::NAME)
    {
        let _ = writeln!(
            text,
            "  of {} rays at a closed mesh's {}: {} meet nothing, {} meet it twice",
            mesh.rays, mesh.aimed_at, mesh.leaks, mesh.double_hits
        );
    }
    for scene in study
        .scenes
        .iter()
        .filter(|scene| scene.model == theirs::NAME)
    {
        let _ = writeln!(
            text,
            "  {}: {} of {} pixels show another object than is truly seen",
            scene.scene, scene.wrong_ids, scene.rays
        );
    }
    for problem in &study.problems {
        let _ = writeln!(text, "  {problem}");
    }
    text.push_str("x is what each family's plot says; summary.md explains them");
    text
}

fn standing(place: &Place) -> String {
    match place.better.as_slice() {
        [] => "none is better".into(),
        better => format!("{} of {} are better", better.len(), place.kernels),
    }
}

/// The same as a section of the page.
pub fn section(text: &mut String, study: &Study) {
    let _ = write!(
        text,
        "## Where yours stands\n\n\
         Your code was asked the same questions as the kernels, and nothing of this is graded. \
         In the plots below its line is the thick grey one. A kernel is *better* if it \
         decides wrongly at most half as often; where neither is ever wrong, if its largest \
         median error is at most half of yours.\n\n\
         | shape | family | yours breaks at x | wrong | better |\n\
         | --- | --- | --- | --- | --- |\n"
    );
    for place in places(study) {
        let theirs = place.theirs;
        let better = match place.better.is_empty() {
            true => "none".into(),
            false => place.better.join(", "),
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} of {} | {better} |",
            theirs.shape,
            theirs.family,
            ends(theirs),
            theirs.wrong,
            theirs.asked
        );
    }
    for problem in &study.problems {
        let _ = write!(text, "\n- {problem}");
    }
    text.push_str("\n\n");
}
