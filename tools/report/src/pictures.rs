//! Writes false-colour pictures.

use std::io::{self, Cursor};
use std::ops::Range;
use std::path::Path;

use image::{ImageFormat, RgbImage};
use pinhole::heat_map::HeatScale;
use pinhole::{Film, false_colour};

use pinhole_course::error::{Result, ResultExt};
use pinhole_course::output;

/// Writes `id`, `depth` and `normal` pictures of a film of hits, with `prefix` before their names
/// and these pixels `faded` (none if the list is empty). Returns their paths.
pub fn write(
    folder: &Path,
    prefix: &str,
    film: &Film,
    depth_per_t: f64,
    range: Range<f64>,
    faded: &[bool],
) -> Result<Vec<String>> {
    let pictures = [
        ("id", false_colour::id(film)),
        ("depth", false_colour::depth(film, depth_per_t, range)),
        ("normal", false_colour::normal(film)),
    ];
    let mut written = Vec::new();
    for (name, mut picture) in pictures {
        false_colour::fade(&mut picture, faded);
        let path = folder.join(format!("{prefix}{name}.png"));
        save(&picture, &path)?;
        written.push(path.display().to_string());
    }
    Ok(written)
}

/// Writes the picture of a film's tests, with `prefix` before its name. Returns its path.
pub fn write_tests(folder: &Path, prefix: &str, film: &Film, scale: &HeatScale) -> Result<String> {
    let path = folder.join(format!("{prefix}tests.png"));
    save(&scale.picture(film), &path)?;
    Ok(path.display().to_string())
}

/// Writes one picture.
pub fn save(picture: &RgbImage, path: &Path) -> Result<()> {
    let mut png = Cursor::new(Vec::new());
    let encoded = picture.write_to(&mut png, ImageFormat::Png);
    let written = encoded.map_err(io::Error::other);
    let written = written.and_then(|()| output::write(path, png.get_ref()));
    written.or_input(
        format_args!("cannot write {}", path.display()),
        "name a folder you may write to",
    )
}
