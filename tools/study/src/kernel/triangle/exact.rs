use crate::dyadic::{Dyadic, DyadicVector};
use crate::number::Real;
use crate::root::Root;
use crate::shape::{Ray, Triangle};
use crate::vector::Vector;

/// The answer by exact signs, ties decided.
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
    let u = d.dot(&b_cross_c);
    let u_side = side(&u, &b_cross_c, &b, &c, &d);
    let c_cross_a = c.cross(&a);
    let v = d.dot(&c_cross_a);
    if side(&v, &c_cross_a, &c, &a, &d) != u_side {
        return None;
    }
    let a_cross_b = a.cross(&b);
    let w = d.dot(&a_cross_b);
    if side(&w, &a_cross_b, &a, &b, &d) != u_side {
        return None;
    }
    // a·(b × c) = t d·((b − a) × (c − a)), and the latter is u + v + w.
    let (volume, determinant) = (a.dot(&b_cross_c), &(&u + &v) + &w);
    let beyond = &volume - &(&Dyadic::of(min_t) * &determinant);
    if determinant.sign() == 0 || beyond.sign() * determinant.sign() < 0 {
        return None;
    }
    Some(Root::fraction(volume, determinant))
}

/// On which side of the edge from p to q the ray passes: the sign of d·(p × q), and where
/// that is 0, the sign it takes when the ray is moved a little, always the same way
/// (simulation of simplicity; Edelsbrunner & Mücke, *ACM TOG* 9(1), 1990).
///
/// With d + ε for d and e + δ for e, the volume is d·(p × q) + ε·(p × q) + δ·(d × s) +
/// δ·(ε × s), s = q − p, and nothing more. Let every component of ε be infinitely smaller
/// than the one before, and likewise δ, and δ than ε: then the first coefficient that is
/// not 0 has the sign. Not all are, if p ≠ q. So all triangles see one and the same moved
/// ray, which meets no edge and no vertex; and the edge from q to p has the opposite side.
///
/// A triangle in whose plane the ray lies is met by the moved ray at t ≈ 0 or not at
/// all; it is called missed, for its determinant is 0.
fn side(
    volume: &Dyadic,
    p_cross_q: &DyadicVector,
    p: &DyadicVector,
    q: &DyadicVector,
    d: &DyadicVector,
) -> i32 {
    if volume.sign() != 0 {
        return volume.sign();
    }
    let s = q - p;
    let [x, y, z] = &s.0;
    let turned = [-z.clone(), y.clone(), -x.clone()];
    let by_origin = d.cross(&s);
    let mut coefficients = p_cross_q.0.iter().chain(&by_origin.0).chain(&turned);
    coefficients
        .find_map(|coefficient| Some(coefficient.sign()).filter(|sign| *sign != 0))
        .unwrap_or(0)
}
