//! The tables of a scene file as serde reads them, before anything is checked.

use glam::DVec3;
use serde::Deserialize;
use toml::Spanned;

use crate::shape::ShapeKind;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub(super) camera: Spanned<CameraTable>,
    #[serde(default)]
    pub(super) object: Vec<Spanned<ObjectType>>,
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

/// The part of an object that is the same for all shapes; its shape reads the rest.
#[derive(Deserialize)]
pub(super) struct ObjectType {
    #[serde(rename = "type")]
    pub(super) kind: ShapeKind,
}
