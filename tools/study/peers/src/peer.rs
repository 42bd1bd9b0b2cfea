//! Who is compared: each casts the same rays at the same mesh and says where.

mod bvh;
#[cfg(embree)]
mod embree;
mod obvhs;
mod ours;
mod parry;

use pinhole_study::cast::model::{Exact, Plain};
use pinhole_study::speed::now;

use crate::mesh::Mesh;
use crate::rays::Ray;

/// One of them, ready to cast.
pub struct Peer {
    /// How the table calls it.
    pub name: &'static str,
    /// CPU time of building what is searched, in seconds.
    pub building: f64,
    /// Where each ray meets the mesh first, infinite for a miss.
    pub cast: Box<dyn FnMut() -> Vec<f64>>,
}

impl Peer {
    fn new(name: &'static str, cast: impl FnMut() -> Vec<f64> + 'static) -> Peer {
        Peer {
            name,
            building: 0.0,
            cast: Box::new(cast),
        }
    }
}

/// The exact caster, against which all are checked; it is the first.
pub const EXACT: &str = "ours, exact";
/// What targets are told in.
pub const ROBUST: &str = "Embree robust, f32";
/// Parry in our type of numbers.
pub const PARRY: &str = "parry3d-f64";

/// The exact caster alone.
pub fn exact(mesh: &Mesh, rays: &[Ray]) -> Peer {
    ours::peer::<Exact>(EXACT, mesh, rays)
}

/// All who are there.
pub fn all(mesh: &Mesh, rays: &[Ray]) -> Vec<Peer> {
    let makers: &[fn(&Mesh, &[Ray]) -> Peer] = &[
        exact,
        |mesh, rays| ours::peer::<Plain>("ours, plain f64", mesh, rays),
        #[cfg(embree)]
        |mesh, rays| embree::peer(ROBUST, true, mesh, rays),
        #[cfg(embree)]
        |mesh, rays| embree::peer("Embree fast, f32", false, mesh, rays),
        parry::single,
        |mesh, rays| parry::double(PARRY, mesh, rays),
        obvhs::two_wide,
        obvhs::eight_wide,
        bvh::peer,
    ];
    let timed = |make: &fn(&Mesh, &[Ray]) -> Peer| {
        let start = now();
        let peer = make(mesh, rays);
        let building = (now() - start).as_secs_f64();
        Peer { building, ..peer }
    };
    makers.iter().map(timed).collect()
}
