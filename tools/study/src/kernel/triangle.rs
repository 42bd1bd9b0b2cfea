//! Triangles: e + t d on the triangle a, b, c, edges included.

mod adaptive;
mod bounded;
mod cramer;
mod double_double;
mod edge_functions;
mod exact;
mod four;
mod moller_trumbore;
mod moller_trumbore_epsilon;
mod twice;
mod woop;
mod woop_once;

pub use adaptive::{Adaptive, filtered};
pub use bounded::{bounded, limits, size};
pub use cramer::Cramer;
pub use double_double::DoubleDouble;
pub use edge_functions::EdgeFunctions;
pub use exact::exact;
pub use four::{Four, Met};
pub use moller_trumbore::MollerTrumbore;
pub use moller_trumbore_epsilon::MollerTrumboreEpsilon;
pub use twice::twice;
pub use woop::Woop;
pub use woop_once::WoopOnce;
