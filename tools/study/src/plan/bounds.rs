//! How far rounding can have moved t and the normal of a hit.
//!
//! Forward error bounds in the manner of Higham, *Accuracy and Stability of Numerical
//! Algorithms*, 2nd ed., §§2–3: one operation is off by a factor 1 + δ, |δ| ≤ u, and
//! what a formula makes of that is counted to first order, with constants that are
//! rounded up and leave room for the rest. Each is written for numbers that are known of
//! one hit, and holds as well for the worst numbers of a whole scene
//! ([`super::extent`]). The kernels are those of [`crate::cast::kernels::Usual`]; the
//! adaptive ones filter with the same formulas.
//!
//! In `f32` the scene itself is rounded first, each coordinate by u of itself; `i` below
//! is u there, and 0 in `f64`, which holds scenes and rays as they are.

use crate::number::Real;

/// How a type of numbers rounds.
#[derive(Clone, Copy, Debug)]
pub struct Rounding {
    /// u, of one operation.
    pub unit: f64,
    /// i, of a coordinate that is put in.
    pub input: f64,
}

impl Rounding {
    /// Scene and arithmetic in `f32`.
    pub const F32: Rounding = Rounding {
        unit: f32::UNIT_ROUNDOFF as f64,
        input: f32::UNIT_ROUNDOFF as f64,
    };
    /// Scene and arithmetic in `f64`.
    pub const F64: Rounding = Rounding {
        unit: f64::UNIT_ROUNDOFF,
        input: 0.0,
    };
}

/// How far t may be off, as a part of itself, and the normal, in radians. Infinite where
/// nothing is certain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Relative to t.
    pub t: f64,
    /// The angle.
    pub normal: f64,
}

impl Bound {
    /// Nothing is known.
    pub const NONE: Bound = Bound {
        t: f64::INFINITY,
        normal: f64::INFINITY,
    };

    /// The worse of both, in each.
    pub fn worse(self, other: Bound) -> Bound {
        Bound {
            t: self.t.max(other.t),
            normal: self.normal.max(other.normal),
        }
    }
}

/// An error as a part of the true number, given what was computed of both.
fn part(error: f64, computed: f64) -> f64 {
    match error < 0.5 * computed {
        true => error / (computed - error),
        false => f64::INFINITY,
    }
}

/// What is known of rays that meet a sphere.
#[derive(Clone, Copy, Debug)]
pub struct OfSphere {
    /// |e|, at most.
    pub origin: f64,
    /// |c|.
    pub center: f64,
    /// |e − c|, at most.
    pub away: f64,
    /// r.
    pub radius: f64,
    /// s² = r² − |l|², l from the centre to the line: how deep a ray enters, at least.
    pub depth_square: f64,
    /// |d·f| / |d|, at least, f = e − c.
    pub along: f64,
    /// ||f|² − r²|, at least; `None` where t does not come from it.
    pub constant: Option<f64>,
    /// t |d|, at most.
    pub length: f64,
}

impl OfSphere {
    /// With φ = u|f| + i(|e| + |c|) the error of f:
    ///
    /// 1. l is off by λ = 16u|f| + i(|e| + |c| + 2|f|): the 12u|f| of
    ///    [`crate::kernel::sphere::Adaptive`], φ, and a direction turned by i.
    /// 2. s² = r² − |l|² is off by ω = 2(r + λ)λ + λ² + 8u(r + λ)² + 2i r², hence s by
    ///    σ = ω/(s + ŝ) ≤ ω/s; and by √ω at most, however flat the ray grazes.
    /// 3. t|d| is q/a or c/q with q = |h| + s, off by λ + σ and six roundings; c = |f|² −
    ///    r² by χ = 2|f|φ + φ² + 6u|f|² + (3u + 2i) r². q ≥ √|c| always: q² ≥ h² + s² and
    ///    h² + s² = |f|² + r² − 2|l|², which |l| ≤ r or |l| ≤ |f| makes ≥ |c|.
    /// 4. The normal turns by what moves the point, over r.
    pub fn bound(&self, Rounding { unit: u, input: i }: Rounding) -> Bound {
        let (f, r) = (self.away, self.radius);
        let put_in = i * (self.origin + self.center);
        let lambda = 16.0 * u * f + put_in + 2.0 * i * f;
        let reach = r + lambda;
        let omega =
            2.0 * reach * lambda + lambda * lambda + 8.0 * u * reach * reach + 2.0 * i * r * r;
        let depth = (self.depth_square - omega).max(0.0).sqrt();
        let sigma = (omega / depth).min(omega.sqrt()) + 4.0 * u * r;
        let c = self.constant.unwrap_or(0.0);
        let q = ((self.along - lambda).max(0.0) + depth).max(c.sqrt());
        let mut t = part(lambda + sigma, q) + 6.0 * u + i;
        if self.constant.is_some() {
            let chi =
                2.0 * f * put_in + put_in * put_in + 8.0 * u * f * f + (3.0 * u + 2.0 * i) * r * r;
            t += part(chi, c);
        }
        let moved = t * self.length
            + u * (self.origin + 3.0 * self.length + r)
            + i * (self.origin + self.center + self.length);
        Bound {
            t,
            normal: 1.1 * part(moved, r) + 5.0 * u,
        }
    }
}

