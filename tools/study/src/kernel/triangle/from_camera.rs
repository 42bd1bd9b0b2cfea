use crate::kernel::{Camera, Limits, ScaledQuery};
use crate::number::Real;
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
            Camera::Orthographic {
                scaled, exponent, ..
            } => {
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
        // `f64::min` takes more instructions, because it has a rule for NaN.
        let smaller = |p, q| if p < q { p } else { q };
        let larger = |p, q| if p > q { p } else { q };
        let (least, most) = (smaller(smaller(u, v), w), larger(larger(u, v), w));
        if least < -bound && most > bound {
            return Some(None);
        }
        let (determinant, volume) = match HAS_EYE {
            true => (self.determinant.slope.dot(q), self.volume.offset),
            false => (self.determinant.offset, self.volume.at(q)),
        };
        let is_inside = least > bound || most < -bound;
        let is_good = determinant.abs() > limits.divisor && volume.abs() > limits.dividend;
        match is_inside && is_good {
            true => query.answer(volume / determinant),
            false => None,
        }
    }
}
