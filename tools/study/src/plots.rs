//! The study's eight plots as SVG, one for each cause. Words and axes take the colour of the
//! page that a plot stands in, light or dark; on a page 350 pixels wide, words are 11 high.

mod conditioning;
mod leaks;
mod paper;
mod sweep;
mod trade;

use std::fs;
use std::path::Path;

use crate::result::Study;

/// The families that are plotted, by shape: far away, in other units, and from the side.
const FAMILIES: [(&str, &str); 3] = [
    ("sphere", "distance"),
    ("sphere", "scale"),
    ("triangle", "edge-on"),
];

/// Draws every plot that the study has data for, and says what files were written. A study of
/// one family shows that family, for every shape that has it.
pub fn draw(study: &Study, folder: &Path) -> Result<Vec<String>, String> {
    let mut plots = Vec::new();
    for sweep in study.families.iter().filter(|sweep| sweep.data == "f64") {
        let name = (sweep.shape.as_str(), sweep.family.as_str());
        let is_shown = study.trades.is_empty() || FAMILIES.contains(&name);
        if is_shown && sweep.points.len() > 1 {
            let is_it = |it: &&crate::result::Sweep| {
                (it.shape.as_str(), it.family.as_str()) == name && it.data == "f32"
            };
            let narrow = study.families.iter().find(is_it);
            plots.push((
                format!("{}-{}.svg", name.0, name.1),
                sweep::svg(sweep, narrow),
            ));
        }
    }
    if !study.trades.is_empty() {
        for shape in ["sphere", "plane", "triangle"] {
            plots.push((format!("trade-{shape}.svg"), trade::svg(study, shape)));
        }
    }
    if !study.conditioning.is_empty() {
        plots.push(("conditioning.svg".into(), conditioning::svg(study)));
    }
    if !study.meshes.is_empty() {
        plots.push(("mesh.svg".into(), leaks::svg(&study.meshes)));
    }
    for (name, svg) in &plots {
        fs::write(folder.join(name), svg).map_err(|error| error.to_string())?;
    }
    Ok(plots.into_iter().map(|(name, _)| name).collect())
}
