//! The true first hit of a ray in a scene: exact arithmetic on every part, except those that
//! the ray misses by far. This shares no intersection code with the casters.

use std::cmp::Ordering;

use dashu_int::ops::Abs;
use pinhole::Hit;
use serde::Serialize;

use super::{Exact, HasTruth, Root, Truth, sign};
use crate::cast::world::{Part, Primitive, of_each, vector};
use crate::question::Question;
use crate::shape::Ray;
use crate::vector::Vector;

/// What a ray truly hits first; `None` for a miss. Edges count as hits, and of parts at exactly the
/// same t, the one listed first wins.
pub type TrueHit<'a> = Option<(&'a Part, Root)>;

/// The errors of a film, or of every so many pixels of one.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct FilmErrors {
    /// Rays that were judged.
    pub rays: u64,
    /// Rays for which the object is wrong, a hit is missed, or a miss is a hit.
    pub wrong_ids: u64,
    /// Rays whose t or normal has a larger error than was requested.
    pub violations: u64,
    /// The largest relative error of t, where the object is right.
    pub worst_t: f64,
    /// The largest angle between a normal and the true one, in radians.
    pub worst_normal: f64,
}

/// Compares answers with the truth. `accuracy` is what was requested for t and normals.
pub fn errors(
    rays: &[Ray<f64>],
    truths: &[TrueHit],
    answers: Vec<Option<Hit>>,
    accuracy: f64,
) -> FilmErrors {
    let mut errors = FilmErrors {
        rays: rays.len() as u64,
        ..FilmErrors::default()
    };
    for ((ray, truth), answer) in rays.iter().zip(truths).zip(answers) {
        match (truth, answer) {
            (None, None) => (),
            (Some((part, root)), Some(hit)) if part.object as usize == hit.object => {
                let (t, direction) = (hit.intersection.t, vector(hit.intersection.normal));
                // Use both sine and cosine, because the sine alone is also small near π.
                let truth = normal(&part.shape, ray, root);
                let off = truth.cross(direction);
                let angle = off.dot(off).sqrt().atan2(truth.dot(direction));
                let of_t = root.relative_error(t);
                errors.violations += u64::from(!(of_t <= accuracy && angle <= accuracy));
                errors.worst_t = errors.worst_t.max(of_t);
                errors.worst_normal = errors.worst_normal.max(angle);
            }
            _ => errors.wrong_ids += 1,
        }
    }
    errors
}

/// The true first hit with t ≥ `min_t`.
pub fn sight<'a>(parts: &'a [Part], ray: &Ray<f64>, min_t: f64) -> TrueHit<'a> {
    let near = parts
        .iter()
        .filter(|part| !is_passed_by_far(&part.shape, ray));
    let met = near.filter_map(|part| Some((part, truth(&part.shape, ray, min_t).t?)));
    met.min_by(|(p, one), (q, other)| order(one, other).then(p.place.cmp(&q.place)))
}

fn truth(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> Truth {
    let (ray, shape) = (*ray, *shape);
    of_each!(shape, shape => HasTruth::truth(&Question { shape, ray, min_t }))
}

/// The unit outward normal at `t`, exact up to the final rounding and normalisation.
pub fn normal(shape: &Primitive, ray: &Ray<f64>, t: &Root) -> Vector<f64> {
    let along = match shape {
        Primitive::Plane(plane) => Exact::of(plane.normal),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(Exact::of);
            b.minus(&a).cross(&c.minus(&a))
        }
        Primitive::Sphere(sphere) => {
            let from_center = Exact::of(ray.origin).minus(&Exact::of(sphere.center));
            let (e, d) = (from_center.0, Exact::of(ray.direction).0);
            Exact([0, 1, 2].map(|at| &e[at] + &t.exact * &d[at]))
        }
    };
    // Divide by the largest component, so that the conversion to floats neither underflows nor
    // overflows.
    let magnitudes = along.0.iter().map(|number| number.clone().abs());
    let largest = magnitudes.max().filter(|number| sign(number) > 0);
    let largest = largest.unwrap_or(super::fraction(1.0));
    let [x, y, z] = along.0.map(|number| (number / &largest).to_f64().value());
    let along = Vector::new(x, y, z);
    along * (1.0 / along.dot(along).sqrt())
}

/// Orders hits by t. Fractions compare exactly. A sphere's root is known to more than 300 bits,
/// and two roots that agree in 280 bits count as equal.
fn order(p: &Root, q: &Root) -> Ordering {
    let apart = &p.exact - &q.exact;
    let grain = &p.exact * super::fraction(2f64.powi(-280));
    match sign(&(&apart * &apart - &grain * &grain)) > 0 {
        true => sign(&apart).cmp(&0),
        false => Ordering::Equal,
    }
}

/// Whether a line misses a shape by so much that rounding cannot matter: by more than its size
/// plus a millionth of its distance. The squares must be in range.
fn is_passed_by_far(shape: &Primitive, ray: &Ray<f64>) -> bool {
    let (middle, radius) = match shape {
        Primitive::Plane(_) => return false,
        Primitive::Sphere(sphere) => (sphere.center, sphere.radius),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners;
            let reach = |p: Vector<f64>| (p - a).dot(p - a).sqrt();
            (a, reach(b).max(reach(c)))
        }
    };
    let to = middle - ray.origin;
    let across = to.cross(ray.direction);
    let (length, distance) = (ray.direction.dot(ray.direction), to.dot(to));
    let size = radius + 1e-6 * (radius + distance.sqrt());
    let (across, bound) = (across.dot(across), size * size * length * (1.0 + 1e-6));
    // Smaller squares may have lost digits, and larger ones overflow.
    bound > 1e-250 && length > 1e-250 && across.is_finite() && across > bound
}
