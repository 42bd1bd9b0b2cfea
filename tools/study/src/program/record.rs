//! `pinhole-study record`: the long runs.

use pinhole_report::program::Status;
use pinhole_study::judge::rule_of_three;
use pinhole_study::record::{Count, record};

use crate::cli::Record;

/// Runs all rounds, and fails if any answer is wrong.
pub fn run(arguments: &Record) -> Status {
    let Record {
        kind,
        from,
        rounds,
        seed,
    } = *arguments;
    let end = from + rounds;
    let (mut from, mut is_well) = (from, true);
    while from < end {
        // Report every thousand rounds, so that a crash loses at most those.
        let to = end.min(from + 1_000);
        let Count {
            asked,
            hits,
            exact,
            wrong,
            broken,
        } = record(kind, from..to, seed);
        let bound = match wrong {
            0 => format!("below {:.1e} with 95 % confidence", rule_of_three(asked)),
            _ => format!("in rounds {broken:?}"),
        };
        anstream::println!(
            "rounds {from} to {}: {wrong} wrong of {asked} ({bound}); {hits} hits, {exact} exact",
            to - 1
        );
        is_well &= wrong == 0;
        from = to;
    }
    match is_well {
        true => Status::Well,
        false => Status::JudgedWrong,
    }
}
