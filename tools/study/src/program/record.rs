//! `pinhole-study record`: the long runs.

use pinhole_report::program::Status;
use pinhole_study::judge::rule_of_three;
use pinhole_study::record::record;

use crate::cli::Record;

/// Runs all rounds, and fails if any answer is wrong.
pub fn run(arguments: &Record) -> Status {
    let end = arguments.from + arguments.rounds;
    let (mut from, mut is_well) = (arguments.from, true);
    while from < end {
        // Report every thousand rounds, so that a crash loses at most those.
        let to = end.min(from + 1_000);
        let count = record(arguments.kind, from..to, arguments.seed);
        let (asked, wrong) = (count.asked, count.wrong);
        let bound = match wrong {
            0 => format!("below {:.1e} with 95 % confidence", rule_of_three(asked)),
            _ => format!("in rounds {:?}", count.broken),
        };
        anstream::println!(
            "rounds {from} to {}: {wrong} wrong of {asked} ({bound}); {} hits, {} exact",
            to - 1,
            count.hits,
            count.exact
        );
        is_well &= wrong == 0;
        from = to;
    }
    match is_well {
        true => Status::Well,
        false => Status::JudgedWrong,
    }
}
