//! Turns the tables of a scene file into a scene, and reports everything that can be
//! wrong with them.

use std::path::Path;

use serde::Deserialize;
use serde::de::IntoDeserializer;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::tables::{File, ObjectType, ProjectionName};
use super::{MOST_PIXELS, Scene};
use crate::camera::{Camera, Projection, Resolution};
use crate::error::Error;
use crate::shape::{ObjectTable, Shape};
use crate::source::Source;

/// A parsed file that still knows where each value stood.
pub(super) struct Document<'a> {
    file: File,
    root: DeTable<'a>,
    source: Source<'a>,
}

impl<'a> Document<'a> {
    pub(super) fn parse(text: &'a str, path: &'a Path) -> Result<Document<'a>, Error> {
        let source = Source { text, path };
        let explain = |error| source.explain(&error);
        let root = DeTable::parse(text).map_err(explain)?;
        let file = File::deserialize(root.clone().into_deserializer()).map_err(explain)?;
        Ok(Document {
            file,
            root: root.into_inner(),
            source,
        })
    }

    pub(super) fn into_scene(self) -> Result<Scene, Error> {
        let camera = self.camera()?;
        let resolution = self.resolution()?;
        let min_t = match &self.file.camera.get_ref().min_t {
            Some(min_t) => self.min_t(min_t)?,
            None => match camera.projection {
                Projection::Perspective { .. } => 1.0,
                Projection::Orthographic => 0.0,
            },
        };
        Ok(Scene {
            camera,
            resolution,
            min_t,
            objects: self.objects()?,
        })
    }

    fn camera(&self) -> Result<Camera, Error> {
        let table = self.file.camera.get_ref();
        let eye = self.source.finite("eye", &table.eye)?;
        let view = self.source.direction("view", &table.view)?;
        let up = self.source.direction("up", &table.up)?;
        let width = self.source.length("width", &table.width)?;
        let height = self.source.length("height", &table.height)?;
        let projection = match (table.projection, &table.focal_length) {
            (ProjectionName::Perspective, Some(length)) => Projection::Perspective {
                focal_length: self.source.length("focal_length", length)?,
            },
            (ProjectionName::Orthographic, None) => Projection::Orthographic,
            (ProjectionName::Perspective, None) => {
                return Err(self.source.error(
                    self.file.camera.span(),
                    "a perspective camera needs a `focal_length`",
                    "add the distance from the eye to the image plane: focal_length = 1.0",
                ));
            }
            (ProjectionName::Orthographic, Some(length)) => {
                return Err(self.source.error(
                    length.span(),
                    "an orthographic camera has no focal length: its rays are parallel",
                    "remove `focal_length`, or set projection = \"perspective\"",
                ));
            }
        };
        Camera::new(eye, view, up, (width, height), projection).ok_or_else(|| {
            self.source.error(
                table.up.span(),
                "`up` is parallel to `view`, so the direction to the camera's right is undefined",
                "turn `up` away from the line of sight",
            )
        })
    }

    fn resolution(&self) -> Result<Resolution, Error> {
        let resolution = &self.file.camera.get_ref().resolution;
        let [n_x, n_y] = *resolution.get_ref();
        if n_x == 0 || n_y == 0 || n_x.saturating_mul(n_y) > MOST_PIXELS {
            return Err(self.source.error(
                resolution.span(),
                format!("a film can't have {n_x}×{n_y} pixels"),
                format!("use at least one column and one row, and at most {MOST_PIXELS} pixels"),
            ));
        }
        Ok(Resolution { n_x, n_y })
    }

    fn objects(&self) -> Result<Vec<Shape>, Error> {
        let Some(DeValue::Array(tables)) = self.root.get("object").map(Spanned::get_ref) else {
            return Ok(Vec::new());
        };
        let values = tables.iter().filter_map(|table| table.get_ref().as_table());
        let objects = self.file.object.iter().zip(values);
        let table = |(object, values): (&Spanned<ObjectType>, _)| ObjectTable {
            source: self.source,
            kind: object.get_ref().kind,
            span: object.span(),
            values,
        };
        objects.map(|object| table(object).shape()).collect()
    }

    fn min_t(&self, number: &Spanned<f64>) -> Result<f64, Error> {
        let value = self.source.number("min_t", number)?;
        if value < 0.0 {
            return Err(self.source.error(
                number.span(),
                format!("`min_t` is {value}, behind the eye"),
                "use 0 (the eye) or more; `min_t` is measured in multiples of the direction vector's length",
            ));
        }
        Ok(value)
    }
}
