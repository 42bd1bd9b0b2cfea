//! Grades a class: each submission by itself, so that no grade is lost and marks can be
//! reproduced.
//!
//! Reading order: [`intake`] for what was handed in and by whom; [`queue`] for what is
//! graded when; [`grader`] grades one submission into a [`record`]; [`redact`] for what may
//! be shown of it, [`evidence`] for what the lecturer alone sees, [`points`] for marks that are
//! computed again, [`provenance`] for what it was made from, [`cache`] for what lies on
//! disk. [`policy`] turns what was judged into a mark for the gradebook, [`class`] holds all
//! records together, [`alike`] finds equal answers, and
//! [`unexplained`] wrong ones that no known mistake explains; [`views`] writes and prints them.

pub mod alike;
pub mod cache;
pub mod class;
pub mod evidence;
pub mod grader;
pub mod intake;
pub mod points;
pub mod policy;
pub mod provenance;
pub mod queue;
pub mod record;
pub mod redact;
pub mod unexplained;
pub mod views;
