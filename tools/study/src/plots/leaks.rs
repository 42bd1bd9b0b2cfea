//! Leaks and double hits of `f64` kernels on closed meshes.

use plotters::prelude::*;

use super::paper::{FAINT, GROUND, INK, colour, text};
use crate::result::MeshTally;

const ROW: i32 = 22;
const LEFT: i32 = 190;
const WIDTH: f64 = 500.0;

/// Two bars for every kernel and aim.
pub fn svg(meshes: &[MeshTally]) -> Result<String, String> {
    let meshes: Vec<&MeshTally> = meshes.iter().filter(|mesh| mesh.numbers == "f64").collect();
    let height = 80 + meshes.len() as u32 * ROW as u32 + 10;
    let mut svg = String::new();
    let backend = SVGBackend::with_string(&mut svg, (860, height));
    draw(&meshes, backend).map_err(|error| error.to_string())?;
    Ok(svg)
}

fn draw(meshes: &[&MeshTally], backend: SVGBackend) -> Result<(), Box<dyn std::error::Error>> {
    let paper = backend.into_drawing_area();
    paper.fill(&GROUND)?;
    let title = "From inside a closed mesh, a ray meets the surface once. These were aimed at edges and corners:";
    paper.draw(&Text::new(title, (18, 22), text(16, INK)))?;
    let (leak, double) = (colour(0), colour(1));
    for (x, what, colour) in [
        (LEFT, "leaks: the ray meets nothing", leak),
        (LEFT + 260, "double hits: it meets two or more", double),
    ] {
        paper.draw(&Rectangle::new([(x, 42), (x + 12, 54)], colour.filled()))?;
        paper.draw(&Text::new(what, (x + 18, 48), text(14, INK)))?;
    }
    for (row, mesh) in meshes.iter().enumerate() {
        let y = 70 + row as i32 * ROW;
        if row % 2 == 0 {
            paper.draw(&PathElement::new([(18, y - 2), (842, y - 2)], FAINT))?;
        }
        let name = format!("{}, {}", mesh.kernel, mesh.aimed_at);
        paper.draw(&Text::new(name, (18, y + 9), text(13, INK)))?;
        let share = |count: u64| count as f64 / mesh.rays as f64;
        let width = |count: u64| (share(count) * WIDTH).ceil() as i32;
        let (leaks, doubles) = (width(mesh.leaks), width(mesh.double_hits));
        paper.draw(&Rectangle::new(
            [(LEFT, y + 2), (LEFT + leaks, y + 9)],
            leak.filled(),
        ))?;
        paper.draw(&Rectangle::new(
            [(LEFT, y + 10), (LEFT + doubles, y + 17)],
            double.filled(),
        ))?;
        let figure = |count: u64| match count {
            0 => "0".into(),
            _ => format!("{:.2} %", 100.0 * share(count)),
        };
        let figures = format!("{} / {}", figure(mesh.leaks), figure(mesh.double_hits));
        let end = LEFT + leaks.max(doubles) + 8;
        paper.draw(&Text::new(figures, (end, y + 9), text(13, INK)))?;
    }
    Ok(paper.present()?)
}
