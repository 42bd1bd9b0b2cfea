//! The shapes that a ray can meet. Students write their intersections.
//!
//! A shape is one file of this folder: its data, how it is read from a scene file and
//! from a question film, and how it is put into words. The table below lists them all.

mod canned;
mod disk;
mod plane;
mod soup;
mod sphere;
mod table;
mod triangle;

use std::fmt;
use std::ops::Range;
use std::path::Path;

use glam::DVec3;
use serde::{Deserialize, Serialize};
use toml::de::DeTable;

use crate::error::Error;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::{Intersection, Ray};
use crate::source::Source;

pub use canned::Canned;
pub use disk::Disk;
pub use plane::Plane;
pub use soup::TriangleSoup;
pub use sphere::Sphere;
pub(crate) use table::ObjectTable;
pub use triangle::Triangle;

/// How a shape is read from files and put into words. Each shape implements it in its own file.
trait Notation: Sized {
    /// The keys of its table in a scene file; all are needed.
    const KEYS: &'static [&'static str];

    /// The keys that name files.
    const FILE_KEYS: &'static [&'static str] = &[];

    /// Reads it from a scene file.
    fn read_table(table: &ObjectTable<'_>) -> Result<Self, Error>;

    /// Reads it from a pixel of a question film.
    fn read_samples(samples: Samples<'_>) -> Result<Self, String>;

    /// What follows its name in a description.
    fn words(&self, digits: usize) -> String;

    /// Numbers that belong to it and a ray. Every shape of its kind uses the same names.
    fn quantities(&self, _ray: &Ray) -> Vec<Quantity> {
        Vec::new()
    }

    /// Conditions on it and on a ray that meets it, or should, at `point`, which is not
    /// finite for a miss. Every shape of its kind uses the same names.
    fn conditions(&self, _ray: &Ray, _point: DVec3) -> Vec<Condition> {
        Vec::new()
    }

    /// Another point where the same ray meets it, and what that point is called.
    fn other(&self, _ray: &Ray, _there: Intersection) -> Option<(&'static str, Intersection)> {
        None
    }
}

/// Makes [`Shape`] and [`ShapeKind`] from a table of names and types.
macro_rules! shapes {
    ($($name:literal => $shape:ident($data:ty),)*) => {
        /// Any shape. An assignment need not have them all.
        #[non_exhaustive]
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub enum Shape {
            $(
                #[doc = concat!("See [`", stringify!($data), "`].")]
                $shape($data),
            )*
        }

        /// Which shape, by its name in scene files and in `assignment.toml`.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        pub enum ShapeKind {
            $(
                #[doc = concat!("A [`", stringify!($data), "`].")]
                #[serde(rename = $name)]
                $shape,
            )*
        }

        impl Shape {
            /// Which shape it is.
            pub fn kind(&self) -> ShapeKind {
                match self {
                    $(Shape::$shape(_) => ShapeKind::$shape,)*
                }
            }

            /// Its numbers in words, with this many digits.
            pub fn words(&self, digits: usize) -> String {
                match self {
                    $(Shape::$shape(data) => data.words(digits),)*
                }
            }

            pub(crate) fn quantities(&self, ray: &Ray) -> Vec<Quantity> {
                match self {
                    $(Shape::$shape(data) => data.quantities(ray),)*
                }
            }

            pub(crate) fn conditions(&self, ray: &Ray, point: DVec3) -> Vec<Condition> {
                match self {
                    $(Shape::$shape(data) => data.conditions(ray, point),)*
                }
            }

            pub(crate) fn other(
                &self,
                ray: &Ray,
                there: Intersection,
            ) -> Option<(&'static str, Intersection)> {
                match self {
                    $(Shape::$shape(data) => data.other(ray, there),)*
                }
            }
        }

        impl ShapeKind {
            /// All shapes there are.
            const ALL: &[ShapeKind] = &[$(ShapeKind::$shape,)*];

            /// Its name in scene files and in `assignment.toml`.
            pub fn name(self) -> &'static str {
                match self {
                    $(ShapeKind::$shape => $name,)*
                }
            }

            fn keys(self) -> &'static [&'static str] {
                match self {
                    $(ShapeKind::$shape => <$data>::KEYS,)*
                }
            }

            /// All shapes' keys that name files.
            pub(crate) fn file_keys() -> impl Iterator<Item = &'static str> {
                [$(<$data>::FILE_KEYS,)*].into_iter().flatten().copied()
            }

            /// Reads such a shape from a pixel of a question film.
            pub(crate) fn read_samples(self, samples: Samples<'_>) -> Result<Shape, String> {
                match self {
                    $(ShapeKind::$shape => <$data>::read_samples(samples).map(Shape::$shape),)*
                }
            }

            fn read_table(self, table: &ObjectTable<'_>) -> Result<Shape, Error> {
                match self {
                    $(ShapeKind::$shape => <$data>::read_table(table).map(Shape::$shape),)*
                }
            }
        }
    };
}

shapes! {
    "sphere" => Sphere(Sphere),
    "plane" => Plane(Plane),
    "triangle" => Triangle(Triangle),
    "soup" => Soup(TriangleSoup),
    "disk" => Disk(Disk),
}

impl Shape {
    /// Reads a shape from a table of a TOML file with the same keys as in a scene file. `span` is
    /// the table's place in the file's text.
    ///
    /// # Errors
    /// If a key is missing or unknown, or its value does not suit the shape.
    pub fn read(
        kind: ShapeKind,
        (path, text): (&Path, &str),
        span: Range<usize>,
        values: &DeTable<'_>,
    ) -> Result<Shape, Error> {
        let source = Source { text, path };
        let table = ObjectTable {
            source,
            kind,
            span,
            values,
        };
        table.shape()
    }

    /// The shape in words: "sphere c = (0, 1, −1), r = 0.75".
    pub fn describe(&self, digits: usize) -> String {
        format!("{} {}", self.kind(), self.words(digits))
    }
}

impl ShapeKind {
    /// The shapes that it is made of, if any. It is met wherever one of them is met.
    pub fn parts(self) -> &'static [ShapeKind] {
        match self {
            ShapeKind::Soup => &[ShapeKind::Triangle],
            _ => &[],
        }
    }
}

impl fmt::Display for ShapeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
