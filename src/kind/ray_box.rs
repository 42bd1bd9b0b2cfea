use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::bounds::BoundingBox;
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Part, Quantity};
use crate::ray::{Intersection, Ray};
use crate::words::{self, number};

/// Where does `ray` enter a solid box, from `min_t` to `max_t`?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BoxQuestion {
    /// The box; it may be flat.
    pub bounds: BoundingBox,
    /// The ray; its direction may have any length.
    pub ray: Ray,
    /// In multiples of the ray's direction.
    pub min_t: f64,
    /// Greater than `min_t`, in the same unit; may be infinite.
    pub max_t: f64,
}

/// A question film can't hold infinity, so a `max_t` of this or more means that there is no limit.
const ENDLESS: f64 = 1e30;

impl BoxQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<BoxQuestion, String> {
        let max_t = samples.number("max_t")?;
        Ok(BoxQuestion {
            bounds: samples.bounding_box("0")?,
            ray: samples.ray()?,
            min_t: samples.min_t()?,
            max_t: if max_t < ENDLESS {
                max_t
            } else {
                f64::INFINITY
            },
        })
    }

    /// Whether the ray is in the box at this t.
    fn is_inside_at(&self, t: f64) -> bool {
        let point = self.ray.at(t);
        point.cmpge(self.bounds.min).all() && point.cmple(self.bounds.max).all()
    }

    /// The t at which the ray passes the first and the second face of each axis; infinite or not a
    /// number where it runs parallel to them.
    fn crossings(&self) -> (DVec3, DVec3) {
        let BoundingBox { min, max } = self.bounds;
        let at = |plane: DVec3| (plane - self.ray.origin) / self.ray.direction;
        (at(min).min(at(max)), at(min).max(at(max)))
    }

    /// The component of d along the axis whose face the ray enters through after `min_t`; 0 if it
    /// is in the box at `min_t`.
    fn entered_along(&self) -> f64 {
        let (entry, _) = self.crossings();
        let crossed = (0..3).filter(|axis| entry[*axis].is_finite());
        let last = crossed.max_by(|a, b| entry[*a].total_cmp(&entry[*b]));
        let last = last.filter(|axis| entry[*axis] > self.min_t);
        last.map_or(0.0, |axis| self.ray.direction[axis])
    }

    /// Whether the ray runs in the plane of a face.
    fn runs_in_face(&self) -> bool {
        let BoundingBox { min, max } = self.bounds;
        let origin = self.ray.origin;
        let is_still = self.ray.direction.cmpeq(DVec3::ZERO);
        (is_still & (origin.cmpeq(min) | origin.cmpeq(max))).any()
    }
}

