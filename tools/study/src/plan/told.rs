//! A plan in words.

use std::fmt::Write;

use super::bounds::Bound;
use super::{Plan, Wish};

/// A share, with two digits.
pub fn percent(share: f64) -> String {
    match share * 100.0 {
        0.0 => "none".into(),
        100.0 => "all".into(),
        p if (10.0..=99.0).contains(&p) => format!("{p:.0} %"),
        p => format!("{p:.1} %"),
    }
}

/// So many of a kind.
pub fn count(parts: usize, kind: &str) -> String {
    match parts {
        1 => format!("1 {}", kind.trim_end_matches('s')),
        _ => format!("{parts} {kind}"),
    }
}

/// An angle in radians.
pub fn angle(radians: f64) -> String {
    format!("{radians:.0e} rad")
}

/// How far what is asked for can be off.
pub fn bounded(bound: Bound, wish: Wish) -> String {
    let t = wish
        .depth
        .then(|| format!("t by {:.0e} of itself", bound.t));
    let normal = wish
        .normal
        .then(|| format!("normals by {}", angle(bound.normal)));
    let told: Vec<String> = [t, normal].into_iter().flatten().collect();
    match told.is_empty() {
        true => "neither t nor normals are asked for".into(),
        false => told.join(", "),
    }
}

/// The whole plan, for a terminal.
pub fn told(plan: &Plan, scene: &str) -> String {
    let mut text = String::new();
    let wish = &plan.wish;
    let ids = match wish.exact_ids {
        true => "no wrong object at any pixel",
        false => "objects as rounding has them",
    };
    let _ = writeln!(
        text,
        "{scene}, {} pixels: t and normals to X = {:e}, {ids}\n",
        plan.pixels, wish.accuracy
    );
    let mut line = |name: &str, what: &str, why: &str| {
        let why = match (what.is_empty(), why.is_empty()) {
            (false, false) => format!(": {why}"),
            _ => why.to_owned(),
        };
        let _ = writeln!(text, "{name:<16}{what}{why}");
    };
    for kind in &plan.kinds {
        let name = count(kind.parts, kind.kind.name());
        let watched = if kind.watched { ", watched" } else { "" };
        let what = format!("{}{watched}", kind.numbers.name());
        line(&name, &what, &kind.reason);
    }
    line("search", plan.search, &plan.search_reason);
    line("outputs", &plan.outputs, "");
    line("exactly", &plan.exact_pixels, "");
    for (at, what) in plan.left_out.iter().enumerate() {
        line(if at == 0 { "left out" } else { "" }, what, "");
    }
    let c = &plan.confirmed;
    let mut judged = Vec::new();
    judged.extend(
        wish.depth
            .then(|| format!("worst t off by {:.0e}", c.worst_t)),
    );
    judged.extend(
        wish.normal
            .then(|| format!("worst normal by {}", angle(c.worst_normal))),
    );
    judged.push(match c.wrong_ids {
        0 => "no wrong object".into(),
        wrong => format!("{wrong} wrong objects (--ids exact leaves none)"),
    });
    let confirmed = format!(
        "on {} rays of the film, judged by exact arithmetic: {}",
        c.rays,
        judged.join(", ")
    );
    line("confirmed", &confirmed, "");
    if wish.accuracy < 6e-8 && (wish.depth || wish.normal) {
        line(
            "note",
            "film.exr holds f32: it keeps 7 digits of all this",
            "",
        );
    }
    text
}
