//! Finds where each kernel breaks, by the same rule for all kernels.

use crate::judge::Tally;
use crate::question::Data;
use crate::result::{BreakingPoint, Point, Sweep};

/// A kernel with a larger share of wrong decisions is broken.
const WRONG: f64 = 1e-3;

/// A kernel is broken if more than one decision in a thousand is wrong, if any t is not finite,
/// or if at least half of all t have lost half of their digits.
pub fn is_broken(tally: &Tally, data: Data) -> bool {
    let half_lost = 2f64.powf(f64::from(data.digits()) / 2.0);
    tally.wrong_share() > WRONG
        || tally.not_finite > 0
        || tally.median_ulp.is_some_and(|ulp| ulp > half_lost)
}

/// The breaking points of every kernel in a sweep.
pub fn breaking(sweep: &Sweep, data: Data) -> Vec<BreakingPoint> {
    let kernels = sweep.points.first().map_or(0, |point| point.kernels.len());
    (0..kernels).map(|at| of_kernel(sweep, data, at)).collect()
}

fn of_kernel(sweep: &Sweep, data: Data, at: usize) -> BreakingPoint {
    let broken = |point: &&Point| is_broken(&point.kernels[at].tally, data);
    // The exponent nearest to 0 is the easiest: search upwards from there.
    let exponents = || sweep.points.iter().map(|point| point.exponent);
    let easy = exponents().min_by_key(|x| x.abs()).unwrap_or_default();
    let mut above = sweep.points.iter().filter(|point| point.exponent >= easy);
    let named = &sweep.points[0].kernels[at];
    BreakingPoint {
        shape: sweep.shape,
        family: sweep.family,
        kernel: named.kernel,
        numbers: named.numbers,
        above: above.find(broken).map(|point| point.exponent),
    }
}
