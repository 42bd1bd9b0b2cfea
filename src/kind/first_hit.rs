use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::{Hit, Ray};
use crate::shape::{Canned, Shape};
use crate::words::{self, number};

/// Which of these objects does `ray` meet first, from `min_t` on?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ObjectsQuestion {
    /// Objects that know their intersections with `ray`, in any order.
    pub objects: Vec<Canned>,
    /// The ray.
    pub ray: Ray,
    /// In multiples of the ray's direction.
    pub min_t: f64,
}

impl ObjectsQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<ObjectsQuestion, String> {
        Ok(ObjectsQuestion {
            objects: Canned::read_all(samples)?,
            ray: samples.ray()?,
            min_t: samples.min_t()?,
        })
    }
}

impl Question for ObjectsQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let first_hit = AnswerFn::find(functions, Kind::FirstHit, |function| match function {
            AnswerFn::FirstHit { canned, .. } => Some(*canned),
            _ => None,
        })?;
        Ok(Answer::Hit(first_hit(&self.ray, self.min_t, &self.objects)).into())
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        facts(&self.objects, self.min_t, digits)
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let mut quantities = Quantity::of_ray(&self.ray, self.min_t);
        quantities.push(Quantity::new("t", right.t()));
        quantities
    }

    fn conditions(&self, answer: &Answer) -> Vec<Condition> {
        conditions(&self.objects, self.min_t, answer)
    }

    fn others(&self, _: &Answer) -> Vec<(&'static str, Answer)> {
        others(&self.objects, self.min_t)
    }

    /// Only this kind of question asks which object is hit.
    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        words::hit(answer.hit(), digits)
    }
}

/// A question about canned objects in words. The ray itself does not matter to them.
pub(super) fn facts(objects: &[Canned], min_t: f64, digits: usize) -> Vec<Fact> {
    let objects = Canned::describe_all(objects, digits);
    vec![
        Fact::new("min_t", number(min_t, digits)),
        Fact::new("objects", format!("met at t = {{ {objects} }}")),
    ]
}

/// Conditions on a list of canned objects and an answer about it.
pub(super) fn conditions(objects: &[Canned], min_t: f64, answer: &Answer) -> Vec<Condition> {
    let found: Vec<bool> = objects
        .iter()
        .map(|object| object.first_from(min_t).is_some())
        .collect();
    let hits = found.iter().filter(|found| **found).count();
    let before = |object: &Canned| object.intersections.iter().any(|at| at.t < min_t);
    let t = answer.t();
    let is = |condition: Option<&bool>| condition == Some(&true);
    vec![
        Condition::new("t is below min_t", "t is min_t or more", t < min_t),
        Condition::new(
            "the list is empty",
            "the list is not empty",
            objects.is_empty(),
        ),
        Condition::new(
            "the ray meets several listed objects at min_t or beyond",
            "the ray meets at most one listed object at min_t or beyond",
            hits > 1,
        ),
        Condition::new(
            "the ray meets the first listed object at min_t or beyond",
            "the ray doesn't meet the first listed object at min_t or beyond",
            is(found.first()),
        ),
        Condition::new(
            "the ray meets the last listed object at min_t or beyond",
            "the ray doesn't meet the last listed object at min_t or beyond",
            is(found.last()),
        ),
        Condition::new(
            "at least one listed object isn't met at min_t or beyond",
            "the ray meets every listed object at min_t or beyond",
            hits < objects.len(),
        ),
        Condition::new(
            "the ray meets a listed object before min_t",
            "the ray meets no listed object before min_t",
            objects.iter().any(before),
        ),
    ]
}

/// The answers of searches that look for something else in the list.
pub(super) fn others(objects: &[Canned], min_t: f64) -> Vec<(&'static str, Answer)> {
    let from = |min_t: f64| -> Vec<Hit> {
        let hit = |(object, canned): (usize, &Canned)| {
            let intersection = canned.first_from(min_t)?;
            Some(Hit {
                object,
                intersection,
            })
        };
        objects.iter().enumerate().filter_map(hit).collect()
    };
    let (met, anywhere) = (from(min_t), from(f64::NEG_INFINITY));
    let in_front = from(0.0);
    let by_t = |a: &&Hit, b: &&Hit| a.intersection.t.total_cmp(&b.intersection.t);
    let mut sorted: Vec<&Hit> = met.iter().collect();
    sorted.sort_by(by_t);
    let farthest = sorted.last().copied();
    let all = [
        (
            "that of the first listed object that the ray meets",
            met.first(),
        ),
        (
            "that of the last listed object that the ray meets",
            met.last(),
        ),
        ("that of the farthest object", farthest),
        ("that of the second nearest object", sorted.get(1).copied()),
        (
            "that of the nearest object at t = 0 or beyond",
            in_front.iter().min_by(by_t),
        ),
        (
            "that of the nearest object, whatever min_t is",
            anywhere.iter().min_by(by_t),
        ),
    ];
    let answer = |(name, hit): (_, Option<&Hit>)| Some((name, Answer::Hit(Some(*hit?))));
    all.into_iter().filter_map(answer).collect()
}

/// The first hit that the submission's function finds among real shapes.
pub(crate) fn cast(
    ray: &Ray,
    min_t: f64,
    objects: &[Shape],
    functions: &[AnswerFn],
) -> Result<Answer, Unregistered> {
    let first_hit = AnswerFn::find(functions, Kind::FirstHit, |function| match function {
        AnswerFn::FirstHit { shapes, .. } => Some(*shapes),
        _ => None,
    })?;
    Ok(Answer::Hit(first_hit(ray, min_t, objects)))
}
