use wide::f64x4;

use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// Up to four triangles in SIMD lanes: a first corner and the two edges from it, which are
/// computed once instead of at every test.
///
/// Each lane performs the same operations as [`super::MollerTrumbore`], so the results are the same
/// bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct TrianglePacket {
    corner: Vector<f64x4>,
    edges: [Vector<f64x4>; 2],
    /// A bit for each lane that contains a triangle.
    all: u32,
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

    /// Tests all lanes. The result has a bit for each triangle that is hit, and its t, in multiples
    /// of the ray's direction, which may overflow.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray<f64>, min_t: f64) -> (u32, [f64; 4]) {
        const NOTHING: (u32, [f64; 4]) = (0, [0.0; 4]);
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
            return NOTHING;
        }
        let q = s.cross(e1);
        let v = d.dot(q) * inverse;
        let inside = inside & v.simd_ge(zero) & (u + v).simd_le(one);
        let hits = inside.to_bitmask() & self.all;
        if hits == 0 {
            return NOTHING;
        }
        let t = e2.dot(q) * inverse;
        let is_ahead = t.simd_ge(f64x4::splat(min_t)).to_bitmask();
        (hits & is_ahead, t.to_array())
    }
}
