//! Slab test of a ray against eight boxes at a time, in `f32`. Rounding never makes it reject a
//! box that the ray meets.
//!
//! A ray crosses a box's side p at t = (p − e) / d, which is computed as p × inverse − offset.
//! A bound on the rounding errors is added to the offset once per ray, so that near sides are
//! computed too near and far sides too far. In the scene's own [`Frame`], with u = 2⁻²⁴, |p| ≤
//! 1.001 and, if the ray meets anything, |e| ≤ `NEAR`:
//!
//! 1. e is the origin. A distant origin is first moved along the ray to a little before the
//!    point nearest to the scene's centre, which leaves it within 6 of the centre. The moved
//!    origin is computed in `f64`; from a distance A, its error is at most 2⁻⁴⁸ A (five
//!    roundings of numbers up to 4A).
//! 2. The inverse has a relative error of u, and p × inverse one more u. Subtracting the offset
//!    adds an error of u (|p| + |e|) |inverse|, and rounding the offset one of u |e| |inverse|.
//!    The sum is below u (3.1 + 2.1 |e|) |inverse|. The slack is (4u (1 + |e|) + 2⁻⁴⁷ A)
//!    |inverse|.
//! 3. A component of the direction below 2⁻⁶⁰ is replaced by ±2⁻⁶⁰. The ray's way through the
//!    scene is shorter than `BEYOND`, so this moves the ray by less than 2⁻⁵⁵, which the
//!    slack covers. Therefore no number here is infinite or NaN.
//! 4. The start of the search interval is rounded down and its end is rounded up.
//!
//! A point of a part lies in the part's box and in all boxes around it, so its t lies between
//! the computed near and far sides of all these boxes. A box that contains a hit is therefore
//! skipped only if the hit lies beyond the horizon, that is, if a nearer hit is already known.
//!
//! If all rays start at the frame's centre, t = p / d needs no offset. The inverse is made smaller
//! by 8u for near sides and larger by 8u for far ones. d, its inverse, that factor's product and
//! the product with p are each rounded once, so the relative error is below 4.1u. Components of d
//! below 2⁻¹⁰⁰ are replaced, which moves the ray by less than the margin of [`Frame::boxed`].

use wide::f32x8;

use crate::kernel::sphere::ScaledRay;
use crate::number::{Real, exponent};
use crate::vector::Vector;

/// Eight boxes in structure-of-arrays layout: low sides, then high sides, by axis.
pub type Boxes = [[f32x8; 3]; 2];

/// A ray that starts less than [`NEAR`] from the scene has left it by this t.
const BEYOND: f32 = 32.0;
/// Origins further away are moved towards the scene.
const NEAR: f64 = 8.0;
/// Beyond this distance, the error of the moved origin may be too large for the test.
const TOO_FAR: f64 = 1e12;
/// Smaller components of a direction are replaced by this one.
const PARALLEL: f64 = 1.0 / (1u64 << 60) as f64;
/// The unit roundoff of `f32`.
const UNIT: f64 = 1.0 / (1u64 << 24) as f64;

/// Replaces smaller components of a ray from the frame's centre.
const PARALLEL_FROM_CENTER: f32 = 7.9e-31;

/// A scene's local coordinates, in which boxes are stored in `f32`.
///
/// local = (world − `center`) 2^−`exponent`. All boxed parts of a scene lie between −1 and 1 in
/// this frame, wherever the scene is and however large it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Frame {
    center: Vector<f64>,
    /// A length of 2^`exponent` in the world has length 1 in the frame.
    pub exponent: i32,
}

impl Frame {
    /// The frame of a box, given by two opposite corners with coordinates below 1e300. Its centre
    /// is that of the box, or the eye from which all rays start.
    pub fn around([low, high]: [Vector<f64>; 2], eye: Option<Vector<f64>>) -> Frame {
        let center = eye.unwrap_or(low * 0.5 + high * 0.5);
        let size = (high - center).largest().max((center - low).largest());
        // The box of a single point has size 0.
        let size = size.max(center.largest() * 1e-9).max(1e-280);
        Frame {
            center,
            exponent: exponent(size) + 1,
        }
    }

    /// A point of the world in local coordinates, with a relative error of u.
    #[inline(always)]
    pub fn local(&self, point: Vector<f64>) -> Vector<f64> {
        (point - self.center).map(|x| x.times_power_of_two(-self.exponent))
    }

