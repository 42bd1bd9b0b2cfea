use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::{Hit, Intersection, Ray};
use crate::shape::{Shape, ShapeKind};
use crate::words::{self, number};

/// Where does `ray` meet `shape`, from `min_t` on?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ShapeQuestion {
    /// The shape, alone.
    pub shape: Shape,
    /// The ray; its direction may have any length.
    pub ray: Ray,
    /// In multiples of the ray's direction.
    pub min_t: f64,
}

impl ShapeQuestion {
    pub(super) fn read(samples: Samples<'_>, shape: ShapeKind) -> Result<ShapeQuestion, String> {
        Ok(ShapeQuestion {
            shape: shape.read_samples(samples)?,
            ray: samples.ray()?,
            min_t: samples.min_t()?,
        })
    }
}

impl Question for ShapeQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        meet(&self.ray, self.min_t, &self.shape, functions).map(WireAnswer::Answer)
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        let (ray, min_t) = (words::ray(&self.ray, digits), number(self.min_t, digits));
        vec![
            Fact::new("ray", format!("{ray}, min_t = {min_t}")),
            Fact::new(self.shape.kind().name(), self.shape.words(digits)),
        ]
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let mut quantities = Quantity::of_ray(&self.ray, self.min_t);
        quantities.extend(self.shape.quantities(&self.ray));
        quantities.push(Quantity::new("t", right.t()));
        quantities.push(Quantity::new("t − min_t", right.t() - self.min_t));
        quantities
    }

    fn conditions(&self, answer: &Answer) -> Vec<Condition> {
        let hit = answer.hit().map(|hit| hit.intersection);
        let t = answer.t();
        let leaves = hit.is_some_and(|hit| self.ray.direction.dot(hit.normal) > 0.0);
        let mut conditions = vec![
            Condition::new("t is below 0", "t is 0 or more", t < 0.0),
            Condition::new("t is below min_t", "t is min_t or more", t < self.min_t),
            Condition::new("t is below 1", "t is 1 or more", t < 1.0),
            Condition::new(
                "d · n > 0 (the surface is met from behind)",
                "d · n < 0 (the surface is met from the front)",
                leaves,
            ),
        ];
        conditions.extend(self.shape.conditions(&self.ray, self.ray.at(t)));
        conditions
    }

    fn others(&self, right: &Answer) -> Vec<(&'static str, Answer)> {
        let hit = right.hit();
        let other = hit.and_then(|hit| self.shape.other(&self.ray, hit.intersection));
        let named = |(name, intersection)| {
            let object = 0;
            (
                name,
                Answer::Hit(Some(Hit {
                    object,
                    intersection,
                })),
            )
        };
        let along = hit.map(|hit| Intersection {
            normal: self.ray.direction.normalize_or_zero(),
            ..hit.intersection
        });
        let along = along.map(|hit| ("d, scaled to unit length", hit));
        other.into_iter().chain(along).map(named).collect()
    }
}

/// Where a ray meets a shape, according to the submission's function.
pub(crate) fn meet(
    ray: &Ray,
    min_t: f64,
    shape: &Shape,
    functions: &[AnswerFn],
) -> Result<Answer, Unregistered> {
    let intersect = AnswerFn::find(functions, Kind::Intersect, |function| match function {
        AnswerFn::Intersect(intersect) => Some(*intersect),
        _ => None,
    })?;
    Ok(Answer::alone(intersect(shape, ray, min_t)))
}
