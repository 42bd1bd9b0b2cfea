//! How well each known mistake agrees with one film.

use std::collections::BTreeMap;
use std::path::Path;

use pinhole::Film;
use pinhole::comparison::FilmComparison;
use pinhole::judge::Golden;

use super::fingerprint::Fingerprint;
use super::known::KnownMistakes;
use crate::error::Result;

/// A film's wrong pixels, and how well each known mistake predicts them.
#[derive(Clone, Debug)]
pub struct Evidence<'a> {
    /// The film beside its golden; `None` if it panicked.
    pub film: Option<FilmComparison<'a>>,
    /// The fingerprints of the mistakes that would show in this film.
    pub prints: BTreeMap<String, Fingerprint>,
    /// How many pixels are wrong.
    pub failing: usize,
    /// How many pixels there are.
    pub pixels: usize,
    /// Whether there are values to compare. A film in which no ray hits anything has none.
    pub has_values: bool,
    /// The agreement of each mistake that would show in this film.
    pub agreements: BTreeMap<String, Agreement>,
}

/// A mistake compared with a film, counted in pixels. The counts are estimated from a
/// sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Agreement {
    /// How many the mistake would get wrong.
    pub predicted: f64,
    /// How many of these are wrong in the film, in any way.
    pub touched: f64,
    /// How many are wrong exactly as the mistake predicts.
    pub shared: f64,
    /// Some pixels distinguish it from similar mistakes. This is how many of these disagree with
    /// it.
    pub denied: f64,
}

impl<'a> Evidence<'a> {
    /// The agreement of the known mistakes with a film; `None` if it cannot be
    /// compared.
    pub fn of(
        name: &str,
        golden: &'a Golden,
        film: &'a Film,
        known: &KnownMistakes,
        folder: &Path,
    ) -> Result<Option<Evidence<'a>>> {
        let Some(compared) = FilmComparison::new(golden, film) else {
            return Ok(None);
        };
        let (failing, pixels) = (compared.failing(), compared.pixels());
        let prints = known.fingerprints(name, golden, folder)?.into_iter();
        let prints: BTreeMap<String, Fingerprint> = prints
            .map(|(slug, print)| (slug.to_owned(), print))
            .collect();
        let mut agreements: BTreeMap<String, Agreement> = prints
            .iter()
            .map(|(slug, print)| (slug.clone(), agreement(&compared, print)))
            .collect();
        // A mistake that panics gives no answers, but this film has answers.
        let panicking = Agreement {
            predicted: pixels as f64,
            touched: failing as f64,
            ..Agreement::default()
        };
        agreements.extend(
            known
                .panicking(name)
                .map(|slug| (slug.clone(), panicking.clone())),
        );
        Ok(Some(Evidence {
            failing,
            pixels,
            has_values: compared.has_values(),
            agreements,
            film: Some(compared),
            prints,
        }))
    }

    /// The agreement of the known mistakes with a panic in a film of `pixels` pixels.
    pub fn of_panic(name: &str, pixels: usize, known: &KnownMistakes) -> Evidence<'a> {
        let all = Agreement {
            predicted: pixels as f64,
            touched: pixels as f64,
            shared: pixels as f64,
            ..Agreement::default()
        };
        let agreements = known
            .panicking(name)
            .map(|slug| (slug.clone(), all.clone()));
        Evidence {
            failing: pixels,
            pixels,
            has_values: false,
            agreements: agreements.collect(),
            film: None,
            prints: BTreeMap::new(),
        }
    }

    /// How well this mistake agrees; all zero if it would not show in the film.
    pub fn agreement(&self, slug: &str) -> Agreement {
        self.agreements.get(slug).cloned().unwrap_or_default()
    }
}

impl Agreement {
    /// How many pixels are wrong only in the film or only by the mistake, or are wrong in
    /// different ways.
    pub fn apart(&self, failing: usize) -> f64 {
        let apart = self.predicted + failing as f64 - 2.0 * self.shared;
        apart.max(self.denied)
    }
}

fn agreement(film: &FilmComparison, print: &Fingerprint) -> Agreement {
    let predicted = print.failing as f64;
    let share = |count: usize| match print.sample.len() {
        0 => 0.0,
        all => predicted * count as f64 / all as f64,
    };
    let sample = print.sample.iter();
    let touched = sample.clone().filter(|at| film.is_wrong(at.pixel)).count();
    let shared = sample.filter(|at| film.shows(at)).count();
    let denied = print.telling.iter().filter(|at| !film.shows(at)).count();
    Agreement {
        predicted,
        touched: share(touched),
        shared: share(shared).min(film.failing() as f64),
        denied: denied as f64,
    }
}
