//! The long runs.

use pinhole_report::program::Status;
use pinhole_study::judge::rule_of_three;
use pinhole_study::record::{self, Count, record};

use crate::cli::{Kind, Record};

/// Whether nothing was wrong.
pub fn run(arguments: &Record) -> Status {
    let kind = match arguments.kind {
        Kind::Random => record::Kind::Random,
        Kind::Adversarial => record::Kind::Adversarial,
        Kind::Edges => record::Kind::Edges,
        Kind::Plans => record::Kind::Plans,
    };
    let end = arguments.from + arguments.rounds;
    let (mut from, mut is_well) = (arguments.from, true);
    while from < end {
        // As many as a crash may cost.
        let to = end.min(from + 1_000);
        let Count {
            asked,
            hits,
            exact,
            wrong,
            broken,
        } = record(kind, from..to, arguments.seed);
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
