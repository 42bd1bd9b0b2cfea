//! Builds Pinhole's book, and checks what it shows.
//!
//! Chapters quote code by its anchors, the output of commands, numbers, figures, and pictures of
//! mistakes. None of that is typed by hand. This package inserts it, for students (without
//! solutions) and for instructors, and fails where it cannot. Students never compile this
//! package; `pinhole book` builds it when needed.
//!
//! Reading order:
//!
//! 1. [`error`], [`course`], [`edition`]: what can be wrong, what is explained, and for which
//!    readers;
//! 2. [`scan`], [`directive`]: what a writer's page consists of;
//! 3. [`reference`](mod@reference), [`record`]: the programs and records that the book quotes;
//! 4. [`png`](mod@png), [`rasterizer`], [`silhouette`] and [`boxes`]: what the book computes
//!    itself, for comparison;
//! 5. [`listing`], [`formula`], [`run`], [`worked`], [`figures`], [`gallery`],
//!    [`interactive`]: one file for each thing a page can quote;
//! 6. [`expand`], [`build`]: a page with everything inserted, and the book of all pages;
//! 7. [`check`]: everything that could be wrong in the built pages.

pub mod boxes;
pub mod build;
pub mod check;
pub mod course;
pub mod directive;
pub mod edition;
pub mod error;
pub mod expand;
pub mod figures;
pub mod formula;
pub mod gallery;
pub mod html;
pub mod interactive;
pub mod listing;
pub mod png;
pub mod rasterizer;
pub mod record;
pub mod reference;
pub mod run;
pub mod scan;
pub mod silhouette;
pub mod worked;
