use super::adaptive::nearest_root;
use crate::kernel::{Limits, ScaledQuery};
use crate::number::{TINY, U};
use crate::shape::Sphere;
use crate::vector::Vector;

/// The filter of [`super::adaptive`] for rays that all start at the same eye. f = e − c and c =
/// |f|² − r² are computed once, and most misses are certain without a division.
///
/// # Why the filter is right
///
/// The ray's line misses if h² < a c, with a = d·d and h = d·f. In the terms of
/// [`super::adaptive`], the error of h is at most 4u|d||f|, that of a at most 3u a, and that of c
/// at most 8u (|f|² + r²). So the true h² exceeds the computed one by at most 10.2u a |f|², and if
/// the computed h² is below a (c − 32u (|f|² + r²)), the true one is below a c. (10.2u come from
/// h², 8u from c, and 4.2u from a and the product.) If c > 0 and h ≥ 0, the sphere is behind the
/// eye. Otherwise, the answer is that of [`super::adaptive`].
#[derive(Clone, Copy, Debug)]
pub struct SphereFromEye {
    f: Vector<f64>,
    r_square: f64,
    c: f64,
    /// c, less its error and those of h² and a.
    least_c: f64,
}

impl SphereFromEye {
    /// The constants of a sphere; `None` if a square might overflow.
    pub fn new(sphere: &Sphere<f64>, eye: Vector<f64>) -> Option<SphereFromEye> {
        let f = eye - sphere.center;
        let (f_square, r_square) = (f.dot(f), sphere.radius * sphere.radius);
        let c = f_square - r_square;
        let is_small = (64.0 * (f_square + r_square)).is_finite();
        is_small.then_some(SphereFromEye {
            f,
            r_square,
            c,
            least_c: c - 32.0 * U * (f_square + r_square) - 128.0 * TINY,
        })
    }

    /// A smaller [`Limits::divisor`] than that of [`super::adaptive`], for eyes that are not near
    /// the surface: infinite for others.
    ///
    /// The error of the root in q is at most a (12u r|f| + 72u²|f|² + 4u r²) / root, and that of h
    /// at most 4u|d||f|. If q² is a|c| or more, which it always is, both together are below half
    /// the accuracy times q if 64u (|f| + r) (r + 6u|f|) is below the accuracy times √(|c| (r² −
    /// |l|²)), and 64u |f| below the accuracy times √|c|.
    pub fn divisor(&self, size: f64, accuracy: f64, limits: &Limits) -> f64 {
        let (lost, r, distance) = (
            64.0 * U / accuracy,
            self.r_square.sqrt(),
            self.c.abs().sqrt(),
        );
        let least = lost * (size + r) * (r + 6.0 * U * size) / distance;
        match lost * size < distance {
            true => least * least + limits.sign,
            false => f64::INFINITY,
        }
    }

    /// The answer, or `None` if rounding might have changed it.
    #[inline(always)]
    pub fn filtered(&self, query: &ScaledQuery, limits: &Limits) -> Option<Option<f64>> {
        let d = query.scaled.ray.direction;
        let (a, h) = (d.dot(d), d.dot(self.f));
        let is_behind = h >= 0.0 && self.c > limits.dividend;
        if is_behind || h * h < a * self.least_c {
            return Some(None);
        }
        nearest_root(self.f, self.r_square, || self.c, query, limits)
    }
}
