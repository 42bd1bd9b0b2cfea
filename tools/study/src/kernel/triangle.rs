//! Triangles: e + t d on the triangle a, b, c, edges included.

mod adaptive;
mod from_camera;
mod moller_trumbore;
mod triangle_packet;
mod woop;

pub use from_camera::{PacketFromCamera, TriangleFromCamera};
pub use moller_trumbore::{MollerTrumbore, MollerTrumboreEpsilon};
pub use triangle_packet::TrianglePacket;
pub use woop::Woop;
