//! Two mistakes in one answer, compared with the films pixel by pixel.
//!
//! Where only one of the two shows, the answer has that mistake's value. Where both show, their
//! errors add up, as offsets do, and mistakes about different parts. If one of them leaves a miss
//! there, or the golden has one, the answer has the value of either.

use std::collections::BTreeMap;

use pinhole::comparison::{FilmComparison, Witness};
use rayon::prelude::*;

use super::evidence::Evidence;
use super::fingerprint::{Fingerprint, scattered};
use super::parts::most_likely;

/// A mistake is named only if it explains at least this share of what the other leaves unexplained.
/// The one new false name among all pairs of `pinhole validate --pairs` reached 0.87.
const ENOUGH: f64 = 0.9;

/// Each of the two must explain at least this many pixels that the other alone does not.
const LEAST: usize = 12;

/// Compare a pair in about this many pixels first, evenly taken from all films. Most pairs fail there.
const FIRST: usize = 128;

/// How far apart two factors or errors may be, relative to their size, and still be the same.
const SAME: f64 = 0.01;

/// A film that was cast, and the mistakes that show in it.
struct ShownFilm<'a> {
    film: &'a FilmComparison<'a>,
    prints: &'a BTreeMap<String, Fingerprint>,
    /// The places of its wrong pixels in the scattered order, sorted.
    wrong: Vec<u64>,
}

/// How two mistakes together agree with films, in pixels.
#[derive(Clone, Copy, Debug, Default)]
struct PairAgreement {
    /// How many are wrong or predicted to be wrong.
    compared: usize,
    /// How many of these have the predicted values.
    shared: usize,
    /// How many of these each mistake explains, and the other alone does not.
    needs: [usize; 2],
}

/// The two beliefs that together explain the films pixel by pixel, or the one that all likely
/// pairs share.
pub fn together<'a>(films: &[Evidence], candidates: &[&'a str]) -> Option<Vec<&'a str>> {
    // One wrong film is not enough to tell two beliefs apart.
    if films.iter().filter(|film| film.failing > 0).count() < 2 {
        return None;
    }
    let shows = |slug: &&&str| films.iter().any(|film| film.prints.contains_key(**slug));
    let answers = |slug: &&&str| {
        let mut shown = films
            .iter()
            .filter(|film| film.agreements.contains_key(**slug));
        shown.all(|film| film.prints.contains_key(**slug))
    };
    let candidates = candidates.iter().filter(shows).filter(answers);
    let candidates: Vec<&'a str> = candidates.copied().collect();
    let films: Vec<ShownFilm> = films.iter().map(ShownFilm::new).collect::<Option<_>>()?;
    let pairs = candidates.iter().enumerate();
    let pairs = pairs.flat_map(|(place, one)| {
        let others = candidates[place + 1..].iter();
        others.map(move |other| [*one, *other])
    });
    let pairs: Vec<[&str; 2]> = pairs.collect();
    let agreement = |pair: &[&'a str; 2]| {
        let first = PairAgreement::of(&films, *pair, FIRST.div_ceil(films.len()));
        if first.is_hopeless() {
            return None;
        }
        let agreement = PairAgreement::of(&films, *pair, usize::MAX);
        let needs_both = agreement.needs.iter().all(|needs| *needs >= LEAST);
        needs_both.then_some((*pair, agreement))
    };
    let pairs: Vec<_> = pairs.par_iter().filter_map(agreement).collect();
    let closest = pairs.iter().min_by_key(|(_, agreement)| agreement.apart());
    let (closest, agreement) = *closest?;
    let apart = pairs
        .iter()
        .map(|(pair, agreement)| (*pair, agreement.apart() as f64));
    let mut named = most_likely(apart.collect())?;
    named.retain(|belief| {
        let place = closest.iter().position(|it| it == belief);
        let mut others = candidates.iter().filter(|other| *other != belief);
        place.is_some_and(|place| agreement.explained(place) >= ENOUGH)
            && !others.any(|other| is_multiple(&films, belief, other))
    });
    (!named.is_empty()).then_some(named)
}

