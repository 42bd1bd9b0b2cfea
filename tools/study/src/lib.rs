//! The trade between speed and accuracy in ray casting, measured.
pub mod contestant;
pub mod contestants;
pub mod double_double;
pub mod dyadic;
pub mod family;
pub mod judge;
pub mod kernel;
pub mod leading;
pub mod number;
pub mod oracle;
pub mod question;
pub mod random;
pub mod shape;
pub mod vector;
