//! TOML with positions: values that know their line and column, and errors that show
//! them.

use std::ops::Range;
use std::path::Path;

use glam::DVec3;
use toml::Spanned;

use crate::error::Error;

/// Keys that scene files of renderers have, but ours don't.
const NOT_MODELLED: [&str; 12] = [
    "light",
    "lights",
    "material",
    "materials",
    "lens",
    "aperture",
    "texture",
    "color",
    "colour",
    "shader",
    "shadow",
    "ambient",
];

/// A file's text and its name.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub text: &'a str,
    pub path: &'a Path,
}

impl Source<'_> {
    /// A vector of three finite numbers.
    pub fn finite(self, key: &str, vector: &Spanned<DVec3>) -> Result<DVec3, Error> {
        let value = *vector.get_ref();
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.not_finite(key, vector.span()))
        }
    }

    /// A vector of any ordinary length.
    pub fn direction(self, key: &str, vector: &Spanned<DVec3>) -> Result<DVec3, Error> {
        let value = self.finite(key, vector)?;
        // If the square underflows, too few digits are left to normalise the vector.
        if !value.length_squared().is_normal() {
            return Err(self.error(
                vector.span(),
                format!(
                    "`{key}` has no direction: its length is {:?}",
                    value.length()
                ),
                "give a vector of ordinary length; it need not be a unit vector",
            ));
        }
        Ok(value)
    }

    /// A finite number.
    pub fn number(self, key: &str, number: &Spanned<f64>) -> Result<f64, Error> {
        let value = *number.get_ref();
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.not_finite(key, number.span()))
        }
    }

    /// A finite number greater than 0.
    pub fn length(self, key: &str, number: &Spanned<f64>) -> Result<f64, Error> {
        let value = self.number(key, number)?;
        if value <= 0.0 {
            return Err(self.error(
                number.span(),
                format!("`{key}` is {value}"),
                "give a length greater than 0, in scene units",
            ));
        }
        Ok(value)
    }

    /// The error for a value that is NaN or infinite.
    pub fn not_finite(self, key: &str, span: Range<usize>) -> Error {
        self.error(
            span,
            format!("`{key}` is not a finite number"),
            "replace nan or inf with a number",
        )
    }

    /// An error where `span` begins.
    pub fn error(
        self,
        span: Range<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        let (line, column) = line_and_column(self.text, span.start);
        Error::new(self.path, problem, remedy).at(line, column)
    }

    /// What the TOML reader said, with a place and a remedy.
    pub fn explain(self, error: &toml::de::Error) -> Error {
        let message = error.message().lines().next().unwrap_or_default();
        let message = message.trim_end_matches('.');
        let unknown = message
            .strip_prefix("unknown field `")
            .and_then(|rest| rest.split('`').next());
        let (problem, remedy) = match unknown {
            Some(key) => unknown_key(key, message),
            None => (
                message.into(),
                "see \"Scene and film files\" in the book".into(),
            ),
        };
        match error.span() {
            Some(span) => self.error(span, problem, remedy),
            None => Error::new(self.path, problem, remedy),
        }
    }

    /// The error for a key that no table of this kind has.
    pub fn unknown_key(self, key: &Spanned<impl AsRef<str>>, known: &[&str]) -> Error {
        let name = key.get_ref().as_ref();
        let message = format!(
            "unknown field `{name}`, expected one of `{}`",
            known.join("`, `")
        );
        let (problem, remedy) = unknown_key(name, &message);
        self.error(key.span(), problem, remedy)
    }
}

/// Problem and remedy for a key that no table takes.
fn unknown_key(key: &str, message: &str) -> (String, String) {
    if NOT_MODELLED.contains(&key) {
        let problem = format!(
            "`{key}` is unknown: ray casting finds what a ray meets, not how it is lit, so \
             scenes have no lights, materials or lenses"
        );
        (problem, format!("remove `{key}`"))
    } else {
        let remedy = "remove the key, or correct its spelling";
        (message.into(), remedy.into())
    }
}

/// Line and column, from 1, of a byte offset.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(offset)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    )
}
