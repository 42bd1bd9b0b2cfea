//! Why a pixel is wrong, as far as film and golden show it.

use pinhole::Film;
use pinhole::false_colour::Difference;
use pinhole::film::HIT_CHANNELS;
use pinhole::judge::Golden;

/// What is wrong at a pixel. If several causes apply, the first counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    NotFinite,
    MissesHit,
    HitsMiss,
    AnotherObject,
    TooNear,
    TooFar,
    NormalReversed,
    NormalNotUnit,
    AnotherNormal,
}

/// A normal counts as a unit vector if its length differs from 1 by no more than this. Rounding to
/// 32-bit floats never causes so large a difference, and a forgotten normalisation rarely causes a
/// smaller one.
const UNIT: f32 = 1e-4;

/// A normal counts as reversed if its opposite differs from the golden's by no more than this. The
/// limit may be wider than the tolerance, because no points depend on it.
const REVERSED: f32 = 1e-3;

impl Cause {
    /// All causes, in the order in which they are tried.
    pub const ALL: [Cause; 9] = [
        Cause::NotFinite,
        Cause::MissesHit,
        Cause::HitsMiss,
        Cause::AnotherObject,
        Cause::TooNear,
        Cause::TooFar,
        Cause::NormalReversed,
        Cause::NormalNotUnit,
        Cause::AnotherNormal,
    ];

    /// The cause in words.
    pub fn words(self) -> &'static str {
        match self {
            Cause::NotFinite => "is not a finite number",
            Cause::MissesHit => "misses what should be hit",
            Cause::HitsMiss => "hits something where nothing should be hit",
            Cause::AnotherObject => "hits another object",
            Cause::TooNear => "right object, too near",
            Cause::TooFar => "right object, too far",
            Cause::NormalReversed => "right point, normal reversed",
            Cause::NormalNotUnit => "right point, normal of the wrong length",
            Cause::AnotherNormal => "right point, another normal",
        }
    }

    /// The colour of this cause in a difference picture; none if the colour depends on the pixel.
    pub fn difference(self) -> Option<Difference> {
        match self {
            Cause::NotFinite => None,
            Cause::MissesHit | Cause::HitsMiss | Cause::AnotherObject => Some(Difference::Object),
            Cause::TooNear | Cause::TooFar => Some(Difference::T),
            Cause::NormalReversed | Cause::NormalNotUnit | Cause::AnotherNormal => {
                Some(Difference::Normal)
            }
        }
    }
}

/// What is wrong with a film of hits, pixel by pixel in image order.
pub struct PixelCauses {
    /// The cause; `None` where the film agrees.
    pub causes: Vec<Option<Cause>>,
    /// Which channels miss the golden: bit k for the k-th of [`HIT_CHANNELS`].
    pub missed: Vec<u8>,
}

impl PixelCauses {
    /// Compares a film of hits with a golden of the same size.
    pub fn between(golden: &Golden, film: &Film) -> PixelCauses {
        let mut missed = vec![0; golden.film().resolution().pixels()];
        for (bit, channel) in HIT_CHANNELS.iter().enumerate() {
            for (mask, missed) in missed.iter_mut().zip(golden.missed(film, channel)) {
                *mask |= u8::from(missed) << bit;
            }
        }
        let [expected, got] = [golden.film(), film].map(samples);
        let cause = |(index, mask): (usize, &u8)| {
            (*mask != 0).then(|| {
                let [expected, got] = [expected, got].map(|film| film.map(|all| all[index]));
                cause(*mask, expected, got)
            })
        };
        let causes = missed.iter().enumerate().map(cause).collect();
        PixelCauses { causes, missed }
    }

    /// How many pixels have this cause.
    pub fn count(&self, cause: Cause) -> usize {
        let has = |other: &&Option<Cause>| **other == Some(cause);
        self.causes.iter().filter(has).count()
    }
}

/// The channels of a film of hits.
pub fn samples(film: &Film) -> [&[f32]; 5] {
    HIT_CHANNELS.map(|channel| film.channel(channel).unwrap_or_default())
}

