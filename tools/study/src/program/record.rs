//! The long runs.

use std::io::Write;

use indicatif::{ProgressBar, ProgressStyle};
use pinhole_report::program::Status;
use pinhole_study::judge::rule_of_three;
use pinhole_study::record::{self, Count, Hardness, Leaks, Plans};

use crate::cli::Record;

/// Whether nothing was wrong.
pub fn run(arguments: &Record) -> Status {
    let Record {
        random,
        adversarial,
        edges,
        plans,
        seed,
    } = *arguments;
    let mut is_well = true;
    for (name, hardness, count) in [
        ("random", Hardness::Random, random),
        ("adversarial", Hardness::Adversarial, adversarial),
    ] {
        is_well &= count == 0 || decisions(name, hardness, count, seed);
    }
    is_well &= edges == 0 || leaks(edges, seed);
    is_well &= plans == 0 || fuzzed(plans, seed);
    say("camera rays, as computed and as rounded once (apart from all above):");
    for camera in record::cameras() {
        say(&format!(
            "{}: up to {:.1e} rad and {:.1e} of the origin apart; {} of {} pixels change",
            camera.scene, camera.angle, camera.origin, camera.changed, camera.pixels
        ));
    }
    match is_well {
        true => Status::Well,
        false => Status::JudgedWrong,
    }
}

fn decisions(name: &str, hardness: Hardness, count: u64, seed: u64) -> bool {
    let bar = bar(name, count);
    let Count { asked, wrong } = record::decisions(hardness, count, seed, &|n| bar.inc(n));
    bar.finish_and_clear();
    say(&format!(
        "{name}: {wrong} wrong decisions in {asked}{}",
        bound(wrong, asked)
    ));
    wrong == 0
}

fn leaks(edges: u64, seed: u64) -> bool {
    let bar = bar("edges and vertices", 2 * edges);
    let Leaks {
        rays,
        leaks,
        fallbacks,
    } = record::leaks(edges, seed, &|n| bar.inc(n));
    bar.finish_and_clear();
    say(&format!(
        "edges and vertices: {leaks} leaks in {rays} rays{}; {fallbacks} tests were decided in \
         exact numbers",
        bound(leaks, rays)
    ));
    leaks == 0
}

fn fuzzed(count: u64, seed: u64) -> bool {
    let bar = bar("plans", count);
    let Plans {
        plans,
        pixels,
        hits,
        exact_hits,
        broken,
    } = record::plans(count, seed, &|n| bar.inc(n));
    bar.finish_and_clear();
    let named = match broken.is_empty() {
        true => String::new(),
        false => format!(", by number {broken:?}"),
    };
    say(&format!(
        "plans: {} of {plans} broken{named}{}; {hits} of {pixels} pixels are hits, {exact_hits} \
         computed exactly",
        broken.len(),
        bound(broken.len() as u64, plans)
    ));
    broken.is_empty()
}

/// A line as soon as it is known. Whoever stops reading wants no more, and a long run does
/// not end for that.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// How far a long run is, for who looks at it.
fn bar(name: &str, count: u64) -> ProgressBar {
    let style = "{msg}: {human_pos} of {human_len}, {eta} to go";
    let style = ProgressStyle::with_template(style).expect("it is well-formed");
    ProgressBar::new(count)
        .with_style(style)
        .with_message(name.to_owned())
}

/// What a count of 0 says of the rate.
fn bound(wrong: u64, asked: u64) -> String {
    match wrong {
        0 => format!(" (below {:.1e} with 95 % confidence)", rule_of_three(asked)),
        _ => String::new(),
    }
}
