//! How well a known mistake agrees with a film part by part: objects, t, the normal, and its
//! length. Parts matter because another part may be wrong by a second mistake.

use std::collections::{BTreeMap, BTreeSet};

use pinhole::comparison::FilmComparison;
use rayon::prelude::*;

use super::evidence::{Agreement, Evidence};
use super::fingerprint::Fingerprint;

/// A mistake compared with one part of a film, in pixels.
#[derive(Clone, Default)]
struct PartAgreement {
    /// How many pixels the mistake gets wrong, counting only those in which the film lets us see
    /// it.
    predicted: f64,
    /// The pixels of the sample that are wrong in the mistake's own way.
    same: Vec<usize>,
    /// How many pixels each pixel of the sample stands for.
    weight: f64,
    /// How many of the pixels in `predicted` are right in the film.
    absent: f64,
}

/// A film part by part. Making it takes longer than the rest of a diagnosis, so it is made only if
/// no belief explains whole films.
struct FilmParts<'a> {
    /// How many pixels there are.
    pixels: usize,
    /// In how many pixels each part is wrong, counted where it can be compared.
    failing: Vec<f64>,
    /// Whether each part is the length of the part before it.
    lengths: Vec<bool>,
    /// How well each belief that shows in this film agrees. Empty for one that panics.
    agreements: BTreeMap<&'a str, Vec<PartAgreement>>,
}

