//! What the judge can say, as data. [`report`](crate::report) puts it in words.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::camera::{Pixel, Resolution};

/// A film that cannot be compared at all.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The film has another size.
    WrongSize {
        /// The film's.
        got: Resolution,
        /// The golden's.
        expected: Resolution,
    },
    /// A channel of the golden is not in the film.
    MissingChannel(String),
    /// A channel of the film is not in the golden.
    ExtraChannel(String),
    /// A tolerance film exempts more pixels than any golden may.
    TooLenient {
        /// How many it exempts.
        exempt: usize,
        /// How many pixels it has.
        pixels: usize,
    },
    /// A sample is NaN or infinite.
    NotFinite {
        /// The channel.
        channel: String,
        /// The first such pixel in image order.
        pixel: Pixel,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::WrongSize { got, expected } => {
                write!(f, "the film has {got} pixels, the golden {expected}")
            }
            Refusal::MissingChannel(name) => write!(f, "the film has no channel `{name}`"),
            Refusal::ExtraChannel(name) => {
                write!(
                    f,
                    "the film has a channel `{}` that the golden lacks",
                    name.escape_debug()
                )
            }
            Refusal::TooLenient { exempt, pixels } => {
                write!(
                    f,
                    "{exempt} of {pixels} pixels are exempt, more than 0.05 %"
                )
            }
            Refusal::NotFinite { channel, pixel } => {
                write!(f, "channel `{channel}` is NaN or infinite at pixel {pixel}")
            }
        }
    }
}

/// What the judge says of a film that could be compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Size of film and golden.
    pub resolution: Resolution,
    /// One for each channel, in the golden's usual order: id, t, normal.
    pub channels: Vec<ChannelVerdict>,
    /// Pixels at which some channel fails, as indices in image order, ascending.
    pub failing: Vec<usize>,
    /// How many pixels are exempt by tolerance.
    pub exempt: usize,
}

/// The verdict on one channel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChannelVerdict {
    /// The channel.
    pub name: String,
    /// How many pixels miss the golden by more than the tolerance.
    pub failing: usize,
    /// How many of them show the right object, which means that this channel itself is wrong. For
    /// the id, all of them count.
    pub own: usize,
    /// The pixel that misses the golden by the largest multiple of its tolerance. Pixels that show
    /// the right object come first, because there this channel itself is wrong.
    pub worst: Option<Mismatch>,
    /// The smallest rectangle of pixels around all that fail.
    pub bounds: Option<Bounds>,
}

/// One sample that is too far from its golden.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mismatch {
    /// The pixel.
    pub pixel: Pixel,
    /// The film's sample.
    pub got: f32,
    /// The golden's.
    pub expected: f32,
    /// How far apart they may be.
    pub allowed: f32,
}

/// A rectangle of pixels, both corners included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// Bottom left.
    pub min: Pixel,
    /// Top right.
    pub max: Pixel,
}

impl Verdict {
    /// Whether the film is as good as Mitsuba's.
    pub fn passes(&self) -> bool {
        self.failing.is_empty()
    }
}

impl Bounds {
    /// The smallest rectangle that holds `bounds` and `pixel`.
    pub(super) fn around(bounds: Option<Bounds>, pixel: Pixel) -> Bounds {
        let Bounds { min, max } = bounds.unwrap_or(Bounds {
            min: pixel,
            max: pixel,
        });
        Bounds {
            min: Pixel {
                i: min.i.min(pixel.i),
                j: min.j.min(pixel.j),
            },
            max: Pixel {
                i: max.i.max(pixel.i),
                j: max.j.max(pixel.j),
            },
        }
    }
}
