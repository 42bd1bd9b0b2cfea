//! How the steps of an answer were taken, such as the branches of a tree.

use pinhole::part::Tally;

use super::claim::Claim;
use super::sample::QuestionsAndAnswers;
use super::{Finding, LEAST, Measurement};

/// Steps that are fewer than this share of all are not worth a sentence.
const LEAST_SHARE: f64 = 0.01;

/// The most sentences about steps.
const MOST_SAID: usize = 2;

/// The sentences about steps that may explain a wrong part, or that are too many.
pub fn found(films: &[QuestionsAndAnswers<'_>], wrong: &[&str]) -> Vec<Measurement> {
    let sums = sum(films).into_iter().enumerate();
    let told = sums.filter(|(_, sum)| {
        sum.some >= LEAST
            && share(sum) >= LEAST_SHARE
            && sum.explains.is_none_or(|part| wrong.contains(&part))
    });
    let mut told: Vec<(usize, Tally)> = told.collect();
    told.sort_by(|(_, a), (_, b)| share(b).total_cmp(&share(a)));
    told.truncate(MOST_SAID);
    let measured = told.into_iter().map(|(tally, sum)| Measurement {
        finding: Finding {
            about: sum.steps.into(),
            says: format!("Of {} {}, {} {}.", sum.all, sum.steps, sum.some, sum.sort),
            is_law: true,
        },
        claim: Claim::Steps {
            tally,
            share: share(&sum),
        },
    });
    measured.collect()
}

/// The tallies of all answers, added up.
pub fn sum(films: &[QuestionsAndAnswers<'_>]) -> Vec<Tally> {
    let mut sums: Vec<Tally> = Vec::new();
    for tallies in films.iter().flat_map(|film| film.tallies) {
        if sums.is_empty() {
            sums.clone_from(tallies);
            continue;
        }
        for (sum, tally) in sums.iter_mut().zip(tallies) {
            sum.some += tally.some;
            sum.all += tally.all;
        }
    }
    sums
}

/// Whether roughly this share of the steps is of the sort that is counted.
pub fn is_about(sum: &Tally, expected: f64) -> bool {
    let share = share(sum);
    share <= 2.0 * expected && expected <= 2.0 * share
}

fn share(sum: &Tally) -> f64 {
    sum.some as f64 / sum.all.max(1) as f64
}
