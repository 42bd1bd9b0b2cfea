use crate::double_double::DoubleDouble;
use crate::kernel::{Camera, Limits, ScaledQuery};
use crate::number::{Real, TINY, U};
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
/// 3. Both are below 256u M (A + M), which [`Filtered::limits`] allows. Underflow and overflow are
///    covered there, too; q and the slopes are only scaled by powers of two.
/// 4. t is n·(a − e) / n·d with n = (b − a) × (c − a). What the camera fixes is computed in
///    double-double arithmetic and rounded once: n, with an error of at most u|n| + 32u² M² in each
///    component, and products with n, where 288u² A M² or 576u² M² are added (see
///    [`refined`](crate::cast::refined)). Let N = |n|∞. In a perspective, the error of n·d is at
///    most 30u N + 192u² M², and that of n·(a − e) at most 3u A N + 288u² A M². For parallel rays,
///    that of n·d is at most 6u N + 576u² M², and that of n·(a − e) at most 12u A N + 320u² A M²:
///    3u A N for each of the offset and the sum, and the rest for n·(e − o). If N is computed
///    with rounding, it is off by less than 9u M². So [`TriangleFromCamera::limits`] allows 32u N
///    + 1024u² M², and A times as much.
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
        let n = Vector::between(b, a).cross(Vector::between(c, a));
        let height = |from| n.dot(Vector::between(a, from)).high;
        let zero = Vector::default();
        // A function of the origin e, of which q is the scaled distance from o.
        let falling = |normal: Vector<f64>, offset, exponent: i32| Affine {
            slope: normal.map(|x| -x.times_power_of_two(exponent)),
            offset,
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
                determinant: linear(n.rounded()),
                volume: constant(height(eye)),
            },
            Camera::Orthographic {
                scaled, exponent, ..
            } => {
                let Ray { origin, direction } = scaled.ray;
                let side = |(p, end): (Vector<f64>, Vector<f64>)| {
                    let normal = (end - p).cross(direction);
                    falling(normal, normal.dot(p - origin), exponent)
                };
                TriangleFromCamera {
                    sides: sides.map(side),
                    determinant: constant(n.dot(direction.map(DoubleDouble::from)).high),
                    volume: falling(n.rounded(), height(origin), exponent),
                }
            }
        }
    }

    /// The limits of [`super::adaptive`] for the same `away` and `accuracy`, with smaller ones for t.
    pub fn limits(triangle: &Triangle<f64>, away: f64, accuracy: f64, limits: Limits) -> Limits {
        let [a, b, c] = triangle.corners;
        let (e1, e2) = (b - a, c - a);
        let size = e1.largest().max(e2.largest());
        let lost = 32.0 * U * e1.cross(e2).largest() + 1024.0 * U * U * size * size;
        let good = |error: f64, limit: f64| match limit.is_finite() {
            true => 2.0 / accuracy * (error + 64.0 * TINY * (1.0 + size + away)),
            // Something may have overflowed.
            false => limit,
        };
        Limits {
            divisor: good(lost, limits.divisor),
            dividend: good(lost * away, limits.dividend),
            ..limits
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
