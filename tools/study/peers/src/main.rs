//! Our caster beside others, on the same rays and meshes:
//! `cargo run --release --manifest-path tools/study/peers/Cargo.toml`.
//!
//! All take turns, each round casts all rays, and the median round counts, in CPU time
//! of this thread. What anybody sees otherwise than the exact caster is counted. The
//! times are of this build: `RUSTFLAGS="-C target-cpu=native"` makes ours, and all that is
//! written in Rust, faster, while Embree looks for itself what the processor can do.

#[cfg(embree)]
mod embree;
mod mesh;
mod peer;
mod rays;

use std::hint::black_box;

use mesh::{Mesh, ball, of_assignment};
use pinhole_study::speed::{Workload, race};
use rays::Ray;

/// Ours, over Embree's: for primary and for incoherent rays.
const OVER_EMBREE: [f64; 2] = [1.5, 2.5];
/// Parry's in `f64`, over ours.
const OVER_PARRY: f64 = 2.0;

/// A hundred last digits of an `f32`: t is off by a few of those of origin and corners.
const FAR: f64 = 6e-6;

fn main() {
    let seconds = std::env::args().nth(1).map_or(1.0, |seconds| {
        seconds.parse().expect("the argument is a time in seconds")
    });
    let level = match (cfg!(target_feature = "avx2"), cfg!(target_feature = "fma")) {
        (true, true) => "AVX2 and FMA",
        _ => "the baseline",
    };
    println!("built for {level}");
    if cfg!(not(embree)) {
        println!("skipped: Embree, whose headers are not there (Debian: libembree-dev)");
    }
    for mesh in [
        of_assignment("teapot.obj"),
        of_assignment("bunny.obj"),
        ball(94),
        ball(354),
    ] {
        let primary = rays::primary();
        let incoherent = rays::incoherent(&mesh, &primary);
        compare(&mesh, "primary", &primary, OVER_EMBREE[0], seconds);
        compare(&mesh, "incoherent", &incoherent, OVER_EMBREE[1], seconds);
    }
}

/// `over` is relative to Embree robust, or to ours where that is missing.
fn compare(mesh: &Mesh, kind: &str, rays: &[Ray], over_embree: f64, seconds: f64) {
    let peers = peer::all(mesh, rays);
    let answers: Vec<Vec<f64>> = peers.iter().map(|peer| (peer.cast)()).collect();
    let mut films: Vec<Workload> = Vec::new();
    for peer in &peers {
        films.push(Box::new(|| {
            black_box((peer.cast)());
        }));
    }
    let times = race(films, rays.len(), seconds);
    let time = |name: &str| {
        let at = peers.iter().position(|peer| peer.name == name)?;
        Some(times[at].nanoseconds)
    };
    let (exact, robust) = (times[0].nanoseconds, time(peer::ROBUST));
    println!("\n{}, {} {kind} rays", mesh.name, rays.len());
    println!(
        "{:<22}{:>16}{:>8}{:>11}{:>13}",
        "", "ns/ray", "over", "otherwise", "building/ms"
    );
    for ((peer, time), its) in peers.iter().zip(&times).zip(&answers) {
        let both = answers[0].iter().zip(its);
        let otherwise = both.filter(|(one, other)| !agree(**one, **other)).count();
        println!(
            "{:<22}{:>9.1} ± {:>2.0} %{:>8.2}{otherwise:>11}{:>13.1}",
            peer.name,
            time.nanoseconds,
            100.0 * time.spread,
            time.nanoseconds / robust.unwrap_or(exact),
            peer.building
        );
    }
    let tell = |what: &str, target: f64, measured: f64, is_met: bool| {
        let verdict = if is_met { "pass" } else { "falls short" };
        println!("{what} {target:.1}: {measured:.2}, {verdict}");
    };
    if let Some(over) = robust.map(|robust| exact / robust) {
        let what = "ours, exact, over Embree robust, at most";
        tell(what, over_embree, over, over <= over_embree);
    }
    if let Some(over) = time(peer::PARRY).map(|parry| parry / exact) {
        let what = "parry3d-f64 over ours, exact, at least";
        tell(what, OVER_PARRY, over, over >= OVER_PARRY);
    }
}

/// Both miss, or both hit and t differs by no more than `f32` explains.
fn agree(one: f64, other: f64) -> bool {
    match one.is_finite() && other.is_finite() {
        true => (one - other).abs() <= FAR * (1.0 + one.abs()),
        false => one == other,
    }
}
