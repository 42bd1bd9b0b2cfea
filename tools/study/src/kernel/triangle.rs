//! Triangles: e + t d on the triangle a, b, c, edges included.

mod adaptive;
mod from_camera;
mod moller_trumbore;
mod woop;

pub use from_camera::TriangleFromCamera;
pub use moller_trumbore::{MollerTrumbore, MollerTrumboreEpsilon};
pub use woop::Woop;
