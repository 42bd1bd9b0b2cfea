//! Grades a class. Each submission is graded by itself, so that no grade is lost and every mark
//! can be reproduced.
//!
//! Reading order: [`intake`] reads what was handed in, and by whom. [`stored`] finds results that are
//! still valid, and [`queue`] grades the rest. [`grader`] grades one submission into a [`record`].
//! [`redact`] removes what students may not see, [`evidence`] keeps what only the lecturer may see,
//! [`points`] computes marks again, [`provenance`] says what a record was made from, [`atomic`]
//! writes files, and [`cache`] stores those of a class. [`policy`] turns the judged points into a mark
//! for the gradebook, [`class`] collects all records, [`shared_answers`] finds equal answers, and
//! [`unexplained_groups`] groups wrong answers that no known mistake explains. [`views`] writes and
//! prints the results.

pub mod atomic;
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
pub mod shared_answers;
pub mod stored;
pub mod unexplained_groups;
pub mod views;
