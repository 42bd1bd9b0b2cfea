//! The harness of Pinhole: everything around a ray casting assignment but its
//! answers.
//!
//! A *submission* is six small files of student's code; a *film* is the only thing
//! it can say; a *golden* film, made by Mitsuba, is the only thing that judges it.
//! The harness knows no submission: a submission's `main` hands its [`Answers`] to
//! [`serve`], and whoever wants a film starts that program and [`ask`]s it.
//!
//! Reading order:
//!
//! 1. [`ray`], [`camera`], [`shape`]: the words of the lecture;
//! 2. [`scene`], [`mesh`]: where they are read from;
//! 3. [`film`], [`judge`], [`oiiotool`], [`report`],
//!    [`false_colour`]: what a cast leaves
//!    behind, who judges it, and how people look at it;
//! 4. [`answers`], [`job`], [`probe`], [`serve`](mod@serve), [`ask`](mod@ask): the seam between
//!    harness and submission.
//!
//! Lengths are in scene units, angles in radians, numbers in `f64` until a film
//! rounds them to `f32`. Pixel (i, j) is column i from the left, row j from the
//! bottom.

pub mod answers;
pub mod ask;
pub mod camera;
pub mod error;
pub mod false_colour;
pub mod film;
pub mod job;
pub mod judge;
pub mod mesh;

pub mod oiiotool;
pub mod probe;
pub mod ray;
pub mod report;
pub mod scene;
pub mod serve;
pub mod shape;
#[cfg(test)]
mod testing;

pub use answers::Answers;
pub use camera::{Camera, Pixel, Projection, Resolution};
pub use error::Error;
pub use film::Film;
pub use ray::{Hit, Intersection, Ray};
pub use scene::Scene;
pub use serve::serve;
pub use shape::{Canned, Plane, Shape, Sphere, Triangle, TriangleSoup};
