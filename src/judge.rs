//! The judge and its one rule.
//!
//! A film passes if it has the golden's size and channels, all its values are finite, and |film −
//! golden| ≤ tolerance in every channel of **every** pixel. There is no share of pixels that may be
//! wrong. Instead, the tolerance film, which comes from Mitsuba like the golden, says for each
//! pixel how far a film may differ.
//!
//! One channel, [`TESTS`], counts work, and is judged by its sum. It passes at every pixel if the
//! sum of its distances from the golden is at most the sum of its tolerances.
//!
//! [`oiiotool`](crate::oiiotool) states the same rule as a command line of
//! OpenImageIO's. Both compute in 32-bit floats, and must agree on every film.

mod verdict;

use std::path::{Path, PathBuf};

use crate::camera::Pixel;
use crate::error::Error;
use crate::film::{Film, TESTS};

pub use verdict::{Bounds, ChannelVerdict, Mismatch, Refusal, Verdict};

/// The tolerance that lets every finite sample pass.
pub const EXEMPT: f32 = f32::MAX;

/// A film made by Mitsuba, and the tolerance of each of its samples.
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

    /// How many of this many pixels may be exempt: one or 0.05 %, whichever is more.
    ///
    /// ```
    /// use pinhole::judge::Golden;
    ///
    /// assert_eq!(Golden::most_exempt(160 * 90), 7);
    /// assert_eq!(Golden::most_exempt(9), 1);
    /// ```
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
                "make both again: cargo pinhole golden render",
            )
        })
    }

    /// Mitsuba's film.
    pub fn film(&self) -> &Film {
        &self.film
    }

    /// How far a film may be from it.
    pub fn tolerance(&self) -> &Film {
        &self.tolerance
    }

    /// Whether the pixel at `index` is exempt, because Mitsuba's own answer changes
    /// there when its ray moves slightly.
    pub fn is_exempt(&self, index: usize) -> bool {
        self.tolerance
            .channels()
            .iter()
            .all(|channel| channel.samples[index] == EXEMPT)
    }

    /// Where a film of the golden's size misses it by more than the tolerance, pixel by pixel in
    /// image order. NaN and a missing channel count as misses. Use it for pictures and
    /// explanations, which show refused films too; only [`judge`] decides.
    pub fn missed(&self, film: &Film, channel: &str) -> Vec<bool> {
        let pixels = 0..self.film.resolution().pixels();
        match comparison(self, film, channel) {
            Some(samples) => pixels
                .map(|index| samples.fails(index) || !samples.got[index].is_finite())
                .collect(),
            None => pixels.map(|_| true).collect(),
        }
    }
}

/// Where the tolerance film of a golden lies.
pub fn tolerance_path(golden: &Path) -> PathBuf {
    golden.with_extension("tol.exr")
}

/// Judges a film by the one rule.
///
/// # Errors
/// If the film can't be compared: wrong size, wrong channels, or a value that is not finite.
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
    /// Whether the channel counts work, and the sum of its distances from the golden is small
    /// enough.
    is_little_work: bool,
}

fn comparison<'a>(golden: &'a Golden, film: &'a Film, channel: &str) -> Option<Comparison<'a>> {
    let got = film.channel(channel)?;
    let expected = golden.film.channel(channel)?;
    let allowed = golden.tolerance.channel(channel)?;
    let mut samples = Comparison {
        got,
        expected,
        allowed,
        is_little_work: false,
    };
    let sum = |sample: &dyn Fn(usize) -> f32| -> f64 {
        let samples = (0..got.len()).map(|index| f64::from(sample(index)));
        samples.sum()
    };
    let distance = sum(&|index| samples.distance(index));
    samples.is_little_work = channel == TESTS && distance <= sum(&|index| allowed[index]);
    Some(samples)
}

impl Comparison<'_> {
    fn distance(&self, index: usize) -> f32 {
        (self.got[index] - self.expected[index]).abs()
    }

    fn fails(&self, index: usize) -> bool {
        !self.is_little_work && self.distance(index) > self.allowed[index]
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
