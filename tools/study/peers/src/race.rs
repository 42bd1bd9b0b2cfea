//! Everybody in turns.

use std::hint::black_box;

use pinhole_study::speed::now;

use crate::mesh::Mesh;
use crate::peer;
use crate::rays::Ray;

/// What came of one.
pub struct Result {
    /// Who it is.
    pub name: &'static str,
    /// Of building, in milliseconds.
    pub building: f64,
    /// For a ray: the median round.
    pub nanoseconds: f64,
    /// Rays that hit where the exact caster's miss, or miss where they hit, or whose t
    /// differs by more than `f32` explains.
    pub otherwise: usize,
}

/// A hundred last digits of an `f32`: t is off by a few of those of origin and corners.
const FAR: f64 = 6e-6;

/// Times all, who take turns.
pub fn race(mesh: &Mesh, rays: &[Ray], rounds: usize) -> Vec<Result> {
    let mut peers = peer::all(mesh, rays);
    let answers: Vec<_> = peers.iter_mut().map(|peer| (peer.cast)()).collect();
    let mut times = vec![Vec::new(); peers.len()];
    for _ in 0..rounds {
        for (peer, times) in peers.iter_mut().zip(&mut times) {
            let start = now();
            black_box((peer.cast)());
            times.push((now() - start).as_secs_f64());
        }
    }
    let agree = |one: f64, other: f64| match one.is_finite() && other.is_finite() {
        true => (one - other).abs() <= FAR * (1.0 + one.abs()),
        false => one == other,
    };
    let result = |(at, mut times): (usize, Vec<f64>)| {
        times.sort_by(f64::total_cmp);
        let both = answers[0].iter().zip(&answers[at]);
        Result {
            name: peers[at].name,
            building: peers[at].building * 1e3,
            nanoseconds: times[times.len() / 2] * 1e9 / rays.len() as f64,
            otherwise: both.filter(|(one, other)| !agree(**one, **other)).count(),
        }
    };
    times.into_iter().enumerate().map(result).collect()
}
