//! An answer part by part, and what is known of a question: the numbers that a diagnosis
//! compares.
//!
//! Shapes and kinds of questions provide these, so the code that measures errors does not need to
//! know any shape or kind.

use crate::ray::Ray;

/// A part of an answer, which can be right while other parts are wrong: a number, or a vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name in a sentence: "the normal".
    pub name: &'static str,
    /// One value for each axis; not finite where the part is not defined.
    pub values: Vec<f64>,
    /// What the axes are called, in the values' order; a number has none.
    pub axes: &'static [&'static str],
    /// The unit of the values, such as " pixels".
    pub unit: &'static str,
    /// The film channels it is made of.
    pub channels: &'static [&'static str],
    /// How many of the channels' units make up one of its own units.
    pub scale: f64,
    /// Whether the golden only limits it. If so, the golden is 0, and its tolerance is the greatest
    /// right value.
    pub is_limit: bool,
}

/// A positive number that belongs to a question, such as a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in a sentence: "the radius".
    pub name: &'static str,
    /// Not finite where the question has no such number.
    pub value: f64,
    /// Whether it counts something and is therefore a whole number.
    pub is_count: bool,
}

/// A condition on a question and an answer to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// The condition in words that can follow "where": "the ray starts inside the sphere".
    pub name: &'static str,
    /// The opposite condition, in words that can follow "where".
    pub otherwise: &'static str,
    /// Whether it is met.
    pub holds: bool,
}

/// How many of an answer's steps, such as the branches of a tree, were taken in a way that may
/// explain why a part of the answer is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tally {
    /// The steps in words that can follow a number: "branches of your trees".
    pub steps: &'static str,
    /// What is counted, in words that can follow a number: "are cut along another axis".
    pub sort: &'static str,
    /// The part of the answer that it may explain; `None` if that is not a part, such as the number
    /// of steps.
    pub explains: Option<&'static str>,
    /// How many steps of this sort there are.
    pub some: usize,
    /// How many steps there are.
    pub all: usize,
}

impl Part {
    /// Whether it says which object is hit, so that its value is a name and not a measurement.
    pub fn is_object(&self) -> bool {
        self.channels == ["id"]
    }
}

impl Condition {
    pub(crate) fn new(name: &'static str, otherwise: &'static str, holds: bool) -> Condition {
        Condition {
            name,
            otherwise,
            holds,
        }
    }
}

impl Quantity {
    pub(crate) fn new(name: &'static str, value: f64) -> Quantity {
        Quantity {
            name,
            value,
            is_count: false,
        }
    }

    /// A number of things.
    pub(crate) fn count(name: &'static str, count: usize) -> Quantity {
        Quantity {
            name,
            value: count as f64,
            is_count: true,
        }
    }

    /// The quantities of every ray with a `min_t`.
    pub(crate) fn of_ray(ray: &Ray, min_t: f64) -> Vec<Quantity> {
        vec![
            Quantity::new("|d|", ray.direction.length()),
            Quantity::new("min_t", min_t),
        ]
    }
}
