use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::bounds::BoundingBox;
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::shape::{Shape, ShapeKind, Triangle};

/// Which is the smallest box around these?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum BoundsQuestion {
    /// A triangle.
    Triangle(Triangle),
    /// Two boxes.
    Boxes(BoundingBox, BoundingBox),
}

/// Conditions for each corner of a triangle: it has the least coordinate along some axis, or the
/// greatest. Each comes with its opposite.
const CORNERS: [[(&str, &str); 2]; 3] = [
    [
        (
            "at least one of the smallest x, y and z comes from the first corner",
            "the smallest x, y and z all come from the other two corners",
        ),
        (
            "at least one of the largest x, y and z comes from the first corner",
            "the largest x, y and z all come from the other two corners",
        ),
    ],
    [
        (
            "at least one of the smallest x, y and z comes from the second corner",
            "the smallest x, y and z all come from the first and third corners",
        ),
        (
            "at least one of the largest x, y and z comes from the second corner",
            "the largest x, y and z all come from the first and third corners",
        ),
    ],
    [
        (
            "at least one of the smallest x, y and z comes from the third corner",
            "the smallest x, y and z all come from the first two corners",
        ),
        (
            "at least one of the largest x, y and z comes from the third corner",
            "the largest x, y and z all come from the first two corners",
        ),
    ],
];

impl BoundsQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<BoundsQuestion, String> {
        match samples.count("boxes")? {
            0 => match ShapeKind::Triangle.read_samples(samples)? {
                Shape::Triangle(triangle) => Ok(BoundsQuestion::Triangle(triangle)),
                other => Err(format!("it holds a {}", other.kind())),
            },
            2 => Ok(BoundsQuestion::Boxes(
                samples.bounding_box("0")?,
                samples.bounding_box("1")?,
            )),
            count => Err(format!(
                "channel `boxes` holds {count}, but it must hold 0 or 2"
            )),
        }
    }
}

impl Question for BoundsQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let (of_triangle, join) =
            AnswerFn::find(functions, Kind::Bounds, |function| match function {
                AnswerFn::Bounds { of_triangle, join } => Some((*of_triangle, *join)),
                _ => None,
            })?;
        Ok(Answer::Box(match self {
            BoundsQuestion::Triangle(triangle) => of_triangle(triangle),
            BoundsQuestion::Boxes(a, b) => join(a, b),
        })
        .into())
    }

    fn receive(&self, sent: &WireAnswer) -> Option<Answer> {
        match sent {
            WireAnswer::Answer(answer @ Answer::Box(_)) => Some(*answer),
            _ => None,
        }
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        match self {
            BoundsQuestion::Triangle(triangle) => vec![Fact::new(
                "triangle",
                Shape::Triangle(*triangle).words(digits),
            )],
            BoundsQuestion::Boxes(a, b) => vec![
                Fact::new("a", a.words(digits)),
                Fact::new("b", b.words(digits)),
            ],
        }
    }

    fn quantities(&self, _: &Answer) -> Vec<Quantity> {
        Vec::new()
    }

    fn conditions(&self, _: &Answer) -> Vec<Condition> {
        let points = match self {
            BoundsQuestion::Triangle(triangle) => triangle.corners.to_vec(),
            BoundsQuestion::Boxes(a, b) => vec![a.min, a.max, b.min, b.max],
        };
        let shares = |axis: usize| points.iter().all(|point| point[axis] == points[0][axis]);
        let mut conditions = vec![
            Condition::new(
                "two boxes are joined",
                "the question is about a triangle",
                matches!(self, BoundsQuestion::Boxes(..)),
            ),
            Condition::new("the box is flat", "the box is not flat", (0..3).any(shares)),
            Condition::new(
                "all coordinates are negative",
                "at least one coordinate is not negative",
                points.iter().all(|point| point.max_element() < 0.0),
            ),
        ];
        // Whether this corner alone is the lowest (`side` −1) or the highest along some axis.
        let sticks_out = |corner: usize, side: f64| match self {
            BoundsQuestion::Boxes(..) => false,
            BoundsQuestion::Triangle(Triangle { corners }) => (0..3).any(|axis| {
                let mut others = (0..3).filter(|other| *other != corner);
                let place = |corner: usize| side * corners[corner][axis];
                others.all(|other| place(other) < place(corner))
            }),
        };
        let names = CORNERS.iter().enumerate();
        conditions.extend(names.flat_map(|(corner, [least, greatest])| {
            [(least, -1.0), (greatest, 1.0)].map(|((name, otherwise), side)| {
                Condition::new(name, otherwise, sticks_out(corner, side))
            })
        }));
        conditions
    }

    fn others(&self, _: &Answer) -> Vec<(&'static str, Answer)> {
        match self {
            BoundsQuestion::Triangle(_) => Vec::new(),
            BoundsQuestion::Boxes(a, b) => vec![
                ("that of the first box", Answer::Box(*a)),
                ("that of the second box", Answer::Box(*b)),
            ],
        }
    }
}
