//! Describes a plan in words.

use std::fmt::Write;

use super::{AccuracyTarget, KindPlan, Plan};
use crate::cast::search::Search;

/// A number of parts, as a phrase.
fn count(parts: usize, kind: &str) -> String {
    match parts {
        1 => format!("1 {kind}"),
        _ => format!("{parts} {kind}s"),
    }
}

/// Which of t and normals are requested, in words.
fn outputs(wish: AccuracyTarget) -> &'static str {
    match (wish.depth, wish.normal) {
        (true, true) => "t and normals",
        (true, false) => "t (normals are not asked for, and are 0 in the film)",
        (false, true) => "normals (t is not asked for, and is 0 in the film)",
        (false, false) => "neither t nor normals (both are 0 in the film)",
    }
}

/// How a kind of shape is cast.
fn how(kind: &KindPlan, wish: AccuracyTarget) -> String {
    let normals = match kind.worst_normal {
        Some(worst) => format!("normals to {worst:.0e} rad"),
        None => "no common bound on normals".into(),
    };
    let proven = match (wish.depth, wish.normal) {
        (true, true) => format!("t to {:.0e}, {normals}", kind.worst_t),
        (true, false) => format!("t to {:.0e}", kind.worst_t),
        (false, true) => normals,
        (false, false) => return "only the object is computed".into(),
    };
    match kind.watched {
        false => format!("f64; proven for every ray: {proven}"),
        true => {
            format!("f64 where a filter proves X, and more digits elsewhere; f64 alone: {proven}")
        }
    }
}

/// The text of a plan, for a terminal.
pub fn description(plan: &Plan, scene: &str) -> String {
    let mut text = String::new();
    let (wish, prices) = (plan.wish, plan.prices);
    let _ = writeln!(
        text,
        "{scene}, {} pixels: the true object at each, {} to X = {:e}\n",
        plan.pixels,
        outputs(wish),
        wish.accuracy
    );
    let mut line = |name: &str, what: &str| {
        let _ = writeln!(text, "{name:<16}{what}");
    };
    line(
        "objects",
        "decided exactly: by a filter in f64, or else with more digits",
    );
    for kind in &plan.kinds {
        line(&count(kind.parts, kind.kind), &how(kind, wish));
    }
    let than = if plan.search == Search::Boxes.name() {
        "more than"
    } else {
        "not more than"
    };
    line(
        "search",
        &format!(
            "{}, because testing every part takes {} instructions per ray ({} per sphere, {} per \
             triangle), {than} the {} that boxes take",
            plan.search, plan.price_of_all, prices.sphere, prices.triangle, prices.boxes
        ),
    );
    line(
        "proven",
        "all of the above, for each ray of the camera as rounded to f64",
    );
    line("sampled", "nothing");
    if wish.depth || wish.normal {
        line(
            "note",
            "film.exr stores f32 numbers: 7 digits of all this, and t from 1e-38 to 3e38",
        );
    }
    text
}
