//! Plots as SVG: colours that colour-blind people can tell apart, a label on each line,
//! and a light ground of their own, so that they read the same on a dark page.

mod front;
mod leaks;
mod paper;
mod sweep;
mod trade;

use std::fs;
use std::path::Path;

use crate::result::Study;

/// Draws every plot that the study has data for, and says what files were written.
pub fn draw(study: &Study, folder: &Path) -> Result<Vec<String>, String> {
    let mut plots = Vec::new();
    for sweep in study.families.iter().filter(|sweep| sweep.points.len() > 4) {
        let name = format!("{}-{}-{}.svg", sweep.shape, sweep.family, sweep.data);
        plots.push((name, sweep::svg(sweep)?));
    }
    for shape in ["sphere", "plane", "triangle"] {
        if study.speed.iter().any(|speed| speed.shape == shape) && !study.breaking.is_empty() {
            plots.push((format!("trade-{shape}.svg"), trade::svg(study, shape)?));
        }
    }
    if !study.meshes.is_empty() {
        plots.push(("mesh.svg".into(), leaks::svg(&study.meshes)?));
    }
    if !study.scenes.is_empty() {
        plots.push(("front.svg".into(), front::svg(&study.scenes)?));
    }
    for (name, svg) in &plots {
        fs::write(folder.join(name), svg).map_err(|error| error.to_string())?;
    }
    Ok(plots.into_iter().map(|(name, _)| name).collect())
}
