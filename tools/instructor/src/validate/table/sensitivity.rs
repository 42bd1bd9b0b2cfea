//! The smallest errors that the scenes detect.

use pinhole::words::number;

use super::QUIET;
use crate::validate::sensitivity::{Kind, Sensitivity};

const NOTE: &str = "
The smallest error that each scene detects, in steps of a factor of 1.26. The camera is
shifted by this many pixels, and normals are tilted by this many radians. The focal
length and t are multiplied by 1 plus this number.
";

/// A row for each scene, a column for each kind of error.
pub fn table(scenes: &[Sensitivity]) -> String {
    let names = scenes.iter().map(|scene| scene.scene.len());
    let width = names.max().unwrap_or(0) + 2;
    let heads: String = Kind::ALL.map(title).map(in_column).concat();
    let mut text = format!("{NOTE}\n{QUIET}  {:<width$}{heads}{QUIET:#}\n", "");
    for scene in scenes {
        let cell = |kind| in_column(&cell(scene.least.get(&kind).copied(), kind));
        let cells: String = Kind::ALL.map(cell).concat();
        text += &format!("  {:<width$}{cells}\n", scene.scene);
    }
    text
}

fn in_column(text: &str) -> String {
    format!("{text:>14}")
}

fn title(kind: Kind) -> &'static str {
    match kind {
        Kind::CameraShift => "camera shift",
        Kind::FocalLength => "focal length",
        Kind::T => "t",
        Kind::NormalTilt => "normal tilt",
    }
}

/// The smallest error that is detected, if the scene can have such an error and any was
/// detected.
fn cell(least: Option<Option<f64>>, kind: Kind) -> String {
    match least {
        None => "–".into(),
        Some(None) => format!("> {}", number(kind.most(), 2)),
        Some(Some(least)) => number(least, 2),
    }
}
