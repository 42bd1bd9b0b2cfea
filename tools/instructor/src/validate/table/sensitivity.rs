//! The smallest errors that the scenes detect, beside what other rules would.

use pinhole::report::number;

use super::QUIET;
use crate::validate::sensitivity::{Kind, Sensitivity};
use crate::validate::suites::SUITES;

const NOTE: &str = "
The smallest error that each scene detects, in steps of a tenth of a decade, by our rule
and by those of other renderers' test suites. Those were made for lit pictures. Here they
are put to the three false-colour pictures of each film (object, depth, normal; 8 bits),
and detect an error if one of the three fails: a lit picture shows less. What they allow
is that some pixels differ; OSL fails on any single one that differs by more than 0.01,
so that it fails right renderers too, wherever a silhouette passes near a pixel's centre.
";

/// A table for each kind of error.
pub fn table(scenes: &[Sensitivity]) -> String {
    let mut text = String::from(NOTE);
    let width = scenes
        .iter()
        .map(|scene| scene.scene.len())
        .max()
        .unwrap_or(0)
        + 2;
    for kind in Kind::ALL {
        let heads = SUITES.iter().map(|suite| format!("{:>10}", suite.name));
        let heads: String = heads.collect();
        text += &format!(
            "\n{QUIET}  {}\n  {:<width$}{:>10}{heads}{QUIET:#}\n",
            title(kind),
            "",
            "ours"
        );
        for scene in scenes {
            let cells: String = match scene.least.get(&kind) {
                Some(least) => {
                    let all = [least.ours].into_iter().chain(least.suites);
                    all.map(|least| format!("{:>10}", cell(least, kind)))
                        .collect()
                }
                None => format!("{:>10}", "–"),
            };
            text += &format!("  {:<width$}{cells}\n", scene.scene);
        }
    }
    text
}

fn title(kind: Kind) -> &'static str {
    match kind {
        Kind::CameraShift => "camera shifted, pixels",
        Kind::FocalLength => "focal length too long, share of itself",
        Kind::T => "t too large, share of itself",
        Kind::NormalTilt => "normals tilted, radians",
    }
}

fn cell(least: Option<f64>, kind: Kind) -> String {
    match least {
        Some(least) => number(least, 2),
        None => format!("> {}", number(kind.most(), 2)),
    }
}
