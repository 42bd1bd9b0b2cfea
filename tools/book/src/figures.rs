//! Every figure of the book, by name. A program makes each figure, and the check compares the
//! stored file with what the program makes now.

mod boxes;
mod camera;
mod drawing;
mod lamp;
mod loops;
mod nine_pixels;
mod pictures;
mod shapes;
mod stills;
mod student_progress;

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use pinhole_course::checkout::Checkout;

use crate::error::{Problem, ProblemAndRemedy, Result};
use crate::html::{escaped, heads};
use crate::record;
pub use drawing::colour;

/// A figure's file: its content, and the extension of its name.
pub struct FigureFile {
    /// `svg` or `png`.
    pub extension: &'static str,
    /// The file's content.
    pub content: Vec<u8>,
}

/// Makes one figure.
pub type Maker = fn(&Checkout) -> Result<FigureFile>;

/// All makers by the figure's name.
pub fn makers() -> BTreeMap<&'static str, Maker> {
    let makers: [(&'static str, Maker); 51] = [
        ("camera_obscura", camera::camera_obscura),
        ("ray_parameter", camera::ray_parameter),
        ("pinhole_and_image_plane", camera::pinhole_and_image_plane),
        ("camera_frame", camera::camera_frame),
        ("projection_rays", camera::projection_rays),
        ("three_spaces", camera::three_spaces),
        ("pixel_space", camera::pixel_space),
        ("viewing_ray", camera::viewing_ray),
        ("two_loops", shapes::two_loops),
        ("loops_by_objects", loops::loops_by_objects),
        ("loops_by_pixels", loops::loops_by_pixels),
        ("implicit_and_parametric", shapes::implicit_and_parametric),
        ("plane_and_ray", shapes::plane_and_ray),
        ("sphere_and_line", shapes::sphere_and_line),
        ("sphere_by_pythagoras", shapes::sphere_by_pythagoras),
        ("triangle_alpha_beta", shapes::triangle_alpha_beta),
        ("soup_of_triangles", shapes::soup_of_triangles),
        ("first_hit_along_ray", shapes::first_hit_along_ray),
        ("slabs", boxes::slabs),
        ("boxes_by_depth", boxes::boxes_by_depth),
        ("tree_walk", boxes::tree_walk),
        ("walk_steps", boxes::walk_steps),
        ("tests_per_pixel", boxes::tests_per_pixel),
        ("tests_by_triangles", boxes::tests_by_triangles),
        ("three_outputs_bunny", pictures::three_outputs_bunny),
        ("three_outputs_boxes", pictures::three_outputs_boxes),
        ("image_function", pictures::image_function),
        (
            "projections_side_by_side",
            pictures::projections_side_by_side,
        ),
        ("normal_colours", pictures::normal_colours),
        ("lit", lamp::scene_with_lamp),
        ("so_far_viewing_rays", |it| {
            student_progress::after_shapes(0, it)
        }),
        ("so_far_plane", |it| student_progress::after_shapes(1, it)),
        ("so_far_sphere", |it| student_progress::after_shapes(2, it)),
        ("so_far_triangle", |it| {
            student_progress::after_shapes(3, it)
        }),
        ("so_far_soup", |it| student_progress::after_shapes(4, it)),
        ("nine_plane", nine_pixels::nine_plane),
        ("nine_sphere", nine_pixels::nine_sphere),
        ("nine_triangle", nine_pixels::nine_triangle),
        ("pixel_to_ray", stills::pixel_to_ray),
        ("sphere_roots", stills::sphere_roots),
        ("projections", stills::projections),
        ("triangle_weights", shapes::triangle_alpha_beta),
        ("breaking_distance", stills::breaking_distance),
        ("sphere_from_afar", stills::sphere_from_afar),
        ("sphere_in_f32", stills::sphere_in_f32),
        ("study_sphere", |it| plot("trade-sphere", it)),
        ("study_plane", |it| plot("trade-plane", it)),
        ("study_triangle", |it| plot("trade-triangle", it)),
        ("study_conditioning", |it| plot("conditioning", it)),
        ("study_distance", |it| plot("sphere-distance", it)),
        ("study_leaks", |it| plot("mesh", it)),
    ];
    makers.into()
}

/// A plot of the study's record.
fn plot(name: &str, checkout: &Checkout) -> Result<FigureFile> {
    Ok(FigureFile {
        extension: "svg",
        content: record::plot(&format!("{name}.svg"), checkout)?,
    })
}

/// The folder of figures.
pub fn folder(checkout: &Checkout) -> PathBuf {
    checkout.book().join("src/figures")
}

