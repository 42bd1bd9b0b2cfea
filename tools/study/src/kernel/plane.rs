//! Planes: (e + t d − p) · n = 0.

mod adaptive;
mod shifted_origin;

pub use adaptive::{at_height, limits};
pub use shifted_origin::ShiftedOrigin;
