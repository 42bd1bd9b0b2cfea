//! What is shown of a graded class. Records hold text as students wrote it; each view
//! escapes it for where it goes.

pub mod csv;
pub mod formats;
pub mod page;
pub mod progress;
pub mod summary;
