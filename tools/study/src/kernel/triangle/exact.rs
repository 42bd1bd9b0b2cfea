use crate::dyadic::{Dyadic, DyadicVector};
use crate::number::Real;
use crate::root::Root;
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// The answer by exact signs. Edges and corners belong to the triangle: a ray exactly through
/// one hits, whichever of its triangles is asked.
#[cold]
#[inline(never)]
pub fn exact<F: Real>(triangle: &Triangle<F>, ray: &Ray<F>, min_t: F) -> Option<Root> {
    let finite = |vector: Vector<F>| vector.array().into_iter().all(F::is_finite);
    let points = finite(ray.origin) && triangle.corners.into_iter().all(finite);
    if !(points && finite(ray.direction) && min_t.is_finite()) {
        return None;
    }
    let (e, d) = (
        DyadicVector::of(ray.origin),
        DyadicVector::of(ray.direction),
    );
    let [a, b, c] = triangle
        .corners
        .map(|corner| &DyadicVector::of(corner) - &e);
    let b_cross_c = b.cross(&c);
    let (u, v, w) = (d.dot(&b_cross_c), d.dot(&c.cross(&a)), d.dot(&a.cross(&b)));
    let signs = [u.sign(), v.sign(), w.sign()];
    if signs.contains(&1) && signs.contains(&-1) {
        return None;
    }
    // a·(b × c) = t d·((b − a) × (c − a)), and the latter is u + v + w: 0 if the ray lies in
    // the triangle's plane or the triangle has no area, neither of which is a hit.
    let (volume, determinant) = (a.dot(&b_cross_c), &(&u + &v) + &w);
    let beyond = &volume - &(&Dyadic::of(min_t) * &determinant);
    if determinant.sign() == 0 || beyond.sign() * determinant.sign() < 0 {
        return None;
    }
    Some(Root::fraction(volume, determinant))
}
