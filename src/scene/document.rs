//! From the tables of a scene file to a scene, and every way they can be wrong.

use std::ops::Range;
use std::path::Path;

use glam::DVec3;
use toml::Spanned;

use super::tables::{File, Kind, ObjectTable, ProjectionName};
use super::{MOST_PIXELS, Scene};
use crate::camera::{Camera, Projection, Resolution};
use crate::error::Error;
use crate::mesh;
use crate::shape::{Plane, Shape, Sphere, Triangle};

/// A parsed file that still knows where each value stood.
pub(super) struct Document<'a> {
    file: File,
    text: &'a str,
    path: &'a Path,
}

/// Below this sine of the angle at its first corner a triangle is flat: decimals such
/// as 0.3 are rounded, which lifts corners off a line by about 1e-16 of their size.
const ON_ONE_LINE: f64 = 1e-14;

/// Things a renderer has and ray casting does not.
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

impl<'a> Document<'a> {
    pub(super) fn parse(text: &'a str, path: &'a Path) -> Result<Document<'a>, Error> {
        match toml::from_str(text) {
            Ok(file) => Ok(Document { file, text, path }),
            Err(error) => Err(explain(&error, text, path)),
        }
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
        let objects = self.file.object.iter().map(|object| self.shape(object));
        Ok(Scene {
            camera,
            resolution,
            min_t,
            objects: objects.collect::<Result<_, _>>()?,
        })
    }

    fn camera(&self) -> Result<Camera, Error> {
        let table = self.file.camera.get_ref();
        let eye = self.finite("eye", &table.eye)?;
        let view = self.direction("view", &table.view)?;
        let up = self.direction("up", &table.up)?;
        let width = self.positive("width", &table.width)?;
        let height = self.positive("height", &table.height)?;
        let projection = match (table.projection, &table.focal_length) {
            (ProjectionName::Perspective, Some(length)) => Projection::Perspective {
                focal_length: self.positive("focal_length", length)?,
            },
            (ProjectionName::Orthographic, None) => Projection::Orthographic,
            (ProjectionName::Perspective, None) => {
                return Err(self.error(
                    self.file.camera.span(),
                    "a perspective camera needs a `focal_length`",
                    "add the distance from the eye to the image plane: focal_length = 1.0",
                ));
            }
            (ProjectionName::Orthographic, Some(length)) => {
                return Err(self.error(
                    length.span(),
                    "an orthographic camera has no focal length: its rays are parallel",
                    "remove `focal_length`, or set projection = \"perspective\"",
                ));
            }
        };
        Camera::new(eye, view, up, (width, height), projection).ok_or_else(|| {
            self.error(
                table.up.span(),
                "`up` is parallel to `view`, so no direction is to the right",
                "turn `up` away from the line of sight",
            )
        })
    }

    fn resolution(&self) -> Result<Resolution, Error> {
        let resolution = &self.file.camera.get_ref().resolution;
        let [n_x, n_y] = *resolution.get_ref();
        if n_x == 0 || n_y == 0 || n_x.saturating_mul(n_y) > MOST_PIXELS {
            return Err(self.error(
                resolution.span(),
                format!("a film of {n_x}×{n_y} pixels cannot be cast"),
                format!("use at least one column and one row, and at most {MOST_PIXELS} pixels"),
            ));
        }
        Ok(Resolution { n_x, n_y })
    }

    fn shape(&self, object: &Spanned<ObjectTable>) -> Result<Shape, Error> {
        let table = object.get_ref();
        self.refuse_foreign_keys(table)?;
        let missing = |key: &str| {
            let kind = table.kind.name();
            self.error(
                object.span(),
                format!("this {kind} has no `{key}`"),
                format!("a {kind} needs: {}", table.kind.keys().join(", ")),
            )
        };
        Ok(match table.kind {
            Kind::Sphere => {
                let center = table.center.as_ref().ok_or_else(|| missing("center"))?;
                let radius = table.radius.as_ref().ok_or_else(|| missing("radius"))?;
                Shape::Sphere(Sphere {
                    center: self.finite("center", center)?,
                    radius: self.positive("radius", radius)?,
                })
            }
            Kind::Plane => {
                let point = table.point.as_ref().ok_or_else(|| missing("point"))?;
                let normal = table.normal.as_ref().ok_or_else(|| missing("normal"))?;
                Shape::Plane(Plane {
                    point: self.finite("point", point)?,
                    normal: self.direction("normal", normal)?,
                })
            }
            Kind::Triangle => {
                let corners = table.corners.as_ref().ok_or_else(|| missing("corners"))?;
                Shape::Triangle(Triangle {
                    corners: self.corners(corners)?,
                })
            }
            Kind::Soup => {
                let obj = table.obj.as_ref().ok_or_else(|| missing("obj"))?;
                let folder = self.path.parent().unwrap_or(Path::new(""));
                let soup = mesh::read(&folder.join(obj.get_ref()));
                // A mesh that cannot be read at all is this line's fault.
                Shape::Soup(soup.map_err(|error| match error.position {
                    Some(_) => error,
                    None => self.error(
                        obj.span(),
                        format!("{}: {}", error.path.display(), error.problem),
                        error.remedy,
                    ),
                })?)
            }
        })
    }

    fn refuse_foreign_keys(&self, table: &ObjectTable) -> Result<(), Error> {
        let given = [
            ("center", table.center.as_ref().map(Spanned::span)),
            ("radius", table.radius.as_ref().map(Spanned::span)),
            ("point", table.point.as_ref().map(Spanned::span)),
            ("normal", table.normal.as_ref().map(Spanned::span)),
            ("corners", table.corners.as_ref().map(Spanned::span)),
            ("obj", table.obj.as_ref().map(Spanned::span)),
        ];
        let (kind, keys) = (table.kind.name(), table.kind.keys());
        for (key, span) in given {
            if let Some(span) = span.filter(|_| !keys.contains(&key)) {
                return Err(self.error(
                    span,
                    format!("a {kind} has no `{key}`"),
                    format!(
                        "a {kind} takes: {}; remove `{key}` or change the type",
                        keys.join(", ")
                    ),
                ));
            }
        }
        Ok(())
    }

    fn corners(&self, corners: &Spanned<[DVec3; 3]>) -> Result<[DVec3; 3], Error> {
        let [a, b, c] = *corners.get_ref();
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Err(self.not_finite("corners", corners.span()));
        }
        let (t_1, t_2) = ((b - a).normalize_or_zero(), (c - a).normalize_or_zero());
        if t_1.cross(t_2).length() < ON_ONE_LINE {
            return Err(self.error(
                corners.span(),
                "these corners lie on one line, so the triangle has no area and no normal",
                "move one corner off the line",
            ));
        }
        Ok([a, b, c])
    }

    fn finite(&self, key: &str, vector: &Spanned<DVec3>) -> Result<DVec3, Error> {
        let value = *vector.get_ref();
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.not_finite(key, vector.span()))
        }
    }

    fn direction(&self, key: &str, vector: &Spanned<DVec3>) -> Result<DVec3, Error> {
        let value = self.finite(key, vector)?;
        if value.try_normalize().is_none() {
            return Err(self.error(
                vector.span(),
                format!("`{key}` has no direction: its length is {}", value.length()),
                "give a vector of ordinary length; it need not be unit",
            ));
        }
        Ok(value)
    }

    fn number(&self, key: &str, number: &Spanned<f64>) -> Result<f64, Error> {
        let value = *number.get_ref();
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.not_finite(key, number.span()))
        }
    }

    fn positive(&self, key: &str, number: &Spanned<f64>) -> Result<f64, Error> {
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

    fn min_t(&self, number: &Spanned<f64>) -> Result<f64, Error> {
        let value = self.number("min_t", number)?;
        if value < 0.0 {
            return Err(self.error(
                number.span(),
                format!("`min_t` is {value}, behind the eye"),
                "give 0 (the eye) or more, in multiples of a ray's direction",
            ));
        }
        Ok(value)
    }

    fn not_finite(&self, key: &str, span: Range<usize>) -> Error {
        self.error(
            span,
            format!("`{key}` is not a finite number"),
            "replace nan or inf by a number",
        )
    }

    fn error(
        &self,
        span: Range<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        let (line, column) = place(self.text, span.start);
        Error::new(self.path, problem, remedy).at(line, column)
    }
}

/// What the TOML reader said, with a place and a remedy.
fn explain(error: &toml::de::Error, text: &str, path: &Path) -> Error {
    let said = error
        .message()
        .lines()
        .next()
        .unwrap_or_default()
        .trim_end_matches('.');
    let unknown = said
        .strip_prefix("unknown field `")
        .and_then(|rest| rest.split('`').next());
    let explained = match unknown {
        Some(key) if NOT_MODELLED.contains(&key) => Error::new(
            path,
            format!(
                "`{key}` is unknown: ray casting finds what a ray meets, not how it is lit, so \
                 scenes have no lights, materials or lenses"
            ),
            format!("remove `{key}`"),
        ),
        Some(_) => Error::new(path, said, "remove the key, or correct its spelling"),
        None => Error::new(path, said, "see the scene format in README.md, \"Scenes\""),
    };
    match error.span() {
        Some(span) => {
            let (line, column) = place(text, span.start);
            explained.at(line, column)
        }
        None => explained,
    }
}

/// Line and column, from 1, of a byte offset.
fn place(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(offset)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    )
}
