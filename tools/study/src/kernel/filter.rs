//! Floating-point filters. A filter decides in floats, with a bound on its rounding error. The
//! names of its kinds follow the literature (Shewchuk 1997; Brönnimann, Burnikel & Pion,
//! "Interval arithmetic yields efficient dynamic filters for computational geometry", *Discrete
//! Applied Mathematics* 109, 2001). A *static* filter has [`Limits`] that are computed once for
//! a shape and all rays of a camera. A *semi-static* one has limits computed for one ray.

use serde::Serialize;

use super::sphere::ScaledRay;
use crate::number::{ROOT_OF_UNIT, TINY};

/// The stages of an exact kernel, cheapest first: the value names the one that decided. When whole
/// scenes are cast, a static filter comes before these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Tier {
    /// An error bound computed from this ray and this shape.
    #[serde(rename = "semi-static filter")]
    SemiStatic,
    /// Integers of any length.
    #[serde(rename = "exact")]
    Exact,
}

/// The thresholds of a filter, used where plain arithmetic compares with 0.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The sign of the quantity that decides hit or miss is certain if its magnitude exceeds
    /// this.
    pub sign: f64,
    /// The relative error of t's divisor, and of the square root in it, is at most ½√u if its
    /// magnitude exceeds this.
    pub divisor: f64,
    /// The sign of t's dividend is certain, and its relative error at most ½√u, if its
    /// magnitude exceeds this.
    pub dividend: f64,
}

/// A ray with a `min_t`, as filters see it: which t are certainly at least `min_t`, and which are
/// certainly below it, if their relative error is at most √u?
///
/// For m = `min_t`, t > m (1 + 8√u) + 2 TINY implies t − m > 4√u t + TINY, and t < m (1 − 8√u)
/// − 2 TINY implies m − t > 4√u max(|t|, m) + TINY. A computed t that is further from m than
/// 4√u times the larger of the two is on the same side of m as the true t. This holds for m ≥
/// 0. So filters must not be asked about other m.
#[derive(Clone, Copy, Debug)]
pub struct ScaledQuery {
    /// The ray.
    pub scaled: ScaledRay<f64>,
    /// A t of the scaled ray above this is certainly not below `min_t`.
    pub after: f64,
    /// A t of the scaled ray below this is certainly below `min_t`.
    pub before: f64,
}

impl ScaledQuery {
    /// The query for a `min_t` in multiples of the scaled direction. It must not be negative.
    #[inline(always)]
    pub fn new(scaled: ScaledRay<f64>, min_t: f64) -> ScaledQuery {
        let room = 8.0 * ROOT_OF_UNIT;
        ScaledQuery {
            scaled,
            after: min_t * (1.0 + room) + 2.0 * TINY,
            // Scaling may have taken `min_t` beyond the largest `f64`, and a t near that number is
            // not certainly below.
            before: min_t.min(f64::MAX) * (1.0 - room) - 2.0 * TINY,
        }
    }

    /// The answer for a t of the scaled ray; `None` if it is not certain.
    #[inline(always)]
    pub fn answer(&self, t: f64) -> Option<Option<f64>> {
        if t < self.before {
            return Some(None);
        }
        let t = (t > self.after).then(|| self.scaled.unscale(t))?;
        t.is_finite().then_some(Some(t))
    }
}
