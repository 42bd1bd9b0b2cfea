use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered};
use crate::fact::Fact;
use crate::film::Samples;
use crate::ray::Ray;
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
    fn answer(&self, functions: &[AnswerFn]) -> Result<Answer, Unregistered> {
        let first_hit = AnswerFn::find(functions, Kind::FirstHit, |function| match function {
            AnswerFn::FirstHit { canned, .. } => Some(*canned),
            _ => None,
        })?;
        Ok(Answer::Hit(first_hit(&self.ray, self.min_t, &self.objects)))
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        facts(&self.objects, self.min_t, digits)
    }

    /// Only here does it matter which object is hit.
    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        match answer {
            Answer::Hit(hit) => words::hit(*hit, digits),
            Answer::Ray(ray) => words::ray(ray, digits),
        }
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

/// What the submission's function finds first of real shapes.
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
