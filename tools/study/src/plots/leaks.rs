//! Plots leaks and double hits on closed meshes.

use super::paper::{Anchor, Paper, colour, names};
use crate::result::MeshTally;

const LEFT: f64 = 130.0;
/// Width of a bar that stands for all rays.
const WHOLE: f64 = 230.0;

/// Draws two bars in `f64` and two in `f32` for every kernel and aim.
pub fn svg(meshes: &[MeshTally]) -> String {
    let mut paper = Paper::default();
    let (leak, double) = (colour(0), colour(1));
    for (y, words, colour) in [
        (14.0, "leaks: the ray meets nothing", leak),
        (36.0, "double hits: it meets two triangles or more", double),
    ] {
        paper.bar((14.0, y), 12.0, 12.0, colour);
        paper.word((34.0, y), Anchor::Start, words);
    }
    let mut y = 68.0;
    for name in names(meshes.iter().map(|mesh| mesh.kernel)) {
        paper.word((14.0, y), Anchor::Start, name);
        y += 24.0;
        let of_it = meshes.iter().filter(|mesh| mesh.kernel == name);
        for mesh in of_it.filter(|mesh| mesh.numbers != "f64 on f32") {
            let aim = if mesh.aimed_at == "edge" {
                "edges"
            } else {
                "corners"
            };
            let label = format!("{aim}, {}", mesh.numbers);
            paper.word((LEFT - 10.0, y), Anchor::End, &label);
            let share = |count: u64| count as f64 / mesh.rays.max(1) as f64;
            let (leaks, doubles) = (share(mesh.leaks), share(mesh.double_hits));
            let longest = leaks.max(doubles) * WHOLE;
            paper.bar((LEFT, y - 4.0), (leaks * WHOLE).ceil(), 7.0, leak);
            paper.bar((LEFT, y + 4.0), (doubles * WHOLE).ceil(), 7.0, double);
            let figure = |count: u64| match count {
                0 => "none".into(),
                _ => format!("{:.1} %", 100.0 * share(count)),
            };
            let figures = format!("{} / {}", figure(mesh.leaks), figure(mesh.double_hits));
            paper.word((LEFT + longest + 8.0, y), Anchor::Start, &figures);
            y += 22.0;
        }
        y += 10.0;
    }
    paper.svg(y)
}
