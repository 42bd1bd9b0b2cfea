//! Grading a class: every submission alone, nothing lost, the same marks twice.
//!
//! Reading order: [`intake`] for what was handed in, [`roster`] for whose it is; [`queue`]
//! for who is graded when; [`grader`] grades one submission into a [`record`], for as long
//! as [`clock`] allows, with [`fresh`] questions if there are any; [`redact`] for what may
//! be shown of it, [`provenance`] for what it was made from, [`cache`] for what lies on
//! disk. [`class`] holds all records together and [`alike`] finds equal answers;
//! [`summary`] writes them as [`csv`], [`page`] and other graders' [`formats`].

pub mod alike;
pub mod cache;
pub mod class;
pub mod clock;
pub mod csv;
pub mod formats;
pub mod fresh;
pub mod grader;
pub mod intake;
pub mod page;
pub mod provenance;
pub mod queue;
pub mod record;
pub mod redact;
pub mod roster;
pub mod summary;
