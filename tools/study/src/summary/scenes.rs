use std::fmt::Write;

use crate::result::{SceneTally, Study};

/// Whole scenes, as a section of the page.
pub fn section(text: &mut String, study: &Study, plots: &[String]) {
    let _ = write!(
        text,
        "## Whole scenes\n\n\
         Every pixel's ray of the assignment's scenes, judged by exact arithmetic. *Wrong* are \
         pixels that show another object than the one truly seen; errors of t and of the normal \
         count where the object is right. *Boxes* tests only what lies in boxes that the ray \
         meets. *Exactly* says how many tests and comparisons a filter left to exact \
         arithmetic. What computes in `f32` rounds the scene and its rays first, and is judged \
         all the same by what the ray in `f64` truly meets: that is what a user of `f32` gets. \
         Mitsuba computes in `f32`, by rays of its own.\n\n\
         **Bold** ways are on the front: no other way is as good in time, wrong objects, t and \
         normal, and better in one of them. All the rest is not worth choosing in that scene.\n\n"
    );
    if plots.iter().any(|plot| plot == "front.svg") {
        text.push_str("![Time against the largest error, scene by scene](front.svg)\n\n");
    }
    let _ = write!(
        text,
        "| scene | numbers | kernels | search | parts | rays | wrong | median t | worst t | worst normal | ns/ray | tests/ray | exactly |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for tally in &study.scenes {
        let SceneTally {
            scene,
            model,
            parts,
            rays,
            wrong_ids,
            ..
        } = tally;
        let error = |error: Option<f64>| error.map_or("–".into(), |error| format!("{error:.0e}"));
        let cost = |cost: Option<f64>| cost.map_or("–".into(), |cost| format!("{cost:.1}"));
        let search = tally.search.as_deref().unwrap_or("–");
        let kernels = tally.kernels.as_deref().unwrap_or("–");
        let model = match tally.on_front {
            true => format!("**{model}**"),
            false => model.clone(),
        };
        let _ = writeln!(
            text,
            "| {scene} | {model} | {kernels} | {search} | {parts} | {rays} | {wrong_ids} | {} | {} | {} rad | {} | {} | {} |",
            error(tally.median_t),
            error(tally.worst_t),
            error(tally.worst_normal),
            cost(tally.nanoseconds),
            cost(tally.tests),
            tally.fallbacks + tally.close_calls
        );
    }
    text.push('\n');
}
