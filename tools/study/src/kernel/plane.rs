//! Planes: (e + t d − p) · n = 0.

mod adaptive;
mod shifted_origin;

pub use adaptive::{Adaptive, at_height, decided, exact, filtered, limits};
pub use shifted_origin::ShiftedOrigin;
