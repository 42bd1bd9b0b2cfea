//! Measures the trade-off between speed and accuracy in ray casting.
//!
//! Reading order:
//!
//! 1. [`number`], [`vector`], [`shape`]: the lecture's terms, generic over the type of numbers;
//! 2. [`kernel`]: ways to intersect a ray with a shape, one file each, and the arithmetic that
//!    some of them use: [`double_double`], [`dyadic`], [`root`];
//! 3. [`question`], [`family`], [`random`]: the questions that kernels are asked;
//! 4. [`oracle`], [`judge`], [`conditioning`]: the true answers, wrong answers, and how
//!    sensitive questions are;
//! 5. [`contestants`], [`speed`], [`classes`]: the kernels, what each costs, what it gets wrong
//!    in each class of questions, and where it breaks;
//! 6. [`leaks`]: closed meshes; [`secondary`]: rays that begin on a surface; [`cast`],
//!    [`random_scene`], [`scenes`]: whole scenes; [`embree`]: the same rays cast by Embree;
//!    [`record`]: the long runs;
//! 7. [`plan`]: the cheapest way to cast a scene accurately enough, and [`plans`], which checks
//!    this;
//! 8. [`extent`], [`run`], [`targets`], [`provenance`], [`result`], [`plots`], [`summary`]: the
//!    whole study, and its reports.

pub mod cast;
pub mod classes;
pub mod conditioning;
pub mod contestants;
pub mod double_double;
pub mod dyadic;
pub mod embree;
pub mod extent;
pub mod family;
pub mod judge;
pub mod kernel;
pub mod leaks;
pub mod number;
pub mod oracle;
pub mod plan;
pub mod plans;
pub mod plots;
pub mod provenance;
pub mod question;
pub mod random;
pub mod random_scene;
pub mod record;
pub mod result;
pub mod root;
pub mod run;
pub mod scenes;
pub mod secondary;
pub mod shape;
pub mod speed;
pub mod summary;
pub mod targets;
pub mod vector;
