//! Builds Pinhole's book, and checks what it shows.
//!
//! The book's chapters quote: code by its anchors, what a command prints, numbers,
//! figures, pictures of mistakes. None of that is typed by hand; this package inserts
//! it, for students (no solutions) and for instructors, and fails where it cannot.
//! Students never compile it: `pinhole book` starts it when somebody asks.
//!
//! Reading order:
//!
//! 1. [`error`], [`course`], [`edition`]: what can be wrong, what is explained, for whom;
//! 2. [`scan`], [`directive`]: what a writer's page consists of;
//! 3. [`reference`](mod@reference), [`record`]: whom the book asks instead of claiming;
//! 4. [`png`](mod@png), [`rasterizer`], [`silhouette`] and [`boxes`]: what the book computes itself, to compare;
//! 5. [`listing`], [`formula`], [`run`], [`worked`], [`figures`], [`gallery`],
//!    [`interactive`]: one file for each thing a page can quote;
//! 6. [`expand`], [`build`]: a page with everything put in, and the book of all pages;
//! 7. [`check`]: what would make the book lie, looked for in the built pages.

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
