//! What gets through closed meshes, and what is met twice.

use super::before::MESHES;
use super::{agree, counted, percent};
use crate::result::{MeshTally, Target};

pub fn targets(meshes: &[MeshTally]) -> Vec<Target> {
    let mut targets = Vec::new();
    for (kernel, leaks, double_hits) in MESHES {
        for (at, aimed_at) in ["edge", "vertex"].into_iter().enumerate() {
            let is_it =
                |m: &&MeshTally| m.kernel == kernel && m.numbers == "f64" && m.aimed_at == aimed_at;
            let tally = meshes.iter().find(is_it);
            targets.extend(tally.map(|tally| leaking(tally, leaks[at])));
            targets.extend(tally.map(|tally| doubling(tally, double_hits[at])));
        }
    }
    targets
}

fn leaking(tally: &MeshTally, share: f64) -> Target {
    Target {
        about: format!(
            "{}: leaks at {} {}, f64",
            tally.kernel,
            article(tally),
            tally.aimed_at
        ),
        expected: percent(share),
        measured: of_rays(tally.leaks, tally.rays),
        met: agree(share, tally.leaks, tally.rays),
        is_time: false,
    }
}

fn doubling(tally: &MeshTally, share: f64) -> Target {
    Target {
        about: format!(
            "{}: double hits at {} {}, f64",
            tally.kernel,
            article(tally),
            tally.aimed_at
        ),
        expected: percent(share),
        measured: of_rays(tally.double_hits, tally.rays),
        met: agree(share, tally.double_hits, tally.rays),
        is_time: false,
    }
}

fn article(tally: &MeshTally) -> &'static str {
    if tally.aimed_at == "edge" { "an" } else { "a" }
}

fn of_rays(count: u64, rays: u64) -> String {
    match count {
        0 => counted(0, rays),
        _ => percent(count as f64 / rays as f64),
    }
}
