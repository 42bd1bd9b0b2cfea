//! Our caster beside others, on the same rays and meshes:
//! `cargo run --release --manifest-path tools/study/peers/Cargo.toml`.
//!
//! All take turns, each round casts all rays, and the median round counts, in CPU time
//! of this thread. What anybody sees otherwise than the exact caster is counted. The
//! times are of this build: `RUSTFLAGS="-C target-cpu=native"` makes ours, and all that is
//! written in Rust, faster, while Embree looks for itself what the processor can do.

mod mesh;
mod peer;
mod race;
mod rays;

use mesh::{Mesh, ball, of_assignment};
use race::{Result, race};

/// Ours, over Embree's: for primary and for incoherent rays.
const OVER_EMBREE: [f64; 2] = [1.5, 2.5];
/// Parry's in `f64`, over ours.
const OVER_PARRY: f64 = 2.0;

fn main() {
    let rounds = std::env::args().nth(1);
    let rounds = rounds.map_or(9, |rounds| {
        rounds.parse().expect("the argument is how many rounds")
    });
    let features = ["sse2", "avx2", "fma"];
    let has = [
        cfg!(target_feature = "sse2"),
        cfg!(target_feature = "avx2"),
        cfg!(target_feature = "fma"),
    ];
    let has: Vec<_> = features
        .into_iter()
        .zip(has)
        .filter(|(_, has)| *has)
        .collect();
    println!(
        "built for: {}",
        has.iter()
            .map(|(name, _)| *name)
            .collect::<Vec<_>>()
            .join(", ")
    );
    if cfg!(not(embree)) {
        println!("skipped: Embree, whose headers are not there (Debian: libembree-dev)");
    }
    for mesh in [
        of_assignment("teapot.obj"),
        of_assignment("bunny.obj"),
        ball(94),
        ball(354),
    ] {
        compare(&mesh, rounds);
    }
}

/// `over` is relative to Embree robust, or to ours where that is missing.
fn compare(mesh: &Mesh, rounds: usize) {
    let primary = rays::primary();
    let incoherent = rays::incoherent(mesh, &primary);
    for (kind, rays, over_embree) in [
        ("primary", &primary, OVER_EMBREE[0]),
        ("incoherent", &incoherent, OVER_EMBREE[1]),
    ] {
        let results = race(mesh, rays, rounds);
        println!("\n{}, {} {kind} rays", mesh.name, rays.len());
        println!(
            "{:<22}{:>9}{:>8}{:>11}{:>13}",
            "", "ns/ray", "over", "otherwise", "building/ms"
        );
        let time = |name: &str| {
            let result = results.iter().find(|result| result.name == name);
            result.map(|result| result.nanoseconds)
        };
        let unit = time(peer::ROBUST).unwrap_or(results[0].nanoseconds);
        for result in &results {
            let Result {
                name,
                building,
                nanoseconds,
                otherwise,
            } = result;
            let over = nanoseconds / unit;
            println!("{name:<22}{nanoseconds:>9.1}{over:>8.2}{otherwise:>11}{building:>13.1}");
        }
        let exact = results[0].nanoseconds;
        if time(peer::ROBUST).is_some() {
            tell(
                "ours, exact, over Embree robust, at most",
                over_embree,
                exact / unit,
                exact <= over_embree * unit,
            );
        }
        let parry = time(peer::PARRY).expect("it is linked") / exact;
        tell(
            "parry3d-f64 over ours, exact, at least",
            OVER_PARRY,
            parry,
            parry >= OVER_PARRY,
        );
    }
}

fn tell(what: &str, target: f64, measured: f64, is_met: bool) {
    let verdict = if is_met { "pass" } else { "falls short" };
    println!("{what} {target:.1}: {measured:.2}, {verdict}");
}
