//! Planes: (e + t d − p) · n = 0.

mod adaptive;
mod bounded;
mod shifted;

pub use adaptive::{Adaptive, exact, filtered};
pub use bounded::{bounded, limits};
pub use shifted::Shifted;
