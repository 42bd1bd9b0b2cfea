//! What exact casting promises of whole scenes.

use super::counted;
use crate::result::{SceneTally, Target};

/// Over plain `f64` in the same search: the median scene, and the worst.
const COST: [(&str, f64); 2] = [("median", 1.05), ("worst", 1.11)];

pub fn targets(scenes: &[SceneTally]) -> Vec<Target> {
    let exact = || scenes.iter().filter(|tally| tally.model == "exact");
    let rays: u64 = exact().map(|tally| tally.rays).sum();
    if rays == 0 {
        return Vec::new();
    }
    let wrong = exact().map(|tally| tally.wrong_ids).sum();
    let mut targets = vec![Target {
        about: "exact casting: wrong objects in all scenes".into(),
        expected: "0".into(),
        measured: counted(wrong, rays),
        met: wrong == 0,
        is_time: false,
    }];
    let in_boxes = |model: &'static str| {
        let is_it = move |t: &&SceneTally| {
            let is_plain = matches!(t.kernels.as_deref(), Some("usual" | "adaptive"));
            t.model == model && is_plain && t.search.as_deref() == Some("boxes")
        };
        scenes
            .iter()
            .filter(is_it)
            .filter_map(|tally| tally.nanoseconds)
    };
    let mut ratios: Vec<f64> = in_boxes("exact")
        .zip(in_boxes("f64"))
        .map(|(e, p)| e / p)
        .collect();
    ratios.sort_by(f64::total_cmp);
    let measured = [ratios.get(ratios.len() / 2), ratios.last()];
    for ((which, promised), measured) in COST.into_iter().zip(measured) {
        let Some(ratio) = measured else { continue };
        targets.push(Target {
            about: format!("exact casting in boxes: cost over f64, {which} scene"),
            expected: format!("{promised:.2}"),
            measured: format!("{ratio:.2}"),
            met: *ratio <= promised,
            is_time: true,
        });
    }
    targets
}