fn cause(missed: u8, expected: [f32; 5], got: [f32; 5]) -> Cause {
    if got.iter().any(|sample| !sample.is_finite()) {
        return Cause::NotFinite;
    }
    if missed & 1 != 0 {
        return match (expected[0] >= 0.0, got[0] >= 0.0) {
            (true, false) => Cause::MissesHit,
            (false, true) => Cause::HitsMiss,
            _ => Cause::AnotherObject,
        };
    }
    if missed & 2 != 0 {
        return match got[1] < expected[1] {
            true => Cause::TooNear,
            false => Cause::TooFar,
        };
    }
    let length = got[2..].iter().map(|axis| axis * axis).sum::<f32>().sqrt();
    let reversed = |(expected, got): (&f32, &f32)| (expected + got).abs() <= REVERSED;
    if expected[2..].iter().zip(&got[2..]).all(reversed) {
        Cause::NormalReversed
    } else if (length - 1.0).abs() > UNIT {
        Cause::NormalNotUnit
    } else {
        Cause::AnotherNormal
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::html::testing::{film, golden};

    /// The cause at a pixel where object 1 is expected at t = 2 with this normal.
    fn cause_of(got: [f32; 5]) -> Option<Cause> {
        let expected = golden(&[[1.0, 2.0, 0.0, 0.6, 0.8]], 1e-3);
        PixelCauses::between(&expected, &film(&[got])).causes[0]
    }

    #[test]
    fn what_is_within_its_tolerance_has_no_cause() {
        assert_eq!(cause_of([1.0, 2.0, 0.0, 0.6, 0.8]), None);
        assert_eq!(cause_of([1.0, 2.0009, 0.0, 0.6, 0.8]), None);
    }

    #[test]
    fn hits_and_misses_are_told_apart() {
        assert_eq!(cause_of([-1.0, 0.0, 0.0, 0.0, 0.0]), Some(Cause::MissesHit));
        assert_eq!(
            cause_of([2.0, 1.5, 0.0, 0.0, 1.0]),
            Some(Cause::AnotherObject)
        );
        let nothing = golden(&[[-1.0, 0.0, 0.0, 0.0, 0.0]], 1e-3);
        let something = film(&[[0.0, 3.0, 1.0, 0.0, 0.0]]);
        assert_eq!(
            PixelCauses::between(&nothing, &something).causes[0],
            Some(Cause::HitsMiss)
        );
    }

    #[test]
    fn the_right_object_is_too_near_or_too_far_whatever_its_normal() {
        assert_eq!(cause_of([1.0, 1.9, 0.0, 0.6, 0.8]), Some(Cause::TooNear));
        assert_eq!(cause_of([1.0, 2.1, 0.0, -0.6, -0.8]), Some(Cause::TooFar));
    }

    #[test]
    fn three_kinds_of_wrong_normals_are_named() {
        assert_eq!(
            cause_of([1.0, 2.0, 0.0, -0.6, -0.8]),
            Some(Cause::NormalReversed)
        );
        assert_eq!(
            cause_of([1.0, 2.0, 0.0, 1.2, 1.6]),
            Some(Cause::NormalNotUnit)
        );
        assert_eq!(
            cause_of([1.0, 2.0, 1.0, 0.0, 0.0]),
            Some(Cause::AnotherNormal)
        );
    }

    #[test]
    fn nan_is_the_first_cause() {
        assert_eq!(
            cause_of([1.0, f32::NAN, 0.0, 0.6, 0.8]),
            Some(Cause::NotFinite)
        );
        assert_eq!(
            cause_of([2.0, 1.0, f32::INFINITY, 0.6, 0.8]),
            Some(Cause::NotFinite)
        );
        // Where nothing is hit, any t passes if it is a number.
        let nothing = golden(&[[-1.0, 0.0, 0.0, 0.0, 0.0]], pinhole::judge::EXEMPT);
        let nan = film(&[[-1.0, f32::NAN, 0.0, 0.0, 0.0]]);
        assert_eq!(
            PixelCauses::between(&nothing, &nan).causes[0],
            Some(Cause::NotFinite)
        );
    }

    #[test]
    fn the_channels_that_miss_are_marked_bit_by_bit() {
        let expected = golden(&[[1.0, 2.0, 0.0, 0.0, 1.0]; 2], 1e-3);
        let wrong = PixelCauses::between(
            &expected,
            &film(&[[1.0, 2.0, 0.0, 0.0, 1.0], [1.0, 9.0, 0.0, 0.0, -1.0]]),
        );
        assert_eq!(wrong.missed, [0, 0b10010]);
        assert_eq!(wrong.count(Cause::TooFar), 1);
    }
}
