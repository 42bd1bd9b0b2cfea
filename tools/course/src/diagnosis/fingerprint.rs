//! The fingerprint of a known mistake in a film: a sample of the pixels it gets wrong,
//! with the values it leaves there.
//!
//! Whole films of every mistake would take many times the space of the goldens. A sample is enough,
//! because a belief is a rule, so its errors show wherever the rule applies.

use pinhole::comparison::{FilmComparison, Witness};

/// What one mistake does to one film.
#[derive(Clone, Debug, PartialEq)]
pub struct Fingerprint {
    /// How many pixels it gets wrong.
    pub failing: usize,
    /// An even sample of these pixels, or all if they are few.
    pub sample: Vec<Witness>,
    /// Some pixels in which similar mistakes leave other values.
    pub telling: Vec<Witness>,
}

/// Sampled pixels per mistake and film. The standard error of a share that is estimated from this
/// many is at most about 5 %.
pub const MOST_SAMPLED: usize = 96;

/// Telling pixels per mistake and film, and per pair of similar mistakes.
pub const MOST_TELLING: usize = 48;
const TELLING_PER_PAIR: usize = 6;

/// The fingerprints of several mistakes' films of one golden, in the order of the films; `None`
/// for a film that passes.
pub fn fingerprints(films: &[FilmComparison<'_>]) -> Vec<Option<Fingerprint>> {
    let orders: Vec<Vec<usize>> = films.iter().map(shuffled).collect();
    let fingerprint = |own: usize| {
        let film = &films[own];
        let sample = orders[own].iter().take(MOST_SAMPLED);
        let mut telling: Vec<usize> = Vec::new();
        for other in (0..films.len()).filter(|other| *other != own) {
            let differs = |pixel: &&usize| !films[other].shows(&film.witness(**pixel));
            // The sample is enough to tell apart a mistake that differs nearly everywhere.
            let probed = sample.clone();
            let apart = probed.clone().filter(differs).count();
            if films[other].failing() > 0 && apart * 4 <= probed.len() {
                let few = orders[own].iter().filter(differs).take(TELLING_PER_PAIR);
                telling.extend(few);
            }
        }
        telling.sort_unstable();
        telling.dedup();
        telling.truncate(MOST_TELLING);
        Fingerprint {
            failing: film.failing(),
            sample: sample.map(|pixel| film.witness(*pixel)).collect(),
            telling: telling.iter().map(|pixel| film.witness(*pixel)).collect(),
        }
    };
    (0..films.len())
        .map(|own| (films[own].failing() > 0).then(|| fingerprint(own)))
        .collect()
}

impl Fingerprint {
    /// The place in the scattered order up to which its sample has every pixel that the mistake
    /// gets wrong.
    pub fn known_to(&self) -> u64 {
        let last = self.sample.iter().map(|witness| scattered(witness.pixel));
        match self.failing > self.sample.len() {
            true => last.max().unwrap_or(0),
            false => u64::MAX,
        }
    }
}

/// A pixel's place in an order that scatters neighbours, and is the same for all films (Knuth's
/// multiplicative hash, The Art of Computer Programming, vol. 3, §6.4).
pub fn scattered(pixel: usize) -> u64 {
    (pixel as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15)
}

/// The wrong pixels in the scattered order.
fn shuffled(film: &FilmComparison<'_>) -> Vec<usize> {
    let mut pixels: Vec<usize> = (0..film.pixels()).filter(|p| film.is_wrong(*p)).collect();
    pixels.sort_by_key(|pixel| scattered(*pixel));
    pixels
}
