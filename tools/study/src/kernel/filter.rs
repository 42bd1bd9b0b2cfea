//! What filters share. A filter decides in floats and knows how far they may be off; the names
//! of its kinds are the field's (Shewchuk 1997; Brönnimann, Burnikel & Pion, "Interval
//! arithmetic yields efficient dynamic filters for computational geometry", *Discrete Applied
//! Mathematics* 109, 2001). A *static* filter has [`Limits`] that were worked out once for a
//! shape and all rays that begin near enough; a *semi-static* one is the same code with limits
//! of one ray.

use serde::Serialize;

use super::sphere::ScaledRay;
use crate::number::{ROOT_OF_UNIT, TINY};
use crate::shape::Ray;

/// What has the last word in an exact kernel, from cheap to dear. A whole scene has a static
/// filter before these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub enum Tier {
    /// An error bound computed from this ray and this shape.
    #[serde(rename = "semi-static filter")]
    SemiStatic,
    /// Twice the digits, with an error bound.
    #[serde(rename = "double-double")]
    DoubleDouble,
    /// Whole numbers of any length.
    #[serde(rename = "exact")]
    Exact,
}

impl Tier {
    /// How tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Tier::SemiStatic => "semi-static filter",
            Tier::DoubleDouble => "double-double",
            Tier::Exact => "exact",
        }
    }
}

/// What a filter compares with where plain arithmetic compares with 0. Infinite at first:
/// every question is left open.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// What decides hit or miss has its sign if it is further from 0 than this.
    pub sign: f64,
    /// The divisor of t is good to ½√u if it is further from 0, and so is the root in it.
    pub divisor: f64,
    /// The dividend of t is good to ½√u, and has its sign, if it is further from 0.
    pub dividend: f64,
}

impl Default for Limits {
    fn default() -> Limits {
        let [sign, divisor, dividend] = [f64::INFINITY; 3];
        Limits {
            sign,
            divisor,
            dividend,
        }
    }
}

/// Which t are surely from `min_t` on, and which surely before, if they are good to √u of
/// themselves.
///
/// t > m (1 + 8√u) + 2 TINY implies t − m > 4√u t + TINY, and t < m (1 − 8√u) − 2 TINY
/// that m − t > 4√u max(|t|, m) + TINY: what is further from m than 4√u of the larger is on
/// its side of it. That is for m ≥ 0, as all that casts scenes has it; else nothing is sure.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// Beyond this t are surely not before `min_t`.
    pub after: f64,
    /// Below this they surely are.
    pub before: f64,
}

impl Window {
    /// For one `min_t`, in the measure of t.
    #[inline(always)]
    pub fn new(min_t: f64) -> Window {
        let room = 8.0 * ROOT_OF_UNIT;
        match min_t >= 0.0 && min_t.is_finite() {
            true => Window {
                after: min_t * (1.0 + room) + 2.0 * TINY,
                before: min_t * (1.0 - room) - 2.0 * TINY,
            },
            false => Window {
                after: f64::INFINITY,
                before: f64::NEG_INFINITY,
            },
        }
    }

    /// What a t of the scaled ray answers, if that is sure.
    #[inline(always)]
    pub fn answer(&self, t: f64, scaled: &ScaledRay<f64>) -> Option<Option<f64>> {
        if t < self.before {
            return Some(None);
        }
        let t = (t > self.after).then(|| scaled.unscale(t))?;
        t.is_finite().then_some(Some(t))
    }
}

/// A ray scaled for filters, and as it was given, for exact decisions.
#[derive(Clone, Copy, Debug)]
pub struct Prepared {
    /// For filters.
    pub scaled: ScaledRay<f64>,
    /// For exact decisions.
    pub given: Ray<f64>,
}

impl Prepared {
    /// Once for a ray.
    #[inline(always)]
    pub fn new(ray: &Ray<f64>) -> Prepared {
        let (scaled, given) = (ScaledRay::new(ray), *ray);
        Prepared { scaled, given }
    }
}
