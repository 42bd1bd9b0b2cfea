//! What even the exact path cannot promise, for its results are `f64`.

use pinhole::Scene;

use crate::cast::world::World;
use crate::number::Real;
use crate::plan::Wish;
use crate::plan::extent::Extent;
use crate::plan::told::angle;

/// Refuses a wish that no plan can meet.
pub fn refuse(scene: &Scene, world: &World, wish: Wish) -> Result<(), String> {
    let u = f64::UNIT_ROUNDOFF;
    if !(wish.accuracy >= 16.0 * u) {
        return Err(format!(
            "an f64 holds 16 digits: no answer is known to {:e}\n  remedy: ask for 2e-15 or more",
            wish.accuracy
        ));
    }
    if !wish.normal {
        return Ok(());
    }
    let extent = Extent::of(scene);
    let floor = world.parts.iter().map(|part| extent.floor(part));
    let floor = floor.fold(0.0, f64::max);
    match floor <= wish.accuracy {
        true => Ok(()),
        false => Err(format!(
            "the normal of a sphere so small or so far away is known to {} only, for t is an \
             f64\n  remedy: ask for that, or leave normals out with --outputs id,depth",
            angle(floor)
        )),
    }
}
