use wide::f64x4;

use crate::kernel::{Limits, ScaledQuery};
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// Up to four triangles in SIMD lanes: a first corner and the two edges from it, which are
/// computed once instead of at every test.
///
/// Each lane performs the same operations as [`super::MollerTrumbore`] and [`super::adaptive`],
/// so the results are the same bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct TrianglePacket {
    corner: Vector<f64x4>,
    edges: [Vector<f64x4>; 2],
    /// A bit for each lane that contains a triangle.
    all: u32,
}

/// The result of four tests.
#[derive(Clone, Copy, Debug)]
pub struct PacketHits {
    /// A bit for each triangle that is certainly hit.
    pub hits: u32,
    /// A bit for each triangle whose answer is uncertain.
    pub open: u32,
    /// The t of each triangle that is hit, in multiples of the ray's direction. It may overflow.
    pub t: [f64; 4],
}

impl PacketHits {
    /// No hit.
    pub const NOTHING: PacketHits = PacketHits {
        hits: 0,
        open: 0,
        t: [0.0; 4],
    };
}

impl TrianglePacket {
    /// Packs one to four triangles.
    pub fn new(triangles: &[Triangle<f64>]) -> TrianglePacket {
        let each = |of: fn(&Triangle<f64>) -> Vector<f64>| {
            let lane = |at: usize| triangles.get(at).or(triangles.first()).map(of);
            let lanes = [0, 1, 2, 3].map(|at| lane(at).expect("there is at least one triangle"));
            let component = |of: fn(Vector<f64>) -> f64| f64x4::new(lanes.map(of));
            Vector::new(component(|v| v.x), component(|v| v.y), component(|v| v.z))
        };
        TrianglePacket {
            corner: each(|triangle| triangle.corners[0]),
            edges: [
                each(|triangle| triangle.corners[1] - triangle.corners[0]),
                each(|triangle| triangle.corners[2] - triangle.corners[0]),
            ],
            all: (1 << triangles.len()) - 1,
        }
    }

    /// Leaves all triangles undecided.
    #[inline(always)]
    pub fn left_open(&self) -> PacketHits {
        PacketHits {
            open: self.all,
            ..PacketHits::NOTHING
        }
    }

    /// Tests all lanes like [`super::MollerTrumbore`].
    #[inline(always)]
    pub fn plainly(&self, ray: &Ray<f64>, min_t: f64) -> PacketHits {
        let (origin, d) = (
            ray.origin.map(f64x4::splat),
            ray.direction.map(f64x4::splat),
        );
        let (zero, one) = (f64x4::splat(0.0), f64x4::splat(1.0));
        let [e1, e2] = self.edges;
        let p = d.cross(e2);
        let inverse = one / e1.dot(p);
        let s = origin - self.corner;
        let u = s.dot(p) * inverse;
        // A determinant of 0 makes u infinite or NaN.
        let inside = u.simd_ge(zero) & u.simd_le(one);
        if inside.to_bitmask() & self.all == 0 {
            return PacketHits::NOTHING;
        }
        let q = s.cross(e1);
        let v = d.dot(q) * inverse;
        let inside = inside & v.simd_ge(zero) & (u + v).simd_le(one);
        let hits = inside.to_bitmask() & self.all;
        if hits == 0 {
            return PacketHits::NOTHING;
        }
        let t = e2.dot(q) * inverse;
        PacketHits {
            hits: hits & t.simd_ge(f64x4::splat(min_t)).to_bitmask(),
            open: 0,
            t: t.to_array(),
        }
    }

    /// Tests all lanes like the filter of [`super::adaptive`].
    #[inline(always)]
    pub fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> PacketHits {
        let ray = &query.scaled.ray;
        let (origin, d) = (
            ray.origin.map(f64x4::splat),
            ray.direction.map(f64x4::splat),
        );
        let minus_zero = f64x4::splat(-0.0);
        let bound = f64x4::splat(limits.sign);
        let [e1, e2] = self.edges;
        let p = d.cross(e2);
        let determinant = e1.dot(p);
        let side = determinant & minus_zero;
        let determinant = determinant ^ side;
        let is_sure = determinant.simd_gt(bound);
        let s = origin - self.corner;
        let u = s.dot(p) ^ side;
        let below = bound ^ minus_zero;
        let missed = is_sure & (u.simd_lt(below) | (u - determinant).simd_gt(bound));
        if !missed.to_bitmask() & self.all == 0 {
            return PacketHits::NOTHING;
        }
        let q = s.cross(e1);
        let v = d.dot(q) ^ side;
        let w = determinant - u - v;
        let missed = missed | is_sure & (v.simd_lt(below) | w.simd_lt(below));
        let left = !missed.to_bitmask() & self.all;
        if left == 0 {
            return PacketHits::NOTHING;
        }
        let inside = u.simd_gt(bound) & v.simd_gt(bound) & w.simd_gt(bound);
        let volumes = (e2.dot(q) ^ side).to_array();
        let determinants = determinant.to_array();
        let (mut met, mut inside) = (PacketHits::NOTHING, inside.to_bitmask() & left);
        met.open = left & !inside;
        // Usually at most one lane is left.
        while inside != 0 {
            let lane = inside.trailing_zeros() as usize & 3;
            inside &= inside - 1;
            let (volume, determinant) = (volumes[lane], determinants[lane]);
            let is_good = determinant > limits.divisor && volume.abs() > limits.dividend;
            let t = volume / determinant;
            if is_good && t > query.after {
                met.hits |= 1 << lane;
                met.t[lane] = query.scaled.unscale(t);
            } else if !(is_good && t < query.before) {
                met.open |= 1 << lane;
            }
        }
        met
    }
}
