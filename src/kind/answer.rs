//! The functions that a submission registers, and what they return.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Kind;
use crate::bounds::BoundingBox;
use crate::camera::{Camera, Pixel, Resolution};
use crate::film::BOX_CHANNELS;
use crate::part::Part;
use crate::ray::{Hit, Intersection, Ray};
use crate::shape::{Canned, Shape, Triangle, TriangleSoup};
use crate::tree::{FlatTree, RayTree, Tree, TreeMeasures};
use crate::words;

/// A submission's function for one kind of question.
///
/// Plain function pointers keep the harness free of type parameters, and let each be
/// asked while the others are still `todo!`.
#[derive(Clone, Copy)]
pub enum AnswerFn {
    /// The ray through a pixel's centre.
    ViewingRay(fn(&Camera, Pixel, Resolution) -> Ray),
    /// Where a ray first meets a shape, from `min_t` on.
    Intersect(fn(&Shape, &Ray, f64) -> Option<Intersection>),
    /// The nearest object along a ray, from `min_t` on.
    FirstHit {
        /// For real shapes, when a film is cast.
        shapes: fn(&Ray, f64, &[Shape]) -> Option<Hit>,
        /// For canned objects, when this function is judged alone.
        canned: fn(&Ray, f64, &[Canned]) -> Option<Hit>,
    },
    /// Where a ray first meets a soup of canned objects, from `min_t` on.
    Soup(fn(&TriangleSoup<Canned>, &Ray, f64) -> Option<Intersection>),
    /// Smallest boxes.
    Bounds {
        /// Around a triangle.
        of_triangle: fn(&Triangle) -> BoundingBox,
        /// Around two boxes.
        join: fn(&BoundingBox, &BoundingBox) -> BoundingBox,
    },
    /// The t at which a ray enters a solid box, from `min_t` to `max_t`.
    RayBox(fn(&BoundingBox, &Ray, f64, f64) -> Option<f64>),
    /// A tree over triangles with these boxes.
    Tree(fn(&[BoundingBox]) -> Tree),
    /// The nearest triangle of a tree, from `min_t` on.
    TreeSearch(fn(&dyn RayTree, f64) -> Option<Hit>),
}

impl AnswerFn {
    /// The first function that `pick` accepts.
    pub(super) fn find<F>(
        functions: &[AnswerFn],
        kind: Kind,
        pick: impl Fn(&AnswerFn) -> Option<F>,
    ) -> Result<F, Unregistered> {
        let function = functions.iter().find_map(pick);
        function.ok_or(Unregistered(kind))
    }
}

/// One answer to one question.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// What a ray hit, if anything. A shape that is asked about alone counts as object 0.
    Hit(Option<Hit>),
    /// A viewing ray.
    Ray(Ray),
    /// A box.
    Box(BoundingBox),
    /// The measures by which a tree is judged.
    Tree(TreeMeasures),
}

/// What a submission sends for one question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum WireAnswer {
    /// The answer.
    Answer(Answer),
    /// A tree, which the asker measures.
    Tree(FlatTree),
    /// The answer at a pixel of a scene, and how many tests the submission counted.
    Counted(Answer, u32),
}

impl From<Answer> for WireAnswer {
    fn from(answer: Answer) -> WireAnswer {
        WireAnswer::Answer(answer)
    }
}

impl WireAnswer {
    /// What was sent, as the answer to a question about hits.
    pub(crate) fn hit(&self) -> Option<Answer> {
        match self {
            WireAnswer::Answer(answer @ Answer::Hit(_)) => Some(*answer),
            _ => None,
        }
    }
}

impl Answer {
    /// The answer in words, without the object of a hit.
    pub fn words(&self, digits: usize) -> String {
        match self {
            Answer::Hit(hit) => words::intersection(*hit, digits),
            Answer::Ray(ray) => words::ray(ray, digits),
            Answer::Box(bounds) => bounds.words(digits),
            Answer::Tree(measures) => measures.words(digits),
        }
    }

    /// The hit, if the answer is one.
    pub(super) fn hit(&self) -> Option<Hit> {
        match self {
            Answer::Hit(hit) => *hit,
            _ => None,
        }
    }

    /// The t of the hit; NaN if there is none.
    pub(super) fn t(&self) -> f64 {
        self.hit().map_or(f64::NAN, |hit| hit.intersection.t)
    }

    /// The answer about a shape that is asked about alone.
    pub(super) fn alone(intersection: Option<Intersection>) -> Answer {
        Answer::Hit(intersection.map(|intersection| Hit {
            object: 0,
            intersection,
        }))
    }
}

impl BoundingBox {
    /// Its parts, which can be right or wrong one by one.
    pub(super) fn parts(&self) -> Vec<Part> {
        let part = |name, corner: glam::DVec3, channels| Part {
            name,
            values: corner.to_array().to_vec(),
            axes: &["x", "y", "z"],
            unit: "",
            channels,
            scale: 1.0,
            is_limit: false,
        };
        let (low, high) = BOX_CHANNELS.split_at(3);
        vec![part("min", self.min, low), part("max", self.max, high)]
    }
}

impl Hit {
    /// Its parts, which can be right or wrong one by one.
    pub(super) fn parts(&self) -> Vec<Part> {
        let part = |name, values, axes, channels| Part {
            name,
            values,
            axes,
            unit: "",
            channels,
            scale: 1.0,
            is_limit: false,
        };
        let Intersection { t, normal } = self.intersection;
        vec![
            part("the object", vec![self.object as f64], &[], &["id"]),
            part("t", vec![t], &[], &["t"]),
            part(
                "the normal",
                normal.to_array().to_vec(),
                &["x", "y", "z"],
                &["N.X", "N.Y", "N.Z"],
            ),
        ]
    }
}

/// The submission has no function for questions of this kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unregistered(pub Kind);

impl fmt::Display for Unregistered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "it registers no function for `{}`", self.0)
    }
}

impl std::error::Error for Unregistered {}
