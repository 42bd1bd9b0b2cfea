//! A ray against a box, all in `f32`.

use glam::Vec3A;
use obvhs::aabb::Aabb;

use super::Near;
use crate::cast::world::Primitive;
use crate::kernel::sphere::Scaled;
use crate::shape::Ray;

/// What is needed of a ray to say which boxes it meets.
pub struct Slabs {
    scaled: Scaled<f32>,
    origin: Vec3A,
    inverse: Vec3A,
    from: f32,
}

/// Both ends of a slab are off by 3u of themselves at most.
const ROOM: f32 = 1.0 + 4.0 * f32::EPSILON;

impl Slabs {
    /// Of a ray, from `min_t` on.
    #[inline(always)]
    pub fn of(ray: &Ray<f32>, min_t: f32) -> Slabs {
        let scaled = Scaled::new(ray);
        let inverse = |d: f32| if d == 0.0 { f32::MAX } else { 1.0 / d };
        Slabs {
            origin: scaled.ray.origin.array().into(),
            inverse: scaled.ray.direction.map(inverse).array().into(),
            from: scaled.scale(min_t),
            scaled,
        }
    }

    /// What lies beyond it cannot be first.
    #[inline(always)]
    pub fn horizon(&self, near: &Option<Near>) -> f32 {
        let beyond = near.map_or(f32::MAX, |near| self.scaled.scale(near.t) * ROOM);
        beyond.min(f32::MAX)
    }

    /// Where a ray enters a box, or infinity.
    #[inline(always)]
    pub fn enters(&self, room: &Aabb, beyond: f32) -> f32 {
        let low = (room.min - self.origin) * self.inverse;
        let high = (room.max - self.origin) * self.inverse;
        let near = low.min(high).max_element();
        let near = if near > self.from { near } else { self.from };
        let far = low.max(high).min_element() * ROOM;
        match near <= far && near <= beyond {
            true => near,
            false => f32::INFINITY,
        }
    }
}

/// A box around it, larger by what rounding the shape and the ray may move them.
pub fn room(shape: Primitive) -> Option<Aabb> {
    let [low, high] = shape.bounds()?;
    let spare = 8.0 * f32::EPSILON * low.largest().max(high.largest()) as f32;
    let low = low.map(|x| (x as f32 - spare).next_down()).array();
    let high = high.map(|x| (x as f32 + spare).next_up()).array();
    let is_finite = low.iter().chain(&high).all(|x| x.abs() < f32::MAX);
    is_finite.then(|| Aabb::new(low.into(), high.into()))
}
