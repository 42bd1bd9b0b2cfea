//! The views of a graded class. Records contain text as students wrote it, and each view escapes it
//! for its own format.

pub mod csv;
pub mod feedback;
pub mod formats;
pub mod gradebook;
pub mod page;
pub mod preview;
pub mod progress;
pub mod report;
pub mod summary;
