//! Spheres: |e + t d − c|² = r².

mod adaptive;
mod from_eye;
mod haines;
mod textbook;

pub use adaptive::at_most;
pub use from_eye::SphereFromEye;
pub use haines::{Haines, ScaledRay, plainly};
pub use textbook::Textbook;

use crate::number::Real;

/// The smaller of two roots that are at least `min_t`.
#[inline(always)]
fn first_from<F: Real>(min_t: F, near: F, far: F) -> Option<F> {
    match near >= min_t {
        true => Some(near),
        false => (far >= min_t).then_some(far),
    }
}
