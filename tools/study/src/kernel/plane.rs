//! Planes: (e + t d − p) · n = 0.

mod adaptive;
mod shifted;

pub use adaptive::{Adaptive, decided, exact, filtered, limits};
pub use shifted::ShiftedOrigin;
