use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer, first_hit};
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::Ray;
use crate::shape::{Canned, TriangleSoup};

/// Where does `ray` first meet this soup, from `min_t` on?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SoupQuestion {
    /// Objects that know their intersections with `ray`, instead of triangles.
    pub soup: TriangleSoup<Canned>,
    /// The ray.
    pub ray: Ray,
    /// In multiples of the ray's direction.
    pub min_t: f64,
}

impl SoupQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<SoupQuestion, String> {
        let triangles = Canned::read_all(samples)?;
        Ok(SoupQuestion {
            soup: TriangleSoup { triangles },
            ray: samples.ray()?,
            min_t: samples.min_t()?,
        })
    }
}

impl Question for SoupQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let intersect = AnswerFn::find(functions, Kind::Soup, |function| match function {
            AnswerFn::Soup(intersect) => Some(*intersect),
            _ => None,
        })?;
        Ok(Answer::alone(intersect(&self.soup, &self.ray, self.min_t)).into())
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        first_hit::facts(&self.soup.triangles, self.min_t, digits)
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let mut quantities = Quantity::of_ray(&self.ray, self.min_t);
        quantities.push(Quantity::new("t", right.t()));
        quantities
    }

    fn conditions(&self, answer: &Answer) -> Vec<Condition> {
        first_hit::conditions(&self.soup.triangles, self.min_t, answer)
    }

    /// The soup is one object, so an answer does not say which triangle is met.
    fn others(&self, _: &Answer) -> Vec<(&'static str, Answer)> {
        let others = first_hit::others(&self.soup.triangles, self.min_t).into_iter();
        let alone = |(name, other): (_, Answer)| {
            let intersection = other.hit().map(|hit| hit.intersection);
            (name, Answer::alone(intersection))
        };
        others.map(alone).collect()
    }
}
