//! From a submission to its outcome.
//!
//! Reading order: [`assignment`] for what is asked and what it is worth, [`submission`] for what
//! a student hands in, [`compile`] and [`sandbox`] for how it is built and run, [`goldens`] for
//! what it is compared with, [`examine`] for the steps that lead to an [`outcome`], and
//! [`diagnosis`] for why something is wrong.

pub mod assignment;
pub mod checkout;
pub mod compile;
pub mod describe;
pub mod diagnosis;
pub mod error;
pub mod examine;
pub mod examples;
pub mod explanation;
pub mod goldens;
pub mod handout_record;
pub mod link;
pub mod manifest;
pub mod mistake;
pub mod mistake_films;
pub mod mitsuba;
pub mod outcome;
pub mod output;
pub mod overlay;
pub mod private;
pub mod progress;
pub mod run_options;
pub mod rust_tool;
pub mod sandbox;
pub mod second_judge;
pub mod seed;
pub mod shell;
pub mod stubs;
pub mod submission;
pub mod timings;
