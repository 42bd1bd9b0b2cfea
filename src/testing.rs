//! What several test modules need: files to read, and random numbers.

use std::fs;
use std::path::PathBuf;

use glam::DVec3;
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use tempfile::TempDir;

use crate::camera::Resolution;
use crate::film::{Channel, Film};

/// Random numbers that are the same in every run, so that a failure can be seen again.
pub(crate) struct Random(SplitMix64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(SplitMix64::seed_from_u64(seed))
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// From 0 to `end`, exclusive.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// One of these.
    pub(crate) fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }

    /// Uniform from −1 to 1.
    pub(crate) fn coordinate(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// A vector in some direction, from a thousandth of a unit to a thousand units long.
    pub(crate) fn vector(&mut self) -> DVec3 {
        let size = 10f64.powf(3.0 * self.coordinate());
        let mut vector = DVec3::ZERO;
        while vector.length() < 0.1 {
            vector = DVec3::new(self.coordinate(), self.coordinate(), self.coordinate());
        }
        size * vector.normalize()
    }

    /// Any bytes at all.
    pub(crate) fn bytes(&mut self, count: usize) -> Vec<u8> {
        (0..count).map(|_| self.bits() as u8).collect()
    }
}

/// A file of this name and content in a folder that lives as long as the first value.
pub(crate) fn file(name: &str, content: impl AsRef<[u8]>) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    let path = folder.path().join(name);
    fs::write(&path, content).expect("a file in it");
    (folder, path)
}

/// A film of one row with these channels.
pub(crate) fn row(channels: &[(&str, &[f32])]) -> Film {
    grid(
        channels.first().map_or(0, |(_, samples)| samples.len()),
        channels,
    )
}

/// A film of `n_x` columns with these channels.
pub(crate) fn grid(n_x: usize, channels: &[(&str, &[f32])]) -> Film {
    let pixels = channels.first().map_or(0, |(_, samples)| samples.len());
    let resolution = Resolution {
        n_x,
        n_y: pixels / n_x,
    };
    let channel = |(name, samples): &(&str, &[f32])| Channel {
        name: (*name).into(),
        samples: samples.to_vec(),
    };
    Film::new(resolution, channels.iter().map(channel).collect())
}
