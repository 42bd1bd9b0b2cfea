//! The judge and its one rule.
//!
//! Same size, same channels, all finite; then at **every** pixel
//! |film − golden| ≤ tolerance in every channel. No percentage of pixels is
//! allowed to differ: what may differ, and by how much, is written pixel by pixel
//! in the tolerance film, which comes from Mitsuba like the golden itself.
//!
//! [`oiiotool`](crate::oiiotool) states the same rule as a command line of
//! OpenImageIO's. Both compute in 32-bit floats, and must agree on every film.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::camera::{Pixel, Resolution};
use crate::error::Error;
use crate::film::Film;

/// The tolerance that lets every finite sample pass.
pub const EXEMPT: f32 = f32::MAX;

/// A film made by Mitsuba and how far each of its samples may be missed.
#[derive(Clone, Debug)]
pub struct Golden {
    film: Film,
    tolerance: Film,
}

impl Golden {
    /// A golden and its tolerance film.
    ///
    /// # Errors
    /// If they differ in size or channels, hold a sample that is not finite, or exempt
    /// more pixels than [`most_exempt`](Golden::most_exempt).
    pub fn new(film: Film, tolerance: Film) -> Result<Golden, Refusal> {
        compare_layout(&film, &tolerance)?;
        for film in [&film, &tolerance] {
            refuse_non_finite(film)?;
        }
        let golden = Golden { film, tolerance };
        let pixels = golden.film.resolution().pixels();
        let exempt = (0..pixels).filter(|index| golden.is_exempt(*index)).count();
        match exempt > Golden::most_exempt(pixels) {
            true => Err(Refusal::TooLenient { exempt, pixels }),
            false => Ok(golden),
        }
    }

    /// How many of so many pixels may be exempt: one or 0.05 %, whichever is more.
    pub fn most_exempt(pixels: usize) -> usize {
        (pixels / 2000).max(1)
    }

    /// Reads `NAME.exr` and its tolerance film `NAME.tol.exr`.
    ///
    /// # Errors
    /// If either cannot be read, or they do not belong together.
    pub fn read(path: &Path) -> Result<Golden, Error> {
        let tolerance_path = tolerance_path(path);
        let golden = Golden::new(Film::read(path)?, Film::read(&tolerance_path)?);
        golden.map_err(|refusal| {
            Error::new(
                &tolerance_path,
                format!("this tolerance film does not fit its golden: {refusal}"),
                "make both again: cargo run --release -- golden render",
            )
        })
    }

    /// What Mitsuba saw.
    pub fn film(&self) -> &Film {
        &self.film
    }

    /// How far a film may be from it.
    pub fn tolerance(&self) -> &Film {
        &self.tolerance
    }

    /// Whether the pixel at `index` is exempt: Mitsuba itself is of two minds there.
    pub fn is_exempt(&self, index: usize) -> bool {
        self.tolerance
            .channels()
            .iter()
            .all(|channel| channel.samples[index] == EXEMPT)
    }
}

/// Where the tolerance film of a golden lies.
pub fn tolerance_path(golden: &Path) -> PathBuf {
    golden.with_extension("tol.exr")
}

/// A film that cannot be compared at all.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// Not as many pixels, or in another arrangement.
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
        /// Of how many.
        pixels: usize,
    },
    /// A sample is NaN or infinite.
    NotFinite {
        /// In which channel.
        channel: String,
        /// At the first such pixel in image order.
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
                    "the film has a channel `{}` that the golden has not",
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
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelVerdict {
    /// The channel.
    pub name: String,
    /// How many pixels miss the golden by more than the tolerance.
    pub failing: usize,
    /// How many of them show the right object, so that the difference is this
    /// channel's own. All of them, for the id itself.
    pub own: usize,
    /// The one that misses it by the most tolerances; pixels that show the right
    /// object come first, because there the difference is this channel's own.
    pub worst: Option<Mismatch>,
    /// The smallest rectangle of pixels around all that fail.
    pub bounds: Option<Bounds>,
}

/// One sample that is too far from its golden.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mismatch {
    /// Where.
    pub pixel: Pixel,
    /// The film's sample.
    pub got: f32,
    /// The golden's.
    pub expected: f32,
    /// How far apart they might have been.
    pub allowed: f32,
}

