//! The tables of a scene file as serde reads them, before anything is checked.
//!
//! Objects are one flat record rather than a tagged enum, because serde forgets line
//! numbers inside tagged enums.

use glam::DVec3;
use serde::Deserialize;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub(super) camera: Spanned<CameraTable>,
    #[serde(default)]
    pub(super) object: Vec<Spanned<ObjectTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraTable {
    pub(super) projection: ProjectionName,
    pub(super) eye: Spanned<DVec3>,
    pub(super) view: Spanned<DVec3>,
    pub(super) up: Spanned<DVec3>,
    pub(super) focal_length: Option<Spanned<f64>>,
    pub(super) width: Spanned<f64>,
    pub(super) height: Spanned<f64>,
    pub(super) resolution: Spanned<[usize; 2]>,
    pub(super) min_t: Option<Spanned<f64>>,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum ProjectionName {
    Perspective,
    Orthographic,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectTable {
    #[serde(rename = "type")]
    pub(super) kind: Kind,
    pub(super) center: Option<Spanned<DVec3>>,
    pub(super) radius: Option<Spanned<f64>>,
    pub(super) point: Option<Spanned<DVec3>>,
    pub(super) normal: Option<Spanned<DVec3>>,
    pub(super) corners: Option<Spanned<[DVec3; 3]>>,
    pub(super) obj: Option<Spanned<String>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Kind {
    Sphere,
    Plane,
    Triangle,
    Soup,
}

impl Kind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Kind::Sphere => "sphere",
            Kind::Plane => "plane",
            Kind::Triangle => "triangle",
            Kind::Soup => "soup",
        }
    }

    pub(super) fn keys(self) -> &'static [&'static str] {
        match self {
            Kind::Sphere => &["center", "radius"],
            Kind::Plane => &["point", "normal"],
            Kind::Triangle => &["corners"],
            Kind::Soup => &["obj"],
        }
    }
}
