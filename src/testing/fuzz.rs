//! Fuzzing: valid inputs, spoilt at random, for as long as you like.
//!
//! `PINHOLE_FUZZ_SECONDS` says how long each parser is tried. The clock seeds the random numbers,
//! so that every run tries something new. An input that does harm is kept as a file.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant, SystemTime};

use super::Random;

/// If this process uses more memory, a parser has accepted a length that it should have refused.
const MOST_MEMORY: u64 = 1 << 30;

/// Numbers that often break programs, as bytes of a file.
const EDGES: [&[u8]; 7] = [
    &[0],
    &[255, 255, 255, 255],
    &[255, 255, 255, 127],
    &[0, 0, 0, 128],
    &[255; 8],
    &[0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 1],
    &[0, 0, 0xc0, 0x7f],
];

/// Gives `parse` one spoilt input after another, made from `seeds` and `words`.
///
/// # Panics
/// If `parse` panics, or makes this process grow beyond bounds.
#[track_caller]
pub(crate) fn fuzz(name: &str, seeds: &[Vec<u8>], words: &[&[u8]], parse: impl Fn(&[u8])) {
    let seconds = std::env::var("PINHOLE_FUZZ_SECONDS").map(|text| text.parse::<u64>());
    let seconds = seconds.map_or(1, |seconds| seconds.expect("a number of seconds"));
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    let mut random = Random::new(now.expect("later than 1970").as_nanos() as u64);
    let start = Instant::now();
    let mut tried = 0_u64;
    while start.elapsed() < Duration::from_secs(seconds) {
        let input = spoilt(&mut random, seeds, words);
        let before = Instant::now();
        let parsed = catch_unwind(AssertUnwindSafe(|| parse(&input)));
        let harm = match parsed {
            Err(_) => "a panic",
            Ok(()) if before.elapsed() > Duration::from_secs(10) => "10 seconds",
            Ok(()) if peak_memory() > MOST_MEMORY => "a gigabyte of memory",
            Ok(()) => {
                tried += 1;
                continue;
            }
        };
        let kept = std::env::temp_dir().join(format!("pinhole-fuzz-{name}"));
        fs::write(&kept, &input).expect("it can be kept");
        panic!(
            "{harm}, after {tried} inputs, by the one in {}",
            kept.display()
        );
    }
    println!(
        "{name}: {tried} inputs in {seconds} s, {} MiB at most",
        peak_memory() >> 20
    );
}

/// A valid input with a few changes; sometimes none.
fn spoilt(random: &mut Random, seeds: &[Vec<u8>], words: &[&[u8]]) -> Vec<u8> {
    let mut bytes = random.one_of(seeds).clone();
    for _ in 0..random.below(8) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(64)).min(bytes.len());
        match random.below(8) {
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            1 if at < bytes.len() => bytes[at] = random.bits() as u8,
            2 => drop(bytes.drain(at..end)),
            3 => {
                let again = bytes[at..end].to_vec();
                bytes.splice(at..at, again);
            }
            4 => bytes.truncate(at),
            5 => {
                let other = random.one_of(seeds);
                let from = random.below(other.len() + 1);
                let to = (from + random.below(256)).min(other.len());
                bytes.splice(at..at, other[from..to].iter().copied());
            }
            6 if !words.is_empty() => {
                let word = random.one_of(words).to_vec();
                let end = (at + random.below(2) * word.len()).min(bytes.len());
                bytes.splice(at..end, word);
            }
            _ => {
                let edge = *random.one_of(&EDGES);
                let end = (at + edge.len()).min(bytes.len());
                bytes.splice(at..end, edge.iter().copied());
            }
        }
    }
    bytes
}

/// The most memory that this process has used so far, in bytes; 0 where the system doesn't report
/// it.
fn peak_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().split(' ').next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) << 10
}
