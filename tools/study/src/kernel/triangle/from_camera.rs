use wide::f32x4;

use crate::kernel::{Camera, Limits, ScaledQuery};
use crate::number::{Real, exponent};
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// `slope`·q + `offset`, where q is what differs between the rays of a [`Camera`].
#[derive(Clone, Copy, Debug)]
struct Affine {
    slope: Vector<f64>,
    offset: f64,
}

impl Affine {
    #[inline(always)]
    fn at(&self, q: Vector<f64>) -> f64 {
        self.slope.dot(q) + self.offset
    }

    fn largest(&self) -> f64 {
        self.slope.largest().max(self.offset.abs())
    }
}

/// The filter of [`super::adaptive`] for the rays of one camera. A ray passes each side of the
/// triangle on the left or on the right. If it passes all three on the same side, it hits. The sign
/// of a volume says on which side it passes, and the volumes are affine functions of q: three
/// multiplications each.
///
/// # Why the filter is right
///
/// Let u and M be as in [`super::adaptive`], o the camera's centre, and A ≥ |a − o|∞ + 4|e − o|∞
/// what [`Filtered::limits`] calls `away`. For a side s from p, |s|∞ ≤ 2M and |p − o|∞ ≤ A + M.
///
/// 1. Perspective, o = e: the volume is d·((p − e) × s). The error of a component of the cross
///    product is at most 16u M (A + M), so that of the volume is at most 6 × 16u M (A + M), plus
///    72u M (A + M) for the dot product's own roundings.
/// 2. Orthographic: the volume is m·(p − o) − m·(e − o) with m = s × d. The error of a component
///    of m is at most 32u M, which contributes 96u M (A + M). The roundings of p − o and of the
///    first dot product add 88u M (A + M), those of e − o, at most A/4, and of the second 22u M
///    A, and the sum's 24u M (A + M).
/// 3. Both are below 256u M (A + M), which [`Filtered::limits`] allows. It also allows 256u M² for
///    the determinant d·n with n = (b − a) × (c − a), whose error is at most 84u M², and 256u A
///    M² for the volume n·(a − e), whose error is at most 69u A M². Underflow and overflow are
///    covered there, too; q and the slopes are only scaled by powers of two.
///
/// [`Filtered::limits`]: crate::kernel::Filtered::limits
#[derive(Clone, Copy, Debug)]
pub struct TriangleFromCamera {
    sides: [Affine; 3],
    determinant: Affine,
    /// t times the determinant.
    volume: Affine,
}

impl TriangleFromCamera {
    /// The constants of a triangle.
    pub fn new(triangle: &Triangle<f64>, camera: &Camera) -> TriangleFromCamera {
        let [a, b, c] = triangle.corners;
        let n = (b - a).cross(c - a);
        let zero = Vector::default();
        // A function of the origin e, of which q is the scaled distance from o.
        let falling = |normal: Vector<f64>, point: Vector<f64>, o, exponent: i32| Affine {
            slope: normal.map(|x| -x.times_power_of_two(exponent)),
            offset: normal.dot(point - o),
        };
        let constant = |offset| Affine {
            slope: zero,
            offset,
        };
        let linear = |slope| Affine { slope, offset: 0.0 };
        let sides = [(a, b), (b, c), (c, a)];
        match *camera {
            Camera::Perspective { eye } => TriangleFromCamera {
                sides: sides.map(|(p, end)| linear((p - eye).cross(end - p))),
                determinant: linear(n),
                volume: constant(n.dot(a - eye)),
            },
            Camera::Orthographic { scaled, exponent } => {
                let Ray { origin, direction } = scaled.ray;
                TriangleFromCamera {
                    sides: sides
                        .map(|(p, end)| falling((end - p).cross(direction), p, origin, exponent)),
                    determinant: constant(n.dot(direction)),
                    volume: falling(n, a, origin, exponent),
                }
            }
        }
    }

