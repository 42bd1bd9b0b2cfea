//! Triangles: e + t d on the triangle a, b, c, edges included.

mod adaptive;
mod bounded;
mod exact;
mod four;
mod moller_trumbore;
mod moller_trumbore_epsilon;
mod twice;
mod woop;

pub use adaptive::{Adaptive, filtered};
pub use bounded::{bounded, limits, size};
pub use exact::exact;
pub use four::{Four, Met};
pub use moller_trumbore::MollerTrumbore;
pub use moller_trumbore_epsilon::MollerTrumboreEpsilon;
pub use twice::twice;
pub use woop::Woop;
