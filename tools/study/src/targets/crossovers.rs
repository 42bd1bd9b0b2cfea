//! The crossovers that plans rely on, beside those measured now.

use crate::plan::crossover::boxes_from;
use crate::plan::{Kind, Numbers};
use crate::result::{CrossoverTally, Target};

pub fn targets(tallies: &[CrossoverTally]) -> Vec<Target> {
    let mut targets = Vec::new();
    for kind in [Kind::Sphere, Kind::Triangle] {
        for numbers in [Numbers::F32, Numbers::F64, Numbers::Exact] {
            let of_it = || {
                tallies
                    .iter()
                    .filter(|t| t.shape == kind.name() && t.numbers == numbers.name())
            };
            let Some(most) = of_it().map(|tally| tally.parts).max() else {
                continue;
            };
            // The last count at which boxes do not pay: single counts may be noise.
            let last = of_it()
                .filter(|tally| tally.boxes >= tally.brute_force)
                .map(|tally| tally.parts)
                .max();
            let (kept, last) = (boxes_from(kind, numbers) as f64, last.unwrap_or(0));
            targets.push(Target {
                about: format!("{} in {}: boxes pay from", kind.name(), numbers.name()),
                expected: format!("{kept} parts"),
                measured: match last == most {
                    true => format!("more than {most} parts"),
                    false => format!("more than {last} parts"),
                },
                met: (kept / 2.5..=kept * 2.5).contains(&(last as f64).max(1.0)),
                is_time: true,
            });
        }
    }
    targets
}