impl Question for BoxQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let ray_box = AnswerFn::find(functions, Kind::RayBox, |function| match function {
            AnswerFn::RayBox(ray_box) => Some(*ray_box),
            _ => None,
        })?;
        let t = ray_box(&self.bounds, &self.ray, self.min_t, self.max_t);
        Ok(Answer::alone(t.map(|t| Intersection {
            t,
            normal: DVec3::ZERO,
        }))
        .into())
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        let ray = words::ray(&self.ray, digits);
        let min_t = number(self.min_t, digits);
        let max_t = match self.max_t.is_finite() {
            true => number(self.max_t, digits),
            false => "∞".into(),
        };
        vec![
            Fact::new("ray", format!("{ray}, min_t = {min_t}, max_t = {max_t}")),
            Fact::new("box", self.bounds.words(digits)),
        ]
    }

    /// A box is entered or not; it has no normal.
    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        match answer.hit() {
            Some(hit) => format!("enters at t = {}", number(hit.intersection.t, digits)),
            None => "not in the box".into(),
        }
    }

    fn parts(&self, answer: &Answer) -> Option<Vec<Part>> {
        let mut parts = answer.hit()?.parts();
        parts.retain(|part| part.name != "the normal");
        Some(parts)
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let mut quantities = Quantity::of_ray(&self.ray, self.min_t);
        let size = self.bounds.max - self.bounds.min;
        quantities.push(Quantity::new("max_t", self.max_t));
        quantities.push(Quantity::new("the box's longest side", size.max_element()));
        quantities.push(Quantity::new("t", right.t()));
        quantities
    }

    fn conditions(&self, answer: &Answer) -> Vec<Condition> {
        let t = answer.t();
        let size = self.bounds.max - self.bounds.min;
        let direction = self.ray.direction;
        let along = self.entered_along();
        let count = |mask: glam::BVec3| mask.bitmask().count_ones();
        vec![
            Condition::new("t is below min_t", "t is min_t or more", t < self.min_t),
            Condition::new("t is above max_t", "t is max_t or less", t > self.max_t),
            Condition::new("t is below 0", "t is 0 or more", t < 0.0),
            Condition::new(
                "the ray's origin is in the box",
                "the ray's origin is not in the box",
                self.is_inside_at(0.0),
            ),
            Condition::new(
                "the ray is in the box at min_t",
                "the ray is not in the box at min_t",
                self.is_inside_at(self.min_t),
            ),
            Condition::new(
                "the ray is in the box at max_t",
                "the ray is not in the box at max_t",
                self.is_inside_at(self.max_t),
            ),
            Condition::new(
                "the ray runs in the plane of a face",
                "the ray does not run in the plane of a face",
                self.runs_in_face(),
            ),
            Condition::new(
                "the box is flat",
                "the box is not flat",
                size.min_element() == 0.0,
            ),
            Condition::new(
                "a component of d is 0",
                "no component of d is 0",
                direction.abs().min_element() == 0.0,
            ),
            Condition::new(
                "a component of d is negative",
                "no component of d is negative",
                direction.min_element() < 0.0,
            ),
            Condition::new(
                "a component of d is positive",
                "no component of d is positive",
                direction.max_element() > 0.0,
            ),
            Condition::new(
                "two or three components of d are negative",
                "at most one component of d is negative",
                count(direction.cmplt(DVec3::ZERO)) > 1,
            ),
            Condition::new(
                "two or three components of d are positive",
                "at most one component of d is positive",
                count(direction.cmpgt(DVec3::ZERO)) > 1,
            ),
            Condition::new(
                "the ray enters through a face that touches the box's min corner",
                "the ray does not enter through a face that touches the box's min corner",
                along > 0.0,
            ),
            Condition::new(
                "the ray enters through a face that touches the box's max corner",
                "the ray does not enter through a face that touches the box's max corner",
                along < 0.0,
            ),
        ]
    }

    fn others(&self, _: &Answer) -> Vec<(&'static str, Answer)> {
        let (first, second) = self.crossings();
        let crossed = (0..3).filter(|axis| self.ray.direction[*axis] != 0.0);
        let entry = crossed.clone().map(|axis| first[axis]);
        let exit = crossed.map(|axis| second[axis]);
        let leave = exit.clone().fold(self.max_t, f64::min);
        let at = |t| {
            let normal = DVec3::ZERO;
            Answer::alone(Some(Intersection { t, normal }))
        };
        vec![
            (
                "the smallest of min_t and the three values of t at which the ray enters a slab",
                at(entry.fold(self.min_t, f64::min)),
            ),
            (
                "the greatest of min_t and the three values of t at which the ray leaves a slab",
                at(exit.fold(self.min_t, f64::max)),
            ),
            ("the t at which the ray leaves the box", at(leave)),
            ("the smaller t of the two x faces", at(first.x)),
            ("the smaller t of the two y faces", at(first.y)),
            ("the smaller t of the two z faces", at(first.z)),
            ("the larger t of the two x faces", at(second.x)),
            ("the larger t of the two y faces", at(second.y)),
            ("the larger t of the two z faces", at(second.z)),
        ]
    }
}
