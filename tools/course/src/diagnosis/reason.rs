//! Names the belief that the evidence supports, if one does.
//!
//! A belief is named only if it predicts nearly everything that is wrong in every film, and
//! little else. Agreement is the Jaccard index of the two sets of wrong pixels, where pixels that
//! are wrong in different ways count as different.

use super::evidence::Evidence;
use super::known::KnownMistakes;
use super::{Diagnosis, Explanation, Reading, parts, pixels};

/// With less agreement than this, no belief is named. Rewrites of known mistakes agree to 0.95
/// and more (`pinhole validate` measures it), while a coincidence rarely exceeds one half.
const ENOUGH: f64 = 0.9;

/// The limit if no film has any values. Any mistake that misses most hits would agree with such
/// films.
const EXACT: f64 = 0.99;

/// If a smaller share of a film's pixels than this disagrees, rounding may be the reason.
const FEW: f64 = 0.01;

/// A belief is held in one branch of the code only if, for each right film in which it would show,
/// there are at least this many wrong ones.
const BRANCH: usize = 4;

/// If more beliefs than this are possible, none is named, because a long list is no help.
const MOST_ALIKE: usize = 3;

impl KnownMistakes {
    /// The belief that explains these films, which belong to one task or show scenes.
    ///
    /// `is_candidate` tells which mistakes to consider.
    pub fn explain(&self, films: &[Evidence], is_candidate: &dyn Fn(&str) -> bool) -> Diagnosis {
        if films.iter().all(|film| film.failing == 0) {
            return Diagnosis::default();
        }
        let has_values = films.iter().any(|film| film.has_values);
        let candidates: Vec<&str> = self
            .mistake
            .keys()
            .map(String::as_str)
            .filter(|slug| is_candidate(slug))
            .collect();
        let mut alone: Vec<(&str, Sum)> = candidates
            .iter()
            .map(|slug| (*slug, Sum::of(films, slug)))
            .filter(|(slug, _)| films.iter().all(|film| explains(slug, film)))
            .filter(|(_, sum)| has_values || sum.agreement() >= EXACT)
            .collect();
        alone.sort_by(|(_, a), (_, b)| a.apart.total_cmp(&b.apart));
        if let Some((_, best)) = alone.first().copied() {
            alone.retain(|(_, sum)| sum.is_like(&best));
            let beliefs: Vec<Explanation> = alone
                .iter()
                .filter_map(|(slug, sum)| self.explanation(slug, sum.explained()))
                .collect();
            return match beliefs.len() {
                1 => Diagnosis::of(beliefs, Reading::Together),
                2..=MOST_ALIKE => Diagnosis::of(beliefs, Reading::OneOf),
                _ => Diagnosis::default(),
            };
        }
        if !has_values {
            return Diagnosis::default();
        }
        let held = parts::partial(films, &candidates)
            .or_else(|| pixels::likely(films, &candidates))
            .or_else(|| in_one_branch(films, &candidates));
        let explained = |slug: &str| Sum::of(films, slug).explained();
        let held = held.unwrap_or_default().into_iter();
        let beliefs = held.filter_map(|slug| self.explanation(slug, explained(slug)));
        Diagnosis::of(beliefs.collect(), Reading::Together)
    }

    /// A belief, and how much it explains of these films, even if other things are wrong too.
    pub fn explanation_of(&self, slug: &str, films: &[Evidence]) -> Option<Explanation> {
        self.explanation(slug, Sum::of(films, slug).explained())
    }

    fn explanation(&self, slug: &str, explained: f64) -> Option<Explanation> {
        let mistake = self.mistake.get(slug)?.clone();
        Some(Explanation {
            slug: slug.into(),
            mistake,
            explained,
        })
    }
}

/// The only belief that predicts all that is wrong, if it shows in few other films. Code has
/// branches, such as that for orthographic cameras, and the student holds the belief in one only.
fn in_one_branch<'a>(films: &[Evidence], candidates: &[&'a str]) -> Option<Vec<&'a str>> {
    let (wrong, right): (Vec<&Evidence>, Vec<&Evidence>) =
        films.iter().partition(|film| film.failing > 0);
    let shows = |slug: &str, film: &Evidence| film.agreement(slug).predicted > 0.0;
    let holds = |slug: &str| {
        let others = right.iter().filter(|film| shows(slug, film)).count();
        others * BRANCH <= wrong.len() && Sum::of(wrong.iter().copied(), slug).agreement() >= EXACT
    };
    let mut held = candidates.iter().copied().filter(|slug| holds(slug));
    let only = held.next()?;
    held.next().is_none().then(|| vec![only])
}

/// Whether a belief predicts a whole film, its right pixels and its wrong ones.
fn explains(slug: &str, film: &Evidence) -> bool {
    let sum = Sum::of([film], slug);
    sum.agreement() >= ENOUGH || sum.apart <= FEW
}

/// Sums over films, each counted as a share of its pixels, so that a large film does not
/// outweigh many small ones.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    /// What is wrong in the films.
    failing: f64,
    /// What is wrong and has the values that the belief predicts.
    shared: f64,
    /// What the belief predicts to be wrong, but is right.
    absent: f64,
    /// What is wrong only in the films, wrong only by the belief, or wrong in different ways.
    apart: f64,
    /// The sum for a single pixel of each film.
    grain: f64,
}

impl Sum {
    fn of<'a>(films: impl IntoIterator<Item = &'a Evidence<'a>>, belief: &str) -> Sum {
        let mut sum = Sum::default();
        for film in films {
            let share = 1.0 / film.pixels.max(1) as f64;
            let failing = film.failing as f64;
            let agreement = film.agreement(belief);
            sum.failing += share * failing;
            sum.shared += share * agreement.shared.min(failing);
            sum.absent += share * (agreement.predicted - agreement.touched);
            sum.apart += share * agreement.apart(film.failing);
            sum.grain = sum.grain.max(share);
        }
        sum
    }

    /// 1 if the belief predicts exactly what is wrong, 0 if it predicts none of it.
    fn agreement(&self) -> f64 {
        // Pixels that are predicted, but wrong in another way, are counted in `failing`
        // already.
        self.shared / (self.failing + self.absent).max(f64::MIN_POSITIVE)
    }

    fn explained(&self) -> f64 {
        self.shared / self.failing.max(f64::MIN_POSITIVE)
    }

    /// Whether this is hardly farther from the films than the best.
    fn is_like(&self, best: &Sum) -> bool {
        self.apart <= 2.0 * best.apart + 1.5 * best.grain
    }
}
