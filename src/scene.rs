//! A scene: one camera and the objects in front of it, read from a TOML file.

mod document;
mod tables;

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use crate::camera::{Camera, Resolution};
use crate::error::{Error, read_text};
use crate::shape::{Shape, ShapeKind};
use document::Document;

/// No film has more pixels: five channels of them fill 1 GB.
pub const MOST_PIXELS: usize = 50_000_000;

/// A camera, the film's size, and the objects: everything that a cast needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// The camera.
    pub camera: Camera,
    /// How many pixels the film has.
    pub resolution: Resolution,
    /// Intersections before this t do not count. In multiples of a ray's direction: 1 is a
    /// perspective camera's image plane, 0 its eye. Never negative, because nothing behind the eye
    /// is seen.
    pub min_t: f64,
    /// In file order; an object's place in this list is its id.
    pub objects: Vec<Shape>,
}

impl Scene {
    /// Reads a scene file and the meshes it names.
    ///
    /// # Errors If the file is not TOML; if a key is missing, unknown or of the wrong kind; or if a
    /// value is impossible for a camera or shape. These errors have a line and column. Also if a
    /// mesh cannot be read (see [`mesh::read`](crate::mesh::read)).
    pub fn read(path: &Path) -> Result<Scene, Error> {
        let text = read_text(path).map_err(|error| {
            Error::new(
                path,
                format!("cannot read this scene: {error}"),
                "name a TOML file that you may read",
            )
        })?;
        Document::parse(&text, path)?.into_scene()
    }

    /// The files, such as meshes, that the scene file at `path` names. The list is empty if it is
    /// not a scene; [`Scene::read`] reports that.
    pub fn files(path: &Path) -> Vec<PathBuf> {
        let text = read_text(path).unwrap_or_default();
        let file: Table = text.parse().unwrap_or_default();
        let objects = file.get("object").and_then(Value::as_array);
        let named = objects.into_iter().flatten().flat_map(|object| {
            ShapeKind::file_keys().filter_map(|key| object.get(key).and_then(Value::as_str))
        });
        let folder = path.parent().unwrap_or(Path::new(""));
        named.map(|file| folder.join(file)).collect()
    }
}

#[cfg(test)]
mod tests;