/// The headings of pictures that are side by side in one file.
fn heads_of(name: &str) -> &'static [&'static str] {
    match name {
        "three_outputs_boxes" | "three_outputs_bunny" => &["id", "depth", "normal"],
        name if name.starts_with("so_far") => &["id", "normal"],
        "image_function" => &["16 × 9", "160 × 90"],
        "projections_side_by_side" => &["perspective", "orthographic"],
        "tests_per_pixel" => &["normal", "one box", "a tree of boxes"],
        "sphere_from_afar" | "sphere_in_f32" => &["10", "10³", "10⁵", "10⁷", "10⁸", "10⁹"],
        "breaking_distance" => &[
            "quadratic formula, f32",
            "quadratic formula, f64",
            "Pythagorean form, f64",
        ],
        _ => &[],
    }
}

/// The HTML of a stored figure. A drawing is inserted into the page itself, so that it uses the
/// page's colours, light or dark. Its file has one line for each element.
pub fn shown(
    name: &str,
    alternative: &str,
    to_root: &str,
    checkout: &Checkout,
) -> std::result::Result<String, ProblemAndRemedy> {
    let alternative = escaped(alternative);
    let file = |extension: &str| folder(checkout).join(format!("{name}.{extension}"));
    if file("png").is_file() {
        let heads = match heads_of(name) {
            [] => String::new(),
            words => heads(words),
        };
        return Ok(format!(
            "{heads}<img src=\"{to_root}figures/{name}.png\" alt=\"{alternative}\" loading=\"lazy\">"
        ));
    }
    let drawing = fs::read_to_string(file("svg")).map_err(|_| {
        let remedy = "add its maker to tools/book/src/figures.rs, then: \
                      cargo pinhole book figures";
        (format!("there is no figure `{name}`"), remedy.to_owned())
    })?;
    let named = format!("<svg class=\"drawing\" role=\"img\" aria-label=\"{alternative}\" ");
    Ok(drawing.trim_end().replacen("<svg ", &named, 1))
}

/// Makes and stores the named figures, or all.
pub fn keep(names: &[String], checkout: &Checkout) -> Result<()> {
    for (name, make) in makers() {
        if names.is_empty() || names.iter().any(|wanted| wanted == name) {
            let made = make(checkout)?;
            let file = folder(checkout).join(format!("{name}.{}", made.extension));
            checkout.write(file, made.content)?;
        }
    }
    Ok(())
}

/// Figures that differ from what their program makes, or that no program makes.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    let mut kept = BTreeMap::new();
    for entry in fs::read_dir(folder(checkout))
        .into_iter()
        .flatten()
        .flatten()
    {
        let content = fs::read(entry.path()).unwrap_or_default();
        kept.insert(entry.file_name().to_string_lossy().into_owned(), content);
    }
    let mut made = BTreeMap::new();
    for (name, make) in makers() {
        let FigureFile { extension, content } = make(checkout)?;
        made.insert(format!("{name}.{extension}"), content);
    }
    Ok(compare(&kept, &made))
}

type Files = BTreeMap<String, Vec<u8>>;

fn compare(kept: &Files, made: &Files) -> Vec<Problem> {
    let problem = |name: &String, what: &str, remedy: &str| {
        Problem::of(PathBuf::from("book/src/figures").join(name), what, remedy)
    };
    let again = "make it again and look at it: cargo pinhole book figures";
    let mut problems = Vec::new();
    for (name, content) in made {
        match kept.get(name) {
            None => problems.push(problem(name, "the figure is missing", again)),
            Some(old) if old != content => {
                problems.push(problem(name, "the figure is out of date", again));
            }
            Some(_) => {}
        }
    }
    for name in kept.keys().filter(|name| !made.contains_key(*name)) {
        let remedy = "remove it, or add its maker to tools/book/src/figures.rs";
        problems.push(problem(name, "no program makes this figure", remedy));
    }
    problems
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stale_a_missing_and_a_foreign_figure_are_problems() {
        let files = |files: &[(&str, &str)]| -> Files {
            let owned = files
                .iter()
                .map(|(name, text)| ((*name).into(), (*text).into()));
            owned.collect()
        };
        let made = files(&[("a.svg", "1"), ("b.svg", "2"), ("c.svg", "3")]);
        let kept = files(&[("a.svg", "1"), ("b.svg", "old"), ("d.svg", "4")]);
        let problems = compare(&kept, &made);
        let told: Vec<&str> = problems
            .iter()
            .map(|problem| problem.problem.as_str())
            .collect();
        let expected = [
            "the figure is out of date",
            "the figure is missing",
            "no program makes this figure",
        ];
        assert_eq!(told, expected);
    }
}
