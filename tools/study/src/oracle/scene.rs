//! The true first hit of a ray in a scene: exact arithmetic on every part, except those that
//! the ray misses by far. This shares no intersection code with the casters.

use std::cmp::Ordering;

use dashu_ratio::Relaxed;

use super::{Exact, HasTruth, Root, Truth, sign};
use crate::cast::world::{Part, Primitive};
use crate::question::Question;
use crate::shape::Ray;
use crate::vector::Vector;

/// What a ray truly hits, with the answers that are accepted.
#[derive(Clone, Debug)]
pub struct TrueHit<'a> {
    /// The part that is hit first, and where; `None` for a miss.
    pub first: Option<(&'a Part, Truth)>,
    /// Objects that are also accepted, because the ray only touches them at an edge or tangent,
    /// before the first hit or at the same t.
    pub also: Vec<u32>,
    /// Whether a miss is accepted too, because the ray only touches every object that it meets.
    pub may_be_nothing: bool,
}

impl TrueHit<'_> {
    /// Whether this object, or a miss, is an accepted answer.
    pub fn allows(&self, object: Option<u32>) -> bool {
        let first = self.first.as_ref().map(|(part, _)| part.object);
        match object {
            None => first.is_none() || self.may_be_nothing,
            Some(object) => first == Some(object) || self.also.contains(&object),
        }
    }
}

/// An answer compared with the true first hit.
#[derive(Clone, Copy, Debug)]
pub enum HitComparison<'a> {
    /// Both miss, or the answer is accepted because an exact equality decides.
    Alike,
    /// The wrong object, a miss instead of a hit, or a hit instead of a miss.
    AnotherObject,
    /// The right object.
    Off {
        /// The part that is truly hit.
        part: &'a Part,
        /// The error of t, relative to the true one.
        t: f64,
        /// The angle between the normals, in radians.
        normal: f64,
    },
}

impl<'a> TrueHit<'a> {
    /// Compares an answer (object, t and normal) with the truth.
    pub fn compared(
        &self,
        ray: &Ray<f64>,
        seen: Option<(u32, f64, Vector<f64>)>,
    ) -> HitComparison<'a> {
        if !self.allows(seen.map(|(object, ..)| object)) {
            return HitComparison::AnotherObject;
        }
        let (Some((part, met)), Some((object, t, direction))) = (&self.first, seen) else {
            return HitComparison::Alike;
        };
        let Some(root) = met.t.as_ref().filter(|_| part.object == object) else {
            return HitComparison::Alike;
        };
        // Use both sine and cosine, because the sine alone is also small near π.
        let truth = normal(&part.shape, ray, root);
        let off = truth.cross(direction);
        HitComparison::Off {
            part,
            t: root.relative_error(t),
            normal: off.dot(off).sqrt().atan2(truth.dot(direction)),
        }
    }
}

/// The true first hit with t ≥ `min_t`.
pub fn sight<'a>(parts: &'a [Part], ray: &Ray<f64>, min_t: f64) -> TrueHit<'a> {
    let near = parts
        .iter()
        .filter(|part| !is_passed_by_far(&part.shape, ray));
    let mut met: Vec<(&Part, Truth)> = near
        .map(|part| (part, truth(&part.shape, ray, min_t)))
        .filter(|(_, truth)| truth.t.is_some())
        .collect();
    met.sort_by(|(p, one), (q, other)| order(one, other).then(p.place.cmp(&q.place)));
    let touched = met.iter().take_while(|(_, truth)| truth.is_tie).count();
    let last = met.get(touched.min(met.len().saturating_sub(1)));
    let together = met
        .iter()
        .filter(|(_, truth)| last.is_some_and(|(_, last)| order(truth, last) != Ordering::Greater));
    TrueHit {
        also: together.map(|(part, _)| part.object).collect(),
        may_be_nothing: touched == met.len(),
        first: met.into_iter().next(),
    }
}

fn truth(shape: &Primitive, ray: &Ray<f64>, min_t: f64) -> Truth {
    fn of<S: HasTruth>(shape: S, ray: &Ray<f64>, min_t: f64) -> Truth {
        S::truth(&Question {
            shape,
            ray: *ray,
            min_t,
        })
    }
    match shape {
        Primitive::Sphere(shape) => of(*shape, ray, min_t),
        Primitive::Plane(shape) => of(*shape, ray, min_t),
        Primitive::Triangle(shape) => of(*shape, ray, min_t),
    }
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
            let [e, d] = [from_center.0, Exact::of(ray.direction).0];
            let at = e.iter().zip(&d).map(|(e, d)| e + &t.exact * d);
            Exact(
                at.collect::<Vec<_>>()
                    .try_into()
                    .expect("there are three components"),
            )
        }
    };
    // Divide by the largest component, so that the conversion to floats neither underflows nor
    // overflows.
    let magnitude = |number: &Relaxed| match sign(number) < 0 {
        true => -number.clone(),
        false => number.clone(),
    };
    let larger = |p: Relaxed, q: Relaxed| if p < q { q } else { p };
    let largest = along.0.iter().map(magnitude).reduce(larger);
    let largest = largest.filter(|number| sign(number) > 0);
    let largest = largest.unwrap_or(super::fraction(1.0));
    let [x, y, z] = along.0.map(|number| (number / &largest).to_f64().value());
    let along = Vector::new(x, y, z);
    along * (1.0 / along.dot(along).sqrt())
}

/// Orders hits by t. Fractions compare exactly. A sphere's root is known to more than 300 bits,
/// and two roots that agree in 280 bits count as equal.
fn order(one: &Truth, other: &Truth) -> Ordering {
    let (Some(p), Some(q)) = (&one.t, &other.t) else {
        return one.t.is_none().cmp(&other.t.is_none());
    };
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