/// Whether one mistake's errors are a multiple of the other's, by the same factor in every pixel. A
/// student who makes one of them and scales the answer seems to make the other.
fn is_multiple(films: &[ShownFilm], one: &str, other: &str) -> bool {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let mut factor: Option<f64> = None;
    for shown in films {
        for both in shown.known([one, other], usize::MAX).1.values() {
            let errors = both.map(|witness| shown.film.error(witness?));
            let [Some(one), Some(other)] = errors else {
                return false;
            };
            let own = dot(&one, &other) / dot(&one, &one);
            let rest: Vec<f64> = one.iter().zip(&other).map(|(a, b)| b - own * a).collect();
            let factor = *factor.get_or_insert(own);
            // If a mistake has no error here, the factor is NaN, and neither comparison holds.
            let is_same = (own - factor).abs() <= SAME * factor.abs()
                && dot(&rest, &rest) <= (SAME * SAME) * dot(&other, &other);
            if !is_same {
                return false;
            }
        }
    }
    factor.is_some()
}

impl<'a> ShownFilm<'a> {
    /// `None` if it panicked.
    fn new(evidence: &'a Evidence<'a>) -> Option<ShownFilm<'a>> {
        let film = evidence.film.as_ref()?;
        let wrong = (0..film.pixels()).filter(|pixel| film.is_wrong(*pixel));
        let mut wrong: Vec<u64> = wrong.map(scattered).collect();
        wrong.sort_unstable();
        Some(ShownFilm {
            film,
            prints: &evidence.prints,
            wrong,
        })
    }

    /// The pixels that two mistakes get wrong, with what each leaves there, up to the place in the
    /// scattered order to which both are known by at most this many witnesses of each.
    fn known(
        &self,
        pair: [&str; 2],
        most: usize,
    ) -> (u64, BTreeMap<usize, [Option<&'a Witness>; 2]>) {
        let prints = pair.map(|slug| self.prints.get(slug));
        let known_to = prints.iter().flatten().map(|print| print.known_to(most));
        let known_to = known_to.min().unwrap_or(u64::MAX);
        let mut pixels: BTreeMap<usize, [Option<&Witness>; 2]> = BTreeMap::new();
        for (place, print) in prints.into_iter().enumerate() {
            let sample = print.into_iter().flat_map(|print| &print.sample).take(most);
            for witness in sample.filter(|witness| scattered(witness.pixel) <= known_to) {
                pixels.entry(witness.pixel).or_default()[place] = Some(witness);
            }
        }
        (known_to, pixels)
    }
}

impl PairAgreement {
    fn of(films: &[ShownFilm], pair: [&str; 2], most: usize) -> PairAgreement {
        let mut sum = PairAgreement::default();
        for film in films {
            sum.add(film, pair, most);
        }
        sum
    }

    /// Adds the pixels of a film for which it is known what both mistakes leave there.
    fn add(&mut self, shown: &ShownFilm, pair: [&str; 2], most: usize) {
        let film = shown.film;
        let (known_to, pixels) = shown.known(pair, most);
        let wrong = shown.wrong.partition_point(|place| *place <= known_to);
        let predicted = pixels.keys().filter(|pixel| film.is_wrong(**pixel));
        self.compared += pixels.len() + wrong - predicted.count();
        for both in pixels.values() {
            let [one, other] = both.map(|it| it.is_some_and(|it| film.shows(it)));
            let sum = match both {
                [Some(one), Some(other)] => film.sum(one, other),
                _ => None,
            };
            if sum.map_or(one || other, |sum| film.shows(&sum)) {
                self.shared += 1;
                self.needs[0] += usize::from(!other);
                self.needs[1] += usize::from(!one);
            }
        }
    }

    /// Of what one mistake leaves unexplained, the share that the other explains.
    fn explained(&self, place: usize) -> f64 {
        let needs = self.needs[place];
        needs as f64 / (needs + self.apart()) as f64
    }

    /// Whether so much disagrees that the rest can't make up for it. If few pixels are known, all
    /// of them count, because then a distant pair may still make a close one doubtful.
    fn is_hopeless(&self) -> bool {
        self.apart() > FIRST / 2 - LEAST && 2 * self.apart() > self.compared
    }

    fn apart(&self) -> usize {
        self.compared - self.shared
    }
}