/// What is known of rays that meet a plane n·(x − p) = 0.
#[derive(Clone, Copy, Debug)]
pub struct OfPlane {
    /// |n·d|, at least.
    pub down: f64,
    /// Σ|nᵢ||dᵢ|, at most.
    pub down_terms: f64,
    /// |n·(p − e)|, at least.
    pub height: f64,
    /// Σ|nᵢ||pᵢ − eᵢ|, at most.
    pub height_terms: f64,
    /// Σ|nᵢ|(|pᵢ| + |eᵢ|), at most.
    pub far_terms: f64,
}

impl OfPlane {
    /// A dot product of three terms is off by 8u of the sum of its terms' magnitudes, the
    /// subtraction p − e included (as in [`crate::kernel::plane::Adaptive`]); rounding n
    /// and d adds 2i of them, rounding p and e adds i of theirs.
    pub fn bound(&self, Rounding { unit: u, input: i }: Rounding) -> Bound {
        let down = (8.0 * u + 2.0 * i) * self.down_terms;
        let height = (8.0 * u + i) * self.height_terms + i * self.far_terms;
        let (down, height) = (part(down, self.down), part(height, self.height));
        Bound {
            t: (down + height) * (1.0 + down) + 2.0 * u,
            normal: 5.0 * u + 2.0 * i,
        }
    }
}

/// What is known of rays that meet a triangle.
#[derive(Clone, Copy, Debug)]
pub struct OfTriangle {
    /// M, the largest component of two edges.
    pub size: f64,
    /// |e₁ × e₂|.
    pub area: f64,
    /// The largest component of its corners.
    pub corner: f64,
    /// S, the largest component of e − a, at most.
    pub away: f64,
    /// The largest component of e, at most.
    pub origin: f64,
    /// The largest component of d, at most.
    pub direction: f64,
    /// |d|, at least.
    pub direction_length: f64,
    /// |d·(e₁ × e₂)|, at least.
    pub determinant: f64,
    /// |(e − a)·(e₁ × e₂)| = t times the determinant, at least.
    pub volume: f64,
    /// t |d|, at most.
    pub length: f64,
    /// The least of the hit's three weights (barycentric coordinates), if which triangle
    /// is met matters: beyond an edge its neighbour is.
    pub margin: Option<f64>,
}

impl OfTriangle {
    /// The determinant of Möller–Trumbore has six products of components, each off by 2uM
    /// for an edge and by five roundings: 48u M² |d|; so have the volume, 54u S M², and
    /// the other two, 48u S M |d| (cf. [`crate::kernel::triangle::Adaptive`]).
    ///
    /// Rounding the corners moves every point *inside* by √3 i (C + E + t|d|) at most,
    /// however small the triangle; along the ray that is 1/cos of the angle to the
    /// normal as much, the cosine being |volume| / (t |d| |e₁ × e₂|) and no smaller than
    /// what its own errors leave of it. The normal itself turns by 12 i C M / |e₁ × e₂|, and by 28u M² of
    /// the same for its own arithmetic.
    pub fn bound(&self, Rounding { unit: u, input: i }: Rounding) -> Bound {
        let (m, s, d) = (self.size, self.away, self.direction);
        let turned = part(28.0 * u * m * m + 12.0 * i * self.corner * m, self.area);
        let of_determinant = part(48.0 * u * m * m * d, self.determinant);
        let of_volume = part(54.0 * u * s * m * m, self.volume);
        let moved = 3f64.sqrt() * i * (self.corner + self.origin + self.length);
        // t |d| times the cosine is how far the eye is from the triangle's plane.
        let plane = self.volume / self.area;
        let tilted = self.length
            * (turned + of_determinant * self.determinant / (self.area * self.direction_length));
        let room = plane - of_volume * plane - tilted;
        let of_input = match i > 0.0 {
            false => 0.0,
            true if room > moved => moved / room + 2.0 * i,
            true => f64::INFINITY,
        };
        let t = (of_determinant + of_volume) * (1.0 + of_determinant) + of_input + 3.0 * u;
        let aside = part(48.0 * u * s * m * d, self.determinant)
            + 1.2 * moved * 3f64.sqrt() * m * 3f64.sqrt() * d / self.determinant
            + 4.0 * u;
        let is_certain = self.margin.is_none_or(|margin| margin > aside);
        Bound {
            t,
            normal: match is_certain {
                true => turned + 5.0 * u,
                false => f64::INFINITY,
            },
        }
    }
}
