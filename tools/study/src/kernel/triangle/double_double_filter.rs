use crate::double_double::DoubleDouble;
use crate::kernel::ScaledQuery;
use crate::number::{TINY, U};
use crate::shape::Triangle;
use crate::vector::Vector;

/// The double-double filter: the answer by signs of volumes in double-double arithmetic, or
/// `None` if rounding might have changed even that, which happens almost only if the ray hits
/// an edge or a vertex exactly. It gets what [`super::adaptive`] leaves undecided, because
/// exact arithmetic takes ten times as long. The relative error of t is at most 3u.
///
/// # Why the filter is right
///
/// Let u be the unit roundoff and |d|∞ < 2. Let a, b, c be the corners minus the origin, which
/// double-doubles represent exactly, and B their largest component:
///
/// 1. The relative error of a double-double sum is at most 3u² + 13u³, and that of a product at
///    most 7u² (Joldes, Muller & Popescu, *ACM TOMS* 44(2), 2017, algorithms 6 and 10, which
///    are the ones used here). 8u² bounds both.
/// 2. A component of b × c has two terms up to B² each. Its error is at most 2 × 8u² B² from
///    the products plus 8u² × 2B² from the difference: 32u² B². The error of its dot product
///    with d is at most 3 × 2 × 32u² B² from the factors, 8u² × 12B² from the products and 2 ×
///    8u² × 12B² from the sums: 480u² B². This holds for each of the three volumes d·(b × c),
///    d·(c × a) and d·(a × b). The error of their sum, the determinant, is at most 3 × 480u² B² +
///    2 × 8u² × 36B², and that of a·(b × c) half of 480u² B² times B. So E = 4096u² B² bounds
///    the error of each volume and of their sum, including the roundings of E itself, and E B
///    that of t times the determinant.
/// 3. Underflow, in a product or in a product's low part, loses less than [`TINY`] in each of
///    some sixty places, and is multiplied by at most 4 + B. 1024 [`TINY`] (1 + B)² and (1 +
///    B)³ are added to the bounds for it. Overflow makes B, a bound or a volume infinite or
///    NaN, and comparisons are written so that the filter then does not decide.
#[cold]
#[inline(never)]
pub fn double_double_filter(triangle: &Triangle<f64>, query: &ScaledQuery) -> Option<Option<f64>> {
    let d = query.scaled.ray.direction.map(DoubleDouble::from);
    let from_origin = |corner| Vector::between(corner, query.scaled.ray.origin);
    let corners = triangle.corners.map(from_origin);
    let largest = corners.map(|corner| corner.rounded().largest());
    let size = largest[0].max(largest[1]).max(largest[2]);
    let underflow = 1024.0 * TINY * (1.0 + size) * (1.0 + size);
    let error = 4096.0 * U * U * size * size;
    let (bound, bound_of_volume) = (error + underflow, error * size + underflow * (1.0 + size));

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

    // As in the exact kernel, a·(b × c) = t (u + v + w).
    let [u, v, w] = volumes;
    let upright = |number: f64| if is_negative[0] { -number } else { number };
    let determinant = upright((u + v + w).high);
    let volume = upright(a.dot(b_cross_c).high);
    // The relative errors of dividend and divisor are at most u, so the error of t is at most 3u.
    match U * determinant > bound && U * volume.abs() > bound_of_volume {
        true => query.answer(volume / determinant),
        false => None,
    }
}
