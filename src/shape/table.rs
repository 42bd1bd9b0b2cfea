//! The table of one object in a scene file, as its shape reads it.

use std::ops::Range;
use std::path::Path;

use glam::DVec3;
use serde::Deserialize;
use serde::de::IntoDeserializer;
use toml::Spanned;
use toml::de::DeTable;

use super::{Shape, ShapeKind};
use crate::error::Error;
use crate::source::Source;

/// The key that says which shape it is.
const TYPE: &str = "type";

/// An object's keys and values, each with its place.
///
/// A tagged serde enum would lose the places.
pub(crate) struct ObjectTable<'a> {
    /// The scene file.
    pub source: Source<'a>,
    /// What its `type` says it is.
    pub kind: ShapeKind,
    /// Where the table begins.
    pub span: Range<usize>,
    /// Everything in it.
    pub values: &'a DeTable<'a>,
}

impl ObjectTable<'_> {
    /// The shape it describes.
    pub fn shape(&self) -> Result<Shape, Error> {
        self.refuse_foreign_keys()?;
        self.kind.read_table(self)
    }

    fn refuse_foreign_keys(&self) -> Result<(), Error> {
        let (kind, keys) = (self.kind, self.kind.keys());
        let mut known = vec![TYPE];
        for key in ShapeKind::ALL.iter().flat_map(|shape| shape.keys()) {
            if !known.contains(key) {
                known.push(key);
            }
        }
        for (key, value) in self.values {
            let name = key.get_ref().as_ref();
            if !known.contains(&name) {
                return Err(self.source.unknown_key(key, &known));
            }
            if name != TYPE && !keys.contains(&name) {
                return Err(self.source.error(
                    value.span(),
                    format!("a {kind} has no `{name}`"),
                    format!(
                        "a {kind} takes: {}; remove `{name}` or change the type",
                        keys.join(", ")
                    ),
                ));
            }
        }
        Ok(())
    }

    /// The value of one of the shape's keys.
    pub fn get<'de, T: Deserialize<'de>>(&'de self, key: &str) -> Result<Spanned<T>, Error> {
        let Some(value) = self.values.get(key) else {
            let (kind, keys) = (self.kind, self.kind.keys());
            return Err(self.source.error(
                self.span.clone(),
                format!("this {kind} has no `{key}`"),
                format!("a {kind} needs: {}", keys.join(", ")),
            ));
        };
        Spanned::deserialize(value.clone().into_deserializer())
            .map_err(|error| self.source.explain(&error))
    }

    /// A point of world space.
    pub fn point(&self, key: &str) -> Result<DVec3, Error> {
        self.source.finite(key, &self.get(key)?)
    }

    /// A vector of any length but zero.
    pub fn direction(&self, key: &str) -> Result<DVec3, Error> {
        self.source.direction(key, &self.get(key)?)
    }

    /// A length greater than 0, in scene units.
    pub fn length(&self, key: &str) -> Result<f64, Error> {
        self.source.length(key, &self.get(key)?)
    }

    /// The folder that file names are relative to.
    pub fn folder(&self) -> &Path {
        self.source.path.parent().unwrap_or(Path::new(""))
    }
}
