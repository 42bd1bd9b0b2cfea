//! One mistake or two in an answer, compared with the films pixel by pixel.
//!
//! Where only one of two mistakes shows, the answer has that mistake's value. Where both show, the
//! answer may have the value of either, or their errors may add up, as offsets do. If it has any
//! other value there, that says nothing about the two. We name the mistakes that leave the least
//! unexplained, if every explanation without them leaves much more unexplained.

use std::collections::BTreeMap;

use pinhole::comparison::{FilmComparison, Witness};
use rayon::prelude::*;

use super::evidence::Evidence;
use super::fingerprint::{Fingerprint, scattered};

/// The best explanation must explain at least this share of the pixels that count. This limit and
/// the next two were chosen with the pairs of `pinhole validate --pairs`.
const ENOUGH: f64 = 0.85;

/// Each mistake in an explanation costs as much as this many unexplained pixels. If there are two,
/// each must explain at least this many pixels that the other does not.
const LEAST: usize = 12;

/// A mistake is named only if every explanation without it costs at least this many times as much,
/// plus the cost of two mistakes.
const DEARER: f64 = 2.0;

/// How far apart two factors or errors may be, relative to their size, and still be the same.
const SAME: f64 = 0.01;

/// A film that was cast, and the mistakes that show in it.
struct ShownFilm<'a> {
    film: &'a FilmComparison<'a>,
    prints: &'a BTreeMap<String, Fingerprint>,
    /// The places of its wrong pixels in the scattered order, sorted.
    wrong: Vec<u64>,
}

/// What each of two mistakes leaves in a pixel, if it shows there.
type PixelWitnesses<'a> = [Option<&'a Witness>; 2];

/// One mistake, or two, that may explain the films, and how many pixels it explains.
struct Explanation<'a> {
    mistakes: Vec<&'a str>,
    /// How many pixels are ignored, because both mistakes show there and the answer has another
    /// wrong value.
    ignored: usize,
    /// How many others are wrong or predicted to be wrong. These count.
    counted: usize,
    /// How many of these have a predicted value.
    explained: usize,
    /// How many of these each mistake explains, and the other alone does not.
    needs: Vec<usize>,
}

/// The one or two beliefs that explain the films pixel by pixel, if every explanation without them
/// is much worse.
pub fn likely<'a>(films: &[Evidence], candidates: &[&'a str]) -> Option<Vec<&'a str>> {
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
    let sets = candidates.iter().enumerate().flat_map(|(place, one)| {
        let others = candidates[place + 1..].iter();
        let pairs = others.map(|other| vec![*one, *other]);
        std::iter::once(vec![*one]).chain(pairs)
    });
    let sets: Vec<Vec<&str>> = sets.collect();
    let explanations = sets.into_par_iter().map(|set| Explanation::of(&films, set));
    let explanations: Vec<Explanation> = explanations
        .filter(|it| it.needs.iter().all(|needs| *needs >= LEAST))
        .collect();
    let best = explanations.iter().min_by_key(|it| it.cost())?;
    let explained = best.explained as f64;
    if explained < ENOUGH * best.counted as f64 || explained < 2.0 * best.ignored as f64 {
        return None;
    }
    let is_dearer_without = |belief: &str| {
        let limit = DEARER * best.cost() as f64 + 2.0 * LEAST as f64;
        let mut without = explanations
            .iter()
            .filter(|it| !it.mistakes.contains(&belief));
        let mut others = candidates.iter().filter(|other| **other != belief);
        without.all(|it| it.cost() as f64 >= limit)
            && !others.any(|other| is_multiple(&films, belief, other))
    };
    let mut named = best.mistakes.clone();
    named.retain(|belief| is_dearer_without(belief));
    Some(named)
}

/// Whether one mistake's errors are a multiple of the other's, by the same factor in every pixel. A
/// student who makes one of them and scales the answer seems to make the other.
fn is_multiple(films: &[ShownFilm], one: &str, other: &str) -> bool {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let mut factor: Option<f64> = None;
    for shown in films {
        for (_, both) in shown.known(&[one, other]).1 {
            let [Some(one), Some(other)] = both.map(|witness| shown.film.error(witness?)) else {
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

    /// The pixels that these mistakes get wrong, in the scattered order, with what each leaves
    /// there, and the place up to which all are known.
    fn known(&self, mistakes: &[&str]) -> (u64, Vec<(usize, PixelWitnesses<'a>)>) {
        let prints = mistakes.iter().map(|slug| self.prints.get(*slug));
        let known_to = prints.clone().flatten().map(Fingerprint::known_to);
        let known_to = known_to.min().unwrap_or(u64::MAX);
        let mut samples: [&[Witness]; 2] = [&[]; 2];
        for (sample, print) in samples.iter_mut().zip(prints) {
            *sample = print.map_or(&[], |print| &print.sample);
        }
        let mut pixels = Vec::new();
        loop {
            let firsts = samples
                .iter()
                .filter_map(|sample| Some(sample.first()?.pixel));
            match firsts.min_by_key(|pixel| scattered(*pixel)) {
                Some(pixel) if scattered(pixel) <= known_to => {
                    let is_here = |witness: &&Witness| witness.pixel == pixel;
                    let left = samples.each_mut().map(|sample| {
                        sample.first().filter(is_here)?;
                        sample.split_off_first()
                    });
                    pixels.push((pixel, left));
                }
                _ => return (known_to, pixels),
            }
        }
    }
}

impl<'a> Explanation<'a> {
    fn of(films: &[ShownFilm], mistakes: Vec<&'a str>) -> Explanation<'a> {
        let mut explanation = Explanation {
            ignored: 0,
            counted: 0,
            explained: 0,
            needs: vec![0; mistakes.len()],
            mistakes,
        };
        for film in films {
            explanation.add(film);
        }
        explanation
    }

    /// Adds the pixels of a film for which it is known what every mistake leaves there.
    fn add(&mut self, shown: &ShownFilm) {
        let film = shown.film;
        let (known_to, pixels) = shown.known(&self.mistakes);
        let wrong = shown.wrong.partition_point(|place| *place <= known_to);
        let predicted = pixels.iter().filter(|(pixel, _)| film.is_wrong(*pixel));
        self.counted += wrong - predicted.count();
        for (pixel, left) in &pixels {
            let shows = |left: &Option<&Witness>| left.is_some_and(|left| film.shows(left));
            let sum = match left {
                [Some(one), Some(other)] => film.sum(one, other),
                _ => None,
            };
            let is_sum = sum.is_some_and(|sum| film.shows(&sum));
            let is_explained = is_sum || left.iter().any(shows);
            let both_show = left.iter().all(Option::is_some);
            if both_show && !is_explained && film.is_wrong(*pixel) {
                self.ignored += 1;
                continue;
            }
            self.counted += 1;
            self.explained += usize::from(is_explained);
            for (place, needs) in self.needs.iter_mut().enumerate() {
                let mut others = left.iter().enumerate().filter(|(other, _)| *other != place);
                let is_own = is_sum || shows(&left[place]);
                *needs += usize::from(is_own && !others.any(|(_, left)| shows(left)));
            }
        }
    }

    /// How much it leaves unexplained, and how many mistakes it takes.
    fn cost(&self) -> usize {
        self.counted - self.explained + LEAST * self.mistakes.len()
    }
}
