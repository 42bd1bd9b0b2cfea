//! The functions that a submission registers, and what they give.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Kind;
use crate::camera::{Camera, Pixel, Resolution};
use crate::part::Part;
use crate::ray::{Hit, Intersection, Ray};
use crate::shape::{Canned, Shape, TriangleSoup};

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
        /// For real shapes: this casts a film.
        shapes: fn(&Ray, f64, &[Shape]) -> Option<Hit>,
        /// For canned objects: this is judged alone.
        canned: fn(&Ray, f64, &[Canned]) -> Option<Hit>,
    },
    /// Where a ray first meets a soup of canned objects, from `min_t` on.
    Soup(fn(&TriangleSoup<Canned>, &Ray, f64) -> Option<Intersection>),
}

impl AnswerFn {
    /// The first of these functions that `pick` picks.
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
    /// What a ray hit, if anything. A shape asked alone counts as object 0.
    Hit(Option<Hit>),
    /// A viewing ray.
    Ray(Ray),
}

impl Answer {
    /// What was hit, if it is about hits and anything was.
    pub(super) fn hit(&self) -> Option<Hit> {
        match self {
            Answer::Hit(hit) => *hit,
            Answer::Ray(_) => None,
        }
    }

    /// What a shape that is asked alone answers.
    pub(super) fn alone(intersection: Option<Intersection>) -> Answer {
        Answer::Hit(intersection.map(|intersection| Hit {
            object: 0,
            intersection,
        }))
    }
}

impl Hit {
    /// What can be right or wrong in it.
    pub(super) fn parts(&self) -> Vec<Part> {
        let part = |name, values, axes, channels| Part {
            name,
            values,
            axes,
            unit: "",
            channels,
            scale: 1.0,
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
