//! Decides what a kind of shape is computed with: the cheapest numbers that serve.

use super::known::Known;
use crate::plan::bounds::Bound;
use crate::plan::told::{bounded, percent};
use crate::plan::{Kind, Numbers, Wish};

/// Where more hits than this are uncertain in `f32`, casting them again in `f64` takes
/// what `f32` can spare.
const MOST_AGAIN_IN_F64: f64 = 0.2;
/// Where more are uncertain in `f64`, watching them is spared, and all are exact.
const MOST_AGAIN_EXACTLY: f64 = 0.5;

/// What a kind is computed with, and why.
#[derive(Clone)]
pub struct Decision {
    /// The numbers.
    pub numbers: Numbers,
    /// Whether each hit's own bound is looked at.
    pub watched: bool,
    /// Why these numbers.
    pub reason: String,
}

impl Decision {
    /// The cheapest numbers that are no worse than `from` and serve. What is cheaper is
    /// added to `left_out`, and why it does not.
    pub fn of(
        (kind, known): (Kind, &Known),
        wish: Wish,
        from: Numbers,
        left_out: &mut Vec<String>,
    ) -> Decision {
        let inexact = [
            (Numbers::F32, known.in_f32, MOST_AGAIN_IN_F64, "in f64"),
            (Numbers::F64, known.in_f64, MOST_AGAIN_EXACTLY, "exactly"),
        ];
        for (numbers, doubt, most_again, again) in inexact {
            if numbers < from {
                continue;
            }
            let (watched, reason) = if wish.is_met(doubt.worst) {
                (false, met(doubt.worst, wish))
            } else if doubt.open <= most_again {
                (true, watched(doubt.open, again))
            } else {
                left_out.push(format!(
                    "{} for {}: {} of the hits would be uncertain",
                    numbers.name(),
                    kind.name(),
                    percent(doubt.open)
                ));
                continue;
            };
            return Decision {
                numbers,
                watched,
                reason,
            };
        }
        Decision {
            numbers: Numbers::Exact,
            watched: false,
            reason: "f64 is uncertain too often: each t is exact, and rounded once".into(),
        }
    }
}

/// Why no hit needs to be watched.
fn met(worst: Bound, wish: Wish) -> String {
    match (wish.depth || wish.normal, wish.exact_ids) {
        (true, _) => format!("no ray can be off by more: {}", bounded(worst, wish)),
        (false, true) => "which object is nearest is filtered, and decided exactly".into(),
        (false, false) => "neither t nor normals are asked for".into(),
    }
}

/// Why hits are watched, of which this share is uncertain.
fn watched(open: f64, again: &str) -> String {
    match open > 0.0 {
        true => format!(
            "{} of the sample's hits are certain to meet X; each hit is watched, and what is not \
             is cast again {again}",
            percent(1.0 - open)
        ),
        false => format!(
            "every hit of the sample is certain to meet X, if not every ray there could be; each \
             hit is watched, and what is not certain is cast again {again}"
        ),
    }
}