    /// The answer, or `None` if rounding might have changed it. `HAS_EYE` says whether the camera
    /// has a perspective; the sides have no offset then.
    #[inline(always)]
    pub fn filtered<const HAS_EYE: bool>(
        &self,
        q: Vector<f64>,
        query: &ScaledQuery,
        limits: &Limits,
    ) -> Option<Option<f64>> {
        let bound = limits.sign;
        let [u, v, w] = self.sides.map(|side| match HAS_EYE {
            true => side.slope.dot(q),
            false => side.at(q),
        });
        let (least, most) = (u.min(v).min(w), u.max(v).max(w));
        if least < -bound && most > bound {
            return Some(None);
        }
        let (determinant, volume) = (self.determinant.at(q), self.volume.at(q));
        let is_inside = least > bound || most < -bound;
        let is_good = determinant.abs() > limits.divisor && volume.abs() > limits.dividend;
        match is_inside && is_good {
            true => query.answer(volume / determinant),
            false => None,
        }
    }
}

/// Four triangles from the same camera, in `f32`. It only tells which of them a ray may hit.
///
/// Each triangle's functions are divided by a power of two, so that no slope or offset reaches 1.
/// With U = 2⁻²⁴, rounding a slope, q and their product to `f32` adds an error of at most 3U times
/// the product. In perspective, no component of q exceeds 2: the three products add 18U, and their
/// sums 4U + 6U. Otherwise, no component of q exceeds 1, but there is an offset: the products add
/// 9U, the offset U, and the sums 2U + 3U + 4U. So 40U bounds the error of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct PacketFromCamera {
    sides: [(Vector<f32x4>, f32x4); 3],
    /// Bound on the error of a volume.
    bound: f32x4,
    /// A bit for each lane that contains a triangle.
    all: u32,
}

impl PacketFromCamera {
    /// Packs one to four triangles, each with its [`Limits::sign`].
    pub fn new(triangles: &[(&TriangleFromCamera, f64)]) -> PacketFromCamera {
        let lanes = [0, 1, 2, 3].map(|lane| {
            let (TriangleFromCamera { sides, .. }, sign) =
                triangles.get(lane).unwrap_or(&triangles[0]);
            let largest = sides.iter().map(Affine::largest).fold(0.0, f64::max);
            let scaled = move |x: f64| x.times_power_of_two(-1 - exponent(largest));
            // Nothing is certain about sides that overflow or have no digits.
            let bound = match (1e-250..1e250).contains(&largest) {
                true => 40.0 / (1 << 24) as f64 + scaled(*sign),
                false => f64::INFINITY,
            };
            let side = sides.map(|Affine { slope, offset }| (slope.map(scaled), scaled(offset)));
            (side, bound)
        });
        let each = |of: &dyn Fn(usize) -> f64| f32x4::new([0, 1, 2, 3].map(|at| of(at) as f32));
        let side = |side: usize| {
            let component = |of: fn(&Vector<f64>) -> f64| each(&|at| of(&lanes[at].0[side].0));
            let slope = Vector::new(component(|v| v.x), component(|v| v.y), component(|v| v.z));
            (slope, each(&|at| lanes[at].0[side].1))
        };
        PacketFromCamera {
            sides: [side(0), side(1), side(2)],
            bound: each(&|at| f64::from((lanes[at].1 as f32).next_up())),
            all: (1 << triangles.len()) - 1,
        }
    }

    /// A bit for each triangle that the ray does not certainly miss.
    #[inline(always)]
    pub fn candidates<const HAS_EYE: bool>(&self, q: Vector<f32x4>) -> u32 {
        let [u, v, w] = self.sides.map(|(slope, offset)| match HAS_EYE {
            true => slope.dot(q),
            false => slope.dot(q) + offset,
        });
        let (least, most) = (u.fast_min(v).fast_min(w), u.fast_max(v).fast_max(w));
        let missed = (-least).simd_gt(self.bound) & most.simd_gt(self.bound);
        !missed.to_bitmask() & self.all
    }
}
