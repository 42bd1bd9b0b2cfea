//! The Pareto front: the ways to cast a scene that no other way beats (Pareto, *Manuale
//! di economia politica*, 1906, has the idea; who is not on it is not worth choosing).

use crate::result::SceneTally;

/// Marks the front among all tallies of one scene. What has no time, a golden film, does
/// not take part.
pub fn mark(tallies: &mut [SceneTally]) {
    let all: Vec<Option<[f64; 4]>> = tallies.iter().map(faults).collect();
    for (tally, own) in tallies.iter_mut().zip(&all) {
        let beats = |other: &[f64; 4]| own.is_some_and(|own| beats(other, &own));
        tally.on_front = own.is_some() && !all.iter().flatten().any(beats);
    }
}

/// What is to be small: time, wrong objects, the largest errors of t and of the normal.
fn faults(tally: &SceneTally) -> Option<[f64; 4]> {
    let error = |error: Option<f64>| error.unwrap_or(0.0);
    Some([
        tally.nanoseconds?,
        tally.wrong_ids as f64,
        error(tally.worst_t),
        error(tally.worst_normal),
    ])
}

/// Nowhere worse, and better somewhere.
fn beats(one: &[f64; 4], other: &[f64; 4]) -> bool {
    let both = || one.iter().zip(other);
    both().all(|(one, other)| one <= other) && both().any(|(one, other)| one < other)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tally(nanoseconds: Option<f64>, wrong_ids: u64, error: f64) -> SceneTally {
        SceneTally {
            nanoseconds,
            wrong_ids,
            worst_t: Some(error),
            worst_normal: Some(error),
            ..SceneTally::default()
        }
    }

    #[test]
    fn the_front_is_who_nobody_beats() {
        let mut tallies = [
            tally(Some(10.0), 1, 1e-3),
            tally(Some(20.0), 1, 1e-3), // slower, and no better
            tally(Some(20.0), 0, 1e-3),
            tally(Some(30.0), 0, 1e-9),
            tally(Some(30.0), 0, 1e-9), // as good: both are on it
            tally(Some(40.0), 1, 1e-9),
            tally(None, 0, 0.0), // a golden film
        ];
        mark(&mut tallies);
        let front = tallies.map(|tally| tally.on_front);
        assert_eq!(front, [true, false, true, true, true, false, false]);
    }
}
