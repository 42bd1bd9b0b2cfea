//! The harness of Pinhole: the code around a submission's answers.
//!
//! A *submission* is a few small files of a student's code. Its only output is a *film*,
//! which is judged only by comparing it with a *golden* film made by Mitsuba. The harness
//! knows no submission: a submission's `main` hands its functions to [`serve()`], and to
//! get a film, you start that program and [`ask`](mod@ask) it.
//!
//! Reading order:
//!
//! 1. [`ray`], [`camera`], [`shape`]: the words of the lecture;
//! 2. [`scene`], [`mesh`]: where they are read from; [`bounds`], [`tree`]: what makes a
//!    search fast;
//! 3. [`film`], [`judge`], [`oiiotool`], [`comparison`]: what a cast produces, what judges it,
//!    and how it differs;
//! 4. [`words`], [`report`], [`false_colour`], [`part`]: how people look at it;
//! 5. [`kind`], [`job`], [`serve`](mod@serve), [`ask`](mod@ask): how harness and
//!    submission talk to each other.
//!
//! Lengths are in scene units, angles in radians, numbers in `f64` until a film
//! rounds them to `f32`. Pixel (i, j) is column i from the left, row j from the
//! bottom.
//!
//! Two pixels, of which a submission gets one wrong:
//!
//! ```
//! use glam::DVec3;
//! use pinhole::film::{Channel, HIT_CHANNELS};
//! use pinhole::judge::{Golden, judge};
//! use pinhole::{Film, Hit, Intersection, Resolution};
//!
//! let resolution = Resolution { n_x: 2, n_y: 1 };
//! let met_at = |t| {
//!     let normal = DVec3::Y;
//!     let intersection = Intersection { t, normal };
//!     Some(Hit { object: 0, intersection })
//! };
//! let golden = Film::of_hits(resolution, &[None, met_at(1.25)]);
//! let channels = HIT_CHANNELS.map(|name| Channel {
//!     name: name.into(),
//!     samples: vec![1e-6; 2],
//! });
//! let tolerance = Film::new(resolution, channels.into());
//! let golden = Golden::new(golden, tolerance).expect("they belong together");
//!
//! let film = Film::of_hits(resolution, &[None, met_at(1.5)]);
//! let verdict = judge(&golden, &film).expect("it has the golden's size and channels");
//! assert!(!verdict.passes());
//! assert_eq!(
//!     verdict.to_string(),
//!     "fails: 1 of 2 pixels is wrong\n  \
//!      t    1 pixel; worst at (1, 0): got 1.5, expected 1.25 ± 1e−6"
//! );
//! ```

pub mod ask;
pub mod bounds;
pub mod camera;
pub mod comparison;
mod counter;
pub mod error;
pub mod fact;
pub mod false_colour;
pub mod film;
pub mod heat_map;
pub mod job;
pub mod judge;
pub mod kind;
pub mod mesh;
pub mod oiiotool;
pub mod part;
pub mod preview;
pub mod ray;
pub mod report;
pub mod scene;
pub mod serve;
pub mod shape;
mod source;
#[cfg(test)]
mod testing;
pub mod tree;
pub mod words;

pub use bounds::BoundingBox;
pub use camera::{Camera, Pixel, Projection, Resolution};
pub use counter::count_test;
pub use error::Error;
pub use fact::Fact;
pub use film::Film;
pub use kind::{AnswerFn, Kind};
pub use ray::{Hit, Intersection, Ray};
pub use scene::Scene;
pub use serve::serve;
pub use shape::{Canned, Disk, Plane, Shape, ShapeKind, Sphere, Triangle, TriangleSoup};
pub use tree::{FlatTree, Node, NodeBox, RayTree, Tree};
