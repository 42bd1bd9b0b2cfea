//! Grading a class: every submission alone, nothing lost, the same marks twice.
//!
//! Reading order: [`intake`] for what was handed in and by whom; [`queue`] for what is
//! graded when; [`grader`] grades one submission into a [`record`]; [`redact`] for what may
//! be shown of it, [`provenance`] for what it was made from, [`cache`] for what lies on
//! disk. [`class`] holds all records together and [`alike`] finds equal answers; [`views`]
//! writes and prints them.

pub mod alike;
pub mod cache;
pub mod class;
pub mod grader;
pub mod intake;
pub mod provenance;
pub mod queue;
pub mod record;
pub mod redact;
pub mod views;
