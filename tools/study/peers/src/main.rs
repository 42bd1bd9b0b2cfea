//! Benchmark of our caster against others, on the same rays and meshes:
//! `cargo run --release --manifest-path tools/study/peers/Cargo.toml`.
//!
//! The casters take turns. Each round casts all rays, and the median round is reported, in CPU
//! time of this thread. Answers that differ from the exact caster's are counted. The times
//! depend on the build: `RUSTFLAGS="-C target-cpu=native"` makes all casters written in Rust
//! faster, ours included, whereas Embree selects its instruction set at run time.

#[cfg(embree)]
mod embree;
mod mesh;
mod peer;
mod rays;

use std::hint::black_box;

use mesh::{Mesh, ball, of_assignment};
use pinhole_study::speed::{Workload, race};
use rays::Ray;

/// Target: our time divided by Embree's should be at most this.
const OVER_EMBREE: f64 = 1.5;
/// Target: the time of parry3d in `f64`, divided by ours, should be at least this.
const OVER_PARRY: f64 = 2.0;

/// Largest difference of two t that agree: a hundred unit roundoffs of `f32`. The rounded
/// origin and corners alone move t by a few of them.
const FAR: f64 = 6e-6;

fn main() {
    let seconds = std::env::args().nth(1).map_or(1.0, |seconds| {
        seconds.parse().expect("the argument is a time in seconds")
    });
    let level = match (cfg!(target_feature = "avx2"), cfg!(target_feature = "fma")) {
        (true, true) => "AVX2 and FMA",
        _ => "the baseline instruction set",
    };
    println!("built for {level}");
    if cfg!(not(embree)) {
        println!("skipped Embree: its headers are not installed (Debian: libembree-dev)");
    }
    for mesh in [
        of_assignment("teapot"),
        of_assignment("bunny"),
        ball(94),
        ball(354),
    ] {
        compare(&mesh, &rays::primary(), seconds);
    }
}

/// Times all casters on these rays and prints a table. The column `over` is the time relative
/// to Embree robust, or to ours if Embree is missing.
fn compare(mesh: &Mesh, rays: &[Ray], seconds: f64) {
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
    println!("\n{}, {} rays", mesh.name, rays.len());
    println!(
        "{:<22}{:>16}{:>8}{:>11}{:>13}",
        "", "ns/ray", "over", "differ", "building/ms"
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
        let what = "our exact time divided by that of Embree robust, at most";
        tell(what, OVER_EMBREE, over, over <= OVER_EMBREE);
    }
    if let Some(over) = time(peer::PARRY).map(|parry| parry / exact) {
        let what = "time of parry3d-f64 divided by ours, exact, at least";
        tell(what, OVER_PARRY, over, over >= OVER_PARRY);
    }
}

/// Whether both miss, or both hit and their t differ by no more than rounding to `f32`
/// explains.
fn agree(one: f64, other: f64) -> bool {
    match one.is_finite() && other.is_finite() {
        true => (one - other).abs() <= FAR * (1.0 + one.abs()),
        false => one == other,
    }
}