/// A rectangle of pixels, both corners included.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// Judges a film by the one rule.
///
/// # Errors
/// If the guards refuse the film; it then fails without being compared.
pub fn judge(golden: &Golden, film: &Film) -> Result<Verdict, Refusal> {
    compare_layout(&golden.film, film)?;
    refuse_non_finite(film)?;

    let resolution = film.resolution();
    let pixels = 0..resolution.pixels();
    let right_object: Vec<bool> = match comparison(golden, film, "id") {
        Some(ids) => pixels.clone().map(|index| !ids.fails(index)).collect(),
        None => vec![true; resolution.pixels()],
    };
    let mut fails = vec![false; resolution.pixels()];
    let mut channels = Vec::new();
    for channel in in_usual_order(&golden.film) {
        let Some(samples) = comparison(golden, film, channel) else {
            return Err(Refusal::MissingChannel(channel.into()));
        };
        let mut verdict = ChannelVerdict {
            name: channel.into(),
            failing: 0,
            own: 0,
            worst: None,
            bounds: None,
        };
        let mut worst = (false, 0.0);
        for index in pixels.clone().filter(|index| samples.fails(*index)) {
            let pixel = resolution.pixel(index);
            fails[index] = true;
            verdict.failing += 1;
            verdict.own += usize::from(right_object[index] || channel == "id");
            verdict.bounds = Some(Bounds::around(verdict.bounds, pixel));
            let badness = (right_object[index], samples.tolerances(index));
            if verdict.worst.is_none() || badness > worst {
                worst = badness;
                verdict.worst = Some(samples.mismatch(pixel, index));
            }
        }
        channels.push(verdict);
    }
    Ok(Verdict {
        resolution,
        channels,
        failing: pixels.clone().filter(|index| fails[*index]).collect(),
        exempt: pixels.filter(|index| golden.is_exempt(*index)).count(),
    })
}

/// One channel of film, golden and tolerance side by side.
struct Comparison<'a> {
    got: &'a [f32],
    expected: &'a [f32],
    allowed: &'a [f32],
}

fn comparison<'a>(golden: &'a Golden, film: &'a Film, channel: &str) -> Option<Comparison<'a>> {
    Some(Comparison {
        got: film.channel(channel)?,
        expected: golden.film.channel(channel)?,
        allowed: golden.tolerance.channel(channel)?,
    })
}

impl Comparison<'_> {
    fn distance(&self, index: usize) -> f32 {
        (self.got[index] - self.expected[index]).abs()
    }

    fn fails(&self, index: usize) -> bool {
        self.distance(index) > self.allowed[index]
    }

    fn tolerances(&self, index: usize) -> f64 {
        f64::from(self.distance(index)) / f64::from(self.allowed[index])
    }

    fn mismatch(&self, pixel: Pixel, index: usize) -> Mismatch {
        Mismatch {
            pixel,
            got: self.got[index],
            expected: self.expected[index],
            allowed: self.allowed[index],
        }
    }
}

impl Bounds {
    fn around(bounds: Option<Bounds>, pixel: Pixel) -> Bounds {
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

fn compare_layout(golden: &Film, film: &Film) -> Result<(), Refusal> {
    if film.resolution() != golden.resolution() {
        return Err(Refusal::WrongSize {
            got: film.resolution(),
            expected: golden.resolution(),
        });
    }
    let absent = |from: &Film, of: &Film| {
        let mut names = of.channels().iter().map(|channel| channel.name.clone());
        names.find(|name| from.channel(name).is_none())
    };
    if let Some(name) = absent(film, golden) {
        return Err(Refusal::MissingChannel(name));
    }
    absent(golden, film).map_or(Ok(()), |name| Err(Refusal::ExtraChannel(name)))
}

fn refuse_non_finite(film: &Film) -> Result<(), Refusal> {
    for name in in_usual_order(film) {
        let samples = film.channel(name).unwrap_or_default();
        if let Some(index) = samples.iter().position(|sample| !sample.is_finite()) {
            let pixel = film.resolution().pixel(index);
            return Err(Refusal::NotFinite {
                channel: name.into(),
                pixel,
            });
        }
    }
    Ok(())
}

/// Channel names as people read them; EXR files sort capitals first.
fn in_usual_order(film: &Film) -> Vec<&str> {
    let mut names: Vec<&str> = film
        .channels()
        .iter()
        .map(|channel| channel.name.as_str())
        .collect();
    let rank = |name: &&str| match *name {
        "id" => 0,
        "t" => 1,
        name if name.starts_with('O') => 2,
        name if name.starts_with('D') => 3,
        _ => 4,
    };
    names.sort_by_key(|name| (rank(name), name.to_string()));
    names
}

#[cfg(test)]
mod tests;
