use crate::double_double::DoubleVector;
use crate::kernel::Window;
use crate::kernel::sphere::ScaledRay;
use crate::number::{ROOT_OF_UNIT, TINY, U};
use crate::shape::Triangle;

/// The answer by signs of volumes in twice the digits, or `None` if rounding might have
/// changed even that: almost only if the ray meets an edge or a vertex exactly. What
/// [`super::filtered`] leaves open is asked here before it is decided in exact numbers,
/// which take ten times as long.
///
/// # Why the filter is right
///
/// With u the unit roundoff, a, b, c the corners less the origin, which numbers of twice
/// the digits hold without rounding, B the largest of their components and |d|∞ < 2:
///
/// 1. A sum of two such numbers is off by 3u² + 13u³ of itself at most, a product by
///    7u² (Joldes, Muller & Popescu, *ACM TOMS* 44(2), 2017, algorithms 6 and 10, which are
///    ours): 8u² serves for either.
/// 2. A component of b × c has two terms up to B² each: it is off by 2 × 8u² B² from its
///    products and 8u² × 2B² from its difference, 32u² B². A dot product of that with d
///    is off by 3 × 2 × 32u² B² from its factors, 8u² × 12B² from its products and 2 × 8u² ×
///    12B² from its sums: 480u² B². That is of each of the three volumes d·(b × c),
///    d·(c × a), d·(a × b); their sum, the determinant, is off by 3 × 480u² B² and 2 × 8u² ×
///    36B², and a·(b × c) by half of 480u² B² times B. So E = 4096u² B² bounds each volume
///    and their sum with the roundings of E itself, and E B that of t times the determinant.
/// 3. What underflows, in a product or in what a product's rounding loses, is less than
///    [`TINY`] each of some sixty times, and is multiplied by 4 + B at most: 1024
///    [`TINY`] (1 + B)² and (1 + B)³ are added. What overflows makes B, a bound or
///    a volume infinite or NaN, and all comparisons are written so that both are open.
#[cold]
#[inline(never)]
pub fn double_double_filter(
    triangle: &Triangle<f64>,
    scaled: &ScaledRay<f64>,
    window: &Window,
) -> Option<Option<f64>> {
    let d = DoubleVector::of(scaled.ray.direction);
    let from_origin = |corner| DoubleVector::between(corner, scaled.ray.origin);
    let corners = triangle.corners.map(from_origin);
    let largest = corners.map(DoubleVector::largest);
    let size = largest[0].max(largest[1]).max(largest[2]);
    let underflow = 1024.0 * TINY * (1.0 + size) * (1.0 + size);
    let bound = 4096.0 * U * U * size * size + underflow;

    let [a, b, c] = corners;
    let b_cross_c = b.cross(c);
    let volumes = [d.dot(b_cross_c), d.dot(c.cross(a)), d.dot(a.cross(b))];
    let is_sure = volumes.map(|volume| volume.high.abs() > bound);
    let is_negative = volumes.map(|volume| volume.high < 0.0);
    let surely = |side: bool| (0..3).any(|at| is_sure[at] && is_negative[at] == side);
    if surely(true) && surely(false) {
        return Some(None);
    }
    if is_sure != [true; 3] {
        return None;
    }

    // As in exact numbers: a·(b × c) = t (u + v + w).
    let [u, v, w] = volumes;
    let upright = |number: f64| if is_negative[0] { -number } else { number };
    let determinant = upright((u + v + w).high);
    let volume = upright(a.dot(b_cross_c).high);
    let half = 0.5 * ROOT_OF_UNIT;
    // Both are good to ½√u, and so t is to √u.
    match half * determinant > bound && half * volume.abs() > bound * (1.0 + size) {
        true => window.answer(volume / determinant, scaled),
        false => None,
    }
}