    /// A box in local coordinates that encloses the given one: each number is rounded to `f32`,
    /// then moved outwards to the next `f32`, and by 2⁻⁹⁶.
    pub fn boxed(&self, [low, high]: [Vector<f64>; 2]) -> [[f32; 3]; 2] {
        const MARGIN: f32 = 1.3e-29;
        let below = |x: f64| (x as f32).next_down() - MARGIN;
        let above = |x: f64| (x as f32).next_up() + MARGIN;
        [
            self.local(low).map(below).array(),
            self.local(high).map(above).array(),
        ]
    }
}

/// A ray prepared for the slab test.
pub struct Slabs {
    /// The direction's inverses, for near sides and for far sides.
    inverse: [[f32x8; 3]; 2],
    /// The offsets to subtract for near sides, and for far sides.
    offset: [[f32x8; 3]; 2],
    /// For each axis, the index of a box's near side, and of its far side.
    order: [[usize; 3]; 2],
    from: f32x8,
    /// The local parameter is t × 2^`exponent` − `moved`.
    exponent: i32,
    moved: f64,
}

impl Slabs {
    /// Prepares a ray. `None` if it is not finite, has no direction, or starts too far away for the
    /// test.
    #[inline(always)]
    pub fn of(frame: &Frame, scaled: &ScaledRay<f64>, min_t: f64) -> Option<Slabs> {
        let (mut origin, d) = (frame.local(scaled.ray.origin), scaled.ray.direction);
        if !(1.0..2.0).contains(&d.largest()) {
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
            inverse: [[x.0, y.0, z.0].map(f32x8::splat); 2],
            offset: [[x.1, y.1, z.1], [x.2, y.2, z.2]].map(|side| side.map(f32x8::splat)),
            order: [
                [x.0, y.0, z.0].map(|inverse| usize::from(inverse < 0.0)),
                [x.0, y.0, z.0].map(|inverse| usize::from(inverse >= 0.0)),
            ],
            from: f32x8::splat(from.max(-BEYOND).next_down()),
            exponent,
            moved,
        })
    }

    /// Prepares a ray from the frame's centre.
    #[inline(always)]
    pub fn from_center(frame: &Frame, scaled: &ScaledRay<f64>, min_t: f64) -> Slabs {
        let exponent = scaled.exponent - frame.exponent;
        let d = scaled.ray.direction.array();
        let d = d.map(|d| f32x8::splat(d as f32));
        let small = f32x8::splat(PARALLEL_FROM_CENTER);
        let sign = f32x8::splat(-0.0);
        let away = d.map(|d| (d & sign) | (d & !sign).fast_max(small));
        let inverse = away.map(|d| f32x8::splat(1.0) / d);
        let by = |factor: f64| inverse.map(|inverse| inverse * f32x8::splat(factor as f32));
        let is_negative = d.map(|d| d.to_bitmask() & 1 == 1);
        let from = min_t.times_power_of_two(exponent) as f32;
        Slabs {
            inverse: [by(1.0 - 8.0 * UNIT), by(1.0 + 8.0 * UNIT)],
            offset: [[f32x8::splat(0.0); 3]; 2],
            order: [
                is_negative.map(usize::from),
                is_negative.map(|is_negative| usize::from(!is_negative)),
            ],
            from: f32x8::splat(from.next_down()),
            exponent,
            moved: 0.0,
        }
    }

    /// A horizon in the local parameter, rounded up.
    #[inline(always)]
    pub fn horizon(&self, t: f64) -> f32 {
        let t = (t.times_power_of_two(self.exponent) - self.moved) as f32;
        t.next_up().min(BEYOND)
    }

    /// A bit for each box that the ray may enter before the horizon, and the parameter at which
    /// it enters each box. `FROM_CENTER` says whether the ray starts at the frame's centre.
    #[inline(always)]
    pub fn enter<const FROM_CENTER: bool>(&self, boxes: &Boxes, horizon: f32) -> (u32, [f32; 8]) {
        let side = |axis: usize, far: usize| {
            let t = boxes[self.order[far][axis] & 1][axis] * self.inverse[far][axis];
            match FROM_CENTER {
                true => t,
                false => t - self.offset[far][axis],
            }
        };
        let near = side(0, 0)
            .fast_max(side(1, 0))
            .fast_max(side(2, 0).fast_max(self.from));
        let far = side(0, 1)
            .fast_min(side(1, 1))
            .fast_min(side(2, 1).fast_min(f32x8::splat(horizon)));
        (near.simd_le(far).to_bitmask(), near.to_array())
    }
}
