//! Views of an examination: terminal text, JSON and HTML.
//!
//! Reading order: [`terminal`], [`json`], [`html`]; then [`passage`], which refers readers to the
//! book, and [`program`], which all programs share.

pub mod cast;
pub mod desktop;
pub mod escape;
pub mod finish;
pub mod html;
pub mod json;
pub mod passage;
pub mod pictures;
pub mod program;
pub mod terminal;
