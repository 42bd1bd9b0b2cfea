//! Grading a class: every submission alone, nothing lost, the same marks twice.
//!
//! Reading order: [`intake`] for what was handed in, [`roster`] for whose it is;
//! [`desk`] has them graded, several at a time; [`bench`] grades one into a [`record`]
//! ([`again`]), for as long as [`clock`] allows; [`redact`] for what may be
//! shown; [`store`] for what lies on disk, [`unfinished`] for what is not there yet; [`class`] for all records together, [`alike`] for answers that are the same;
//! [`finish`] for what is told of them, by [`csv`], [`page`] and [`formats`]; [`fresh`] for
//! questions that nobody has seen.

pub mod again;
pub mod alike;
pub mod bench;
pub mod changes;
pub mod class;
pub mod clock;
pub mod csv;
pub mod desk;
pub mod finish;
pub mod formats;
pub mod fresh;
pub mod intake;
pub mod page;
pub mod provenance;
pub mod record;
pub mod redact;
pub mod roster;
pub mod store;
pub mod unfinished;
