//! A ray against four boxes at a time, in `f32`, without losing any.
//!
//! A ray crosses a box's side p at t = (p − e) / d, which is computed as p × inverse −
//! offset. All that rounding can do to that is put into the offset beforehand, once for
//! a ray: a near side is taken for nearer, a far side for further. In the scene's own
//! [`Frame`], with u = 2⁻²⁴, |p| ≤ 1.001 and, where anything is met, |e| ≤ [`NEAR`]:
//!
//! 1. e is the origin; if that is far away, moved along the ray to a little before it
//!    passes the middle of the scene, which leaves it within 6 of that. In `f64`, from a
//!    distance A, it is off by 2⁻⁴⁸ A at most (five roundings of numbers up to 4A).
//! 2. The inverse is off by u of itself, p × inverse by one more u, what is left when the
//!    offset is taken from it by u (|p| + |e|) |inverse|, and the offset, rounded, by
//!    u |e| |inverse|. Together that is below u (3.1 + 2.1 |e|) |inverse|; the spare is
//!    (4u (1 + |e|) + 2⁻⁴⁷ A) |inverse|.
//! 3. A component of the direction below 2⁻⁶⁰ is replaced by that. On the ray's way
//!    through the scene, which is shorter than [`BEYOND`], this moves it by 2⁻⁵⁶, and the
//!    spare has room for that. So no number here is infinite or NaN.
//! 4. Where a search begins is rounded down, where it ends up.
//!
//! A point of a part lies in the part's box and in all boxes around that: its t is then
//! between all near and all far sides as they are computed. No box that holds what a ray
//! meets is passed by, but where the horizon says that something nearer is met.

use wide::f32x4;

use super::frame::Frame;
use crate::kernel::sphere::ScaledRay;
use crate::number::Real;

/// Four boxes, side by side: first their low sides, then their high ones, by axis.
pub type Boxes = [[f32x4; 3]; 2];

/// No scene is longer, along a ray that begins less than [`NEAR`] from it.
const BEYOND: f32 = 32.0;
/// Origins further away are moved.
const NEAR: f64 = 8.0;
/// From further away, the error of moving is as large as the scene.
const TOO_FAR: f64 = 1e12;
/// A smaller component of a direction crosses nothing.
const PARALLEL: f64 = 1.0 / (1u64 << 60) as f64;
/// The largest relative error of an `f32`.
const UNIT: f64 = 1.0 / (1u64 << 24) as f64;

/// What is needed of a ray to say which boxes it meets.
pub struct Slabs {
    inverse: [f32x4; 3],
    /// What to take from a near side's product, and from a far side's.
    offset: [[f32x4; 3]; 2],
    /// Which of a box's two sides is the near one, and which the far.
    order: [[usize; 3]; 2],
    from: f32x4,
    /// t as given times 2^`exponent`, minus `moved`, is t here.
    exponent: i32,
    moved: f64,
}

impl Slabs {
    /// `None` if the ray is too far away to tell, or not finite.
    #[inline(always)]
    pub fn of(frame: &Frame, scaled: &ScaledRay<f64>, min_t: f64) -> Option<Slabs> {
        let (mut origin, d) = (frame.local(scaled.ray.origin), scaled.ray.direction);
        if !(d.largest() < 2.0) {
            return None;
        }
        let away = origin.largest();
        let mut moved = 0.0;
        if !(away < NEAR) {
            if !(away < TOO_FAR) {
                return None;
            }
            moved = -origin.dot(d) / d.dot(d) - 2.0;
            origin = origin + d * moved;
        }
        let slack = 4.0 * UNIT * (1.0 + origin.largest()) + away * f64::EPSILON * 32.0;
        let exponent = scaled.exponent - frame.exponent;
        let axis = |d: f64, e: f64| {
            let d = if d.abs() < PARALLEL {
                PARALLEL.copysign(d)
            } else {
                d
            };
            let inverse = 1.0 / d;
            let (offset, spare) = (e * inverse, slack * inverse.abs());
            (
                inverse as f32,
                (offset + spare) as f32,
                (offset - spare) as f32,
            )
        };
        let [x, y, z] = [
            axis(d.x, origin.x),
            axis(d.y, origin.y),
            axis(d.z, origin.z),
        ];
        let from = (min_t.times_power_of_two(exponent) - moved) as f32;
        Some(Slabs {
            inverse: [x.0, y.0, z.0].map(f32x4::splat),
            offset: [[x.1, y.1, z.1], [x.2, y.2, z.2]].map(|side| side.map(f32x4::splat)),
            order: [
                [x.0, y.0, z.0].map(|inverse| usize::from(inverse < 0.0)),
                [x.0, y.0, z.0].map(|inverse| usize::from(inverse >= 0.0)),
            ],
            from: f32x4::splat(from.max(-BEYOND).next_down()),
            exponent,
            moved,
        })
    }

    /// A horizon, as counted here.
    #[inline(always)]
    pub fn horizon(&self, t: f64) -> f32 {
        let t = (t.times_power_of_two(self.exponent) - self.moved) as f32;
        t.next_up().min(BEYOND)
    }

    /// A bit for each box that the ray may meet before the horizon, and where it enters.
    #[inline(always)]
    pub fn enter(&self, boxes: &Boxes, horizon: f32) -> (u32, [f32; 4]) {
        let side = |axis: usize, far: usize| {
            boxes[self.order[far][axis] & 1][axis] * self.inverse[axis] - self.offset[far][axis]
        };
        let near = side(0, 0)
            .fast_max(side(1, 0))
            .fast_max(side(2, 0).fast_max(self.from));
        let far = side(0, 1)
            .fast_min(side(1, 1))
            .fast_min(side(2, 1).fast_min(f32x4::splat(horizon)));
        (near.simd_le(far).to_bitmask(), near.to_array())
    }
}
