use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered};
use crate::fact::Fact;
use crate::film::Samples;
use crate::ray::Ray;
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
    fn answer(&self, functions: &[AnswerFn]) -> Result<Answer, Unregistered> {
        let intersect = AnswerFn::find(functions, Kind::Intersect, |function| match function {
            AnswerFn::Intersect(intersect) => Some(*intersect),
            _ => None,
        })?;
        Ok(Answer::alone(intersect(&self.shape, &self.ray, self.min_t)))
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        let (ray, min_t) = (words::ray(&self.ray, digits), number(self.min_t, digits));
        vec![
            Fact::new("ray", format!("{ray}, min_t = {min_t}")),
            Fact::new(self.shape.kind().name(), self.shape.words(digits)),
        ]
    }
}
