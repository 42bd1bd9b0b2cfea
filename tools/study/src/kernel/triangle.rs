//! Triangles: e + t d on the triangle a, b, c, edges included.

mod adaptive;
mod four;
mod moller_trumbore;
mod twice;
mod woop;

pub use adaptive::{Adaptive, decided, exact, filtered, limits, size};
pub use four::{Four, Met};
pub use moller_trumbore::{MollerTrumbore, MollerTrumboreEpsilon};
pub use twice::twice;
pub use woop::Woop;
