//! Figures that answer to a hand, and their static pictures.

use crate::checkout::Checkout;

/// Markdown of an interactive figure.
pub fn shown(name: &str, _: &str, _: &Checkout) -> Result<String, (String, String)> {
    Err((format!("no interactive figure {name} yet"), String::new()))
}

/// What is wrong with the figures' types or mathematics.
pub fn check(_: &Checkout) -> crate::error::Result<Vec<crate::error::Problem>> {
    Ok(Vec::new())
}
