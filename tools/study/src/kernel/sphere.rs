//! Spheres: |e + t d − c|² = r².

mod adaptive;
mod bounded;
mod double_double;
mod fma;
mod haines;
mod haines_scaled;
mod half_b;
mod stable_q;
mod textbook;

pub use adaptive::{Adaptive, exact, filtered};
pub use bounded::{bounded, limits};
pub use double_double::DoubleDouble;
pub use fma::Fma;
pub use haines::Haines;
pub use haines_scaled::{HainesScaled, Scaled};
pub use half_b::HalfB;
pub use stable_q::StableQ;
pub use textbook::Textbook;

use crate::number::Real;

/// The smaller of two roots that is not before `min_t`.
#[inline(always)]
fn first_from<F: Real>(min_t: F, near: F, far: F) -> Option<F> {
    match near >= min_t {
        true => Some(near),
        false => (far >= min_t).then_some(far),
    }
}
