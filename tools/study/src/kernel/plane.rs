//! Planes: (e + t d − p) · n = 0.

mod adaptive;
mod bounded;
mod epsilon_cut;
mod plain;
mod shifted;

pub use adaptive::{Adaptive, exact, filtered};
pub use bounded::{bounded, limits};
pub use epsilon_cut::EpsilonCut;
pub use plain::Plain;
pub use shifted::Shifted;
