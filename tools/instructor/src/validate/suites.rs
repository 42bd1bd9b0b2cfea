//! How the test suites of other renderers would judge the same films.
//!
//! Their rule is OpenImageIO's `idiff`: a picture fails if more than a percentage of
//! its pixels differ by more than `fail` in some channel, or if any pixel differs by
//! more than `hard_fail`. Their pictures are lit and coloured and ours are not, so the
//! rules are put to the three false-colour pictures that `pinhole render` writes, values
//! from 0 to 1 in steps of 1/255, each judged as a picture of its own: one that fails is
//! enough. That is kind to them, for in a lit picture a normal or a depth shows only as
//! far as it changes the light.

use std::ops::Range;

use image::RgbImage;
use pinhole::{Film, false_colour};

/// One suite's rule.
#[derive(Clone, Copy, Debug)]
pub struct Suite {
    /// Whose.
    pub name: &'static str,
    /// The difference at which a pixel counts, 0 to 1.
    fail: f64,
    /// The percentage of pixels that may count.
    fail_percent: f64,
    /// The difference that no pixel may have.
    hard_fail: f64,
}

/// Their rules, as of 2026.
pub const SUITES: [Suite; 3] = [
    // The default of its render tests.
    Suite {
        name: "Blender",
        fail: 0.016,
        fail_percent: 1.0,
        hard_fail: f64::INFINITY,
    },
    // The default of testsuite/runtest.py.
    Suite {
        name: "OSL",
        fail: 0.004,
        fail_percent: 0.02,
        hard_fail: 0.01,
    },
    // The image comparisons of its imaging tests.
    Suite {
        name: "OpenUSD",
        fail: 0.05,
        fail_percent: 0.03,
        hard_fail: f64::INFINITY,
    },
];

/// The three pictures of a film.
pub struct Pictures([RgbImage; 3]);

impl Pictures {
    /// Of `film`, its depths over `range`.
    pub fn of(film: &Film, depth_per_t: f64, range: &Range<f64>) -> Pictures {
        Pictures([
            false_colour::id(film),
            false_colour::depth(film, depth_per_t, range.clone()),
            false_colour::normal(film),
        ])
    }
}

impl Suite {
    /// Whether the rule sees that `got` is not `expected`.
    pub fn detects(&self, expected: &Pictures, got: &Pictures) -> bool {
        let mut pairs = expected.0.iter().zip(&got.0);
        pairs.any(|(expected, got)| self.fails(expected, got))
    }

    fn fails(&self, expected: &RgbImage, got: &RgbImage) -> bool {
        let pixels = f64::from(expected.width()) * f64::from(expected.height());
        let differences = expected.pixels().zip(got.pixels()).map(|(a, b)| {
            let channels = a.0.iter().zip(b.0);
            let most = channels.map(|(a, b)| a.abs_diff(b)).max();
            f64::from(most.unwrap_or(0)) / 255.0
        });
        let (mut counted, mut most) = (0.0, 0.0_f64);
        for difference in differences {
            counted += f64::from(u8::from(difference > self.fail));
            most = most.max(difference);
        }
        counted > self.fail_percent / 100.0 * pixels || most > self.hard_fail
    }
}

#[cfg(test)]
mod tests;