impl<'a> FilmParts<'a> {
    /// `None` if the film panicked.
    fn of(evidence: &Evidence, candidates: &[&'a str]) -> Option<FilmParts<'a>> {
        let film = evidence.film.as_ref()?;
        let of_print = |print| PartAgreement::of(film, print);
        let shown = candidates
            .iter()
            .filter(|slug| evidence.agreements.contains_key(**slug));
        let agreements = shown.map(|slug| {
            let print = evidence.prints.get(*slug);
            (*slug, print.map(of_print).unwrap_or_default())
        });
        Some(FilmParts {
            pixels: evidence.pixels,
            failing: film.failing_parts(),
            lengths: (0..film.parts()).map(|part| film.is_length(part)).collect(),
            agreements: agreements.collect(),
        })
    }

    /// How well a belief agrees in one part.
    fn part(&self, slug: &str, part: usize) -> PartAgreement {
        let agreements = self.agreements.get(slug);
        let agreement = agreements.and_then(|parts| parts.get(part));
        agreement.cloned().unwrap_or_default()
    }

    /// How many pixels are wrong in a part as one of these beliefs says, and how many are right
    /// although one of them says otherwise.
    fn shared_and_absent(&self, part: usize, beliefs: &[&str]) -> (f64, f64) {
        let mut counted = BTreeSet::new();
        let (mut shared, mut absent) = (0.0, 0.0);
        for belief in beliefs {
            let agreement = self.part(belief, part);
            // Count a pixel that both explain only once.
            let new = agreement
                .same
                .iter()
                .filter(|pixel| counted.insert(**pixel));
            shared += agreement.weight * new.count() as f64;
            absent += agreement.absent;
        }
        (shared, absent)
    }
}

impl PartAgreement {
    /// The agreement of each part, in the film's order of parts.
    fn of(film: &FilmComparison<'_>, print: &Fingerprint) -> Vec<PartAgreement> {
        let weight = print.failing as f64 / print.sample.len().max(1) as f64;
        let of_part = |part: usize| {
            let mut agreement = PartAgreement {
                weight,
                ..PartAgreement::default()
            };
            for witness in print.sample.iter().filter(|it| film.shows_part(part, it)) {
                agreement.predicted += weight;
                match film.is_part_wrong(part, witness.pixel) {
                    false => agreement.absent += weight,
                    true if film.is_part_same(part, witness) => {
                        agreement.same.push(witness.pixel);
                    }
                    true => {}
                }
            }
            agreement
        };
        (0..film.parts()).map(of_part).collect()
    }
}

/// From this agreement on, a film's part counts as explained.
const ENOUGH: f64 = 0.9;

/// Fewer pixels than this share of a film are no evidence for or against a belief.
const FEW: f64 = 0.015;

/// With fewer wrong pixels of a part than this in all films together, there is no evidence
/// either.
const LEAST: f64 = 24.0;

/// If a belief explains several parts, a film may disagree by this many standard errors.
const STANDARD_ERRORS: f64 = 2.5;

/// Whether these beliefs together explain what is wrong in a part of the films: of all films together
/// and of each. A single film may disagree by this many standard errors, because its estimate comes
/// from a sample.
fn explains(films: &[FilmParts], part: usize, beliefs: &[&str], errors: f64) -> bool {
    let is_enough = |pixels: usize, failing: f64, shared: f64, absent: f64, off: f64| {
        let apart = failing - shared.min(failing) + absent;
        apart <= FEW * pixels as f64 || shared.min(failing) + off >= ENOUGH * (failing + absent)
    };
    let (mut pixels, mut sums) = (0, [0.0; 3]);
    let is_whole = |film: &FilmParts| {
        let failing = film.failing.get(part).copied().unwrap_or(0.0);
        let (shared, absent) = film.shared_and_absent(part, beliefs);
        pixels += film.pixels;
        for (sum, count) in sums.iter_mut().zip([failing, shared, absent]) {
            *sum += count;
        }
        // Each pixel of a sample of one in `weight` counts `weight` times, so the variance of the
        // sum is at most (weight − 1) times the sum.
        let weights = beliefs.iter().map(|belief| film.part(belief, part).weight);
        let off = errors * ((weights.fold(1.0, f64::max) - 1.0) * failing).sqrt();
        is_enough(film.pixels, failing, shared, absent, off)
    };
    let each = films.iter().all(is_whole);
    let [failing, shared, absent] = sums;
    each && is_enough(pixels, failing, shared, absent, 0.0)
}

/// How many pixels a belief spoils in a part, in all films.
fn predicted(films: &[FilmParts], part: usize, belief: &str) -> f64 {
    films
        .iter()
        .map(|film| film.part(belief, part).predicted)
        .sum()
}

/// In how many parts a belief explains all errors of every film; 0 if another part contradicts it.
/// A vector and its length count as one. About `errors`, see [`explains`].
fn parts_explained(films: &[FilmParts], parts: usize, belief: &str, errors: f64) -> usize {
    let spoiled = (0..parts).filter(|part| predicted(films, *part, belief) > 0.0);
    let (mut explained, mut length) = (0, false);
    for part in spoiled {
        if explains(films, part, &[belief], errors) {
            let is_length = films.iter().all(|film| film.lengths[part]);
            let is_much = predicted(films, part, belief) >= LEAST;
            length |= is_much && is_length;
            explained += usize::from(is_much && !is_length);
        // The value may be wrong in another way, because a second mistake changed it too.
        } else if !is_touched(films, part, belief) {
            return 0;
        }
    }
    explained.max(length.into())
}

/// Whether something is wrong where a belief gets it right, or the belief gets hardly any hit
/// right. Otherwise, one unknown mistake that shows in the same pixels is likelier than two.
fn leaves_room(films: &[Evidence], belief: &str) -> bool {
    let (mut wrong, mut right) = (0.0, 0.0);
    for evidence in films {
        let Agreement {
            predicted, touched, ..
        } = evidence.agreement(belief);
        let hits = evidence
            .film
            .as_ref()
            .map_or(0, FilmComparison::expected_hits);
        wrong += evidence.failing as f64 - touched;
        right += f64::max(hits as f64 - predicted, 0.0);
    }
    wrong >= LEAST || right < LEAST
}

/// Whether a part is wrong wherever a belief says so, even if it is wrong in another way.
fn is_touched(films: &[FilmParts], part: usize, belief: &str) -> bool {
    films.iter().all(|film| {
        let agreement = film.part(belief, part);
        agreement.absent <= (1.0 - ENOUGH) * agreement.predicted + FEW * film.pixels as f64
    })
}

/// Beliefs that explain whole parts of the films: two that together explain every part, or
/// one. None if several do and the films can't tell them apart.
pub fn partial<'a>(evidence: &[Evidence], candidates: &[&'a str]) -> Option<Vec<&'a str>> {
    // One wrong film is not enough to tell two beliefs apart.
    if evidence.iter().filter(|film| film.failing > 0).count() < 2 {
        return None;
    }
    // A film that panicked has no parts.
    let parted = evidence
        .par_iter()
        .map(|film| FilmParts::of(film, candidates));
    let films: Vec<FilmParts> = parted.collect::<Option<_>>()?;
    let films = films.as_slice();
    let parts = films.iter().map(|film| film.failing.len()).max()?;
    if films.iter().any(|film| film.failing.len() < parts) {
        return None;
    }
    let panics = |belief: &str| {
        let mut shown = films.iter().filter_map(|film| film.agreements.get(belief));
        shown.any(|agreements| agreements.is_empty())
    };
    let shows = |belief: &str| {
        !panics(belief) && (0..parts).any(|part| predicted(films, part, belief) >= LEAST)
    };
    let shown: Vec<&'a str> = candidates.iter().copied().filter(|it| shows(it)).collect();
    let mut pairs: Vec<([&'a str; 2], f64)> = Vec::new();
    for (k, one) in shown.iter().enumerate() {
        for other in &shown[k + 1..] {
            if explain_all(films, parts, one, other) {
                pairs.push(([*one, *other], apart(films, parts, &[one, other])));
            }
        }
    }
    if !pairs.is_empty() {
        return most_likely(pairs);
    }
    // Two explained parts, such as which object is hit and t, hardly agree by chance.
    let is_held = |belief: &str| {
        parts_explained(films, parts, belief, STANDARD_ERRORS) > 1
            || parts_explained(films, parts, belief, 0.0) == 1 && leaves_room(evidence, belief)
    };
    let held: Vec<&'a str> = shown.into_iter().filter(|it| is_held(it)).collect();
    match held.as_slice() {
        [one] => Some(vec![*one]),
        _ => None,
    }
}

/// The pair of beliefs that differs least from the films. If other pairs differ hardly more, only
/// the belief that all of these pairs share, because it is likely whichever pair is the right one.
fn most_likely(mut pairs: Vec<([&str; 2], f64)>) -> Option<Vec<&str>> {
    pairs.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    let (best, least) = *pairs.first()?;
    pairs.retain(|(_, apart)| *apart <= 2.0 * least + LEAST);
    if pairs.len() == 1 {
        return Some(best.to_vec());
    }
    let mut shared = best.into_iter();
    let shared = shared.find(|belief| pairs.iter().all(|(pair, _)| pair.contains(belief)));
    shared.map(|belief| vec![belief])
}

/// Whether two beliefs explain every part of every film, and neither does alone.
fn explain_all(films: &[FilmParts], parts: usize, one: &str, other: &str) -> bool {
    let both = [one, other];
    let is_explained = |part: usize, beliefs: &[&str]| explains(films, part, beliefs, 0.0);
    let mut needs = [false, false];
    let mut explained = false;
    for part in 0..parts {
        let failing: f64 = films.iter().filter_map(|film| film.failing.get(part)).sum();
        let spoils = both.map(|belief| predicted(films, part, belief) >= LEAST);
        if failing == 0.0 && spoils == [false, false] {
            continue;
        }
        if is_explained(part, &both) {
            explained = true;
            needs[0] |= spoils[0] && !is_explained(part, &[other]);
            needs[1] |= spoils[1] && !is_explained(part, &[one]);
        } else if !(spoils == [true, true]
            && is_touched(films, part, one)
            && is_touched(films, part, other))
        {
            return false;
        }
    }
    explained && needs == [true, true]
}

/// Errors that only the films have, or that only the beliefs predict.
fn apart(films: &[FilmParts], parts: usize, beliefs: &[&str]) -> f64 {
    let mut sum = 0.0;
    for film in films {
        for part in 0..parts.min(film.failing.len()) {
            let (shared, absent) = film.shared_and_absent(part, beliefs);
            let failing = film.failing[part];
            sum += failing - f64::min(shared, failing) + absent;
        }
    }
    sum
}
