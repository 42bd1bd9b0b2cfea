//! The study's eight plots as SVG. Text and axes take the text colour of the surrounding page,
//! light or dark. On a page 350 pixels wide, text is 11 pixels high.

mod conditioning;
mod leaks;
mod paper;
mod sweep;
mod trade;

use std::fs;
use std::path::Path;

use crate::result::{Study, Sweep};

/// The families that are plotted, by shape: distant, in other units, and edge-on.
const FAMILIES: [(&str, &str); 3] = [
    ("sphere", "distance"),
    ("sphere", "scale"),
    ("triangle", "edge-on"),
];

/// Draws every plot that the study has data for, and returns the names of the files. A study of
/// one family plots that family, for every shape that has it.
pub fn draw(study: &Study, folder: &Path) -> std::io::Result<Vec<String>> {
    let findings = &study.findings;
    let mut plots = Vec::new();
    for wide in findings.families.iter().filter(|it| it.data == "f64") {
        let name = (wide.shape, wide.family);
        let is_shown = findings.trades.is_empty() || FAMILIES.contains(&name);
        if is_shown && wide.points.len() > 1 {
            let is_same = |it: &&Sweep| (it.shape, it.family) == name;
            let both: Vec<_> = findings.families.iter().filter(is_same).collect();
            plots.push((format!("{}-{}.svg", name.0, name.1), sweep::svg(&both)));
        }
    }
    if !findings.trades.is_empty() {
        for shape in ["sphere", "plane", "triangle"] {
            plots.push((format!("trade-{shape}.svg"), trade::svg(findings, shape)));
        }
    }
    if !findings.conditioning.is_empty() {
        plots.push(("conditioning.svg".into(), conditioning::svg(findings)));
    }
    if !findings.meshes.is_empty() {
        plots.push(("mesh.svg".into(), leaks::svg(&findings.meshes)));
    }
    for (name, svg) in &plots {
        fs::write(folder.join(name), svg)?;
    }
    Ok(plots.into_iter().map(|(name, _)| name).collect())
}
