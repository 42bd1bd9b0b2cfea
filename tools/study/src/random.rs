//! Random numbers that are the same on every machine and in every version.

use std::f64::consts::TAU;

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use crate::vector::Vector;

/// SplitMix64 (Steele, Lea & Flood, *OOPSLA* 2014).
#[derive(Clone, Debug)]
pub struct Random(SplitMix64);

impl Random {
    /// Seeds a generator from `seed` and `purpose`, so that families draw independent numbers.
    pub fn new(seed: u64, purpose: &str) -> Random {
        // FNV-1a.
        let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        let seed = purpose.bytes().fold(seed ^ 0xcbf2_9ce4_8422_2325, mix);
        Random(SplitMix64::seed_from_u64(seed))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Uniform from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// −1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// An integer from 0 to `count` − 1.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// A unit vector, uniform on the sphere.
    pub fn unit(&mut self) -> Vector<f64> {
        let (z, angle) = (self.within(-1.0, 1.0), self.within(0.0, TAU));
        let radius = (1.0 - z * z).sqrt();
        Vector::new(radius * angle.cos(), radius * angle.sin(), z)
    }

    /// A unit vector perpendicular to `axis`, which is nearly a unit vector.
    pub fn unit_across(&mut self, axis: Vector<f64>) -> Vector<f64> {
        loop {
            let across = self.unit().cross(axis);
            let length = across.dot(across).sqrt();
            if length > 0.1 {
                return across * (1.0 / length);
            }
        }
    }
}
