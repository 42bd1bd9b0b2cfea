//! Three pictures side by side.

use image::{Rgb, RgbImage};
use pinhole::film::HIT_CHANNELS;
use pinhole::judge::Golden;
use pinhole::{Film, false_colour};

use super::Told;
use crate::error::{Error, Result};

/// A strip, and what is told of it.
pub struct Strip {
    /// See [`Told`].
    pub told: Told,
    /// The file.
    pub png: Vec<u8>,
}

/// Pixels between two pictures.
const GAP: u32 = 4;

/// Expected, theirs, difference, in the picture that shows the difference.
pub fn strip(scene: &str, golden: &Golden, film: &Film, depth_per_t: f64) -> Result<Strip> {
    let [ids, ts, xs, ys, zs] = HIT_CHANNELS.map(|channel| golden.missed(film, channel));
    let all = film.resolution().pixels();
    let count = |wrong: &dyn Fn(usize) -> bool| (0..all).filter(|at| wrong(*at)).count();
    let objects = count(&|at| ids[at]);
    let depths = count(&|at| !ids[at] && ts[at]);
    let pixels = count(&|at| ids[at] || ts[at] || xs[at] || ys[at] || zs[at]);
    let normals = pixels - objects - depths;
    let range = false_colour::depth_range(golden.film(), depth_per_t);
    let most = objects.max(depths).max(normals);
    let picture = match most {
        most if most == objects => "id",
        most if most == depths => "depth",
        _ => "normal",
    };
    let draw = |film| match picture {
        "id" => false_colour::id(film),
        "depth" => false_colour::depth(film, depth_per_t, range.clone()),
        _ => false_colour::normal(film),
    };
    let pictures = [
        draw(golden.film()),
        draw(film),
        false_colour::difference(golden, film),
    ];
    Ok(Strip {
        told: Told {
            scene: scene.into(),
            picture: picture.into(),
            pixels,
            of: all,
        },
        png: png(&beside(&pictures, GAP))?,
    })
}

/// Pictures of the same height beside each other, on white.
pub fn beside(pictures: &[RgbImage], gap: u32) -> RgbImage {
    let height = pictures.iter().map(RgbImage::height).max().unwrap_or(0);
    let width: u32 = pictures.iter().map(RgbImage::width).sum();
    let width = width + gap * (pictures.len() as u32).saturating_sub(1);
    let mut all = RgbImage::from_pixel(width, height, Rgb([255; 3]));
    let mut x = 0;
    for picture in pictures {
        image::imageops::replace(&mut all, picture, x.into(), 0);
        x += picture.width() + gap;
    }
    all
}

/// Pictures of the same width below each other, on white.
pub fn stacked(pictures: &[RgbImage], gap: u32) -> RgbImage {
    let turned: Vec<RgbImage> = pictures.iter().map(image::imageops::rotate90).collect();
    image::imageops::rotate270(&beside(&turned.into_iter().rev().collect::<Vec<_>>(), gap))
}

/// The picture as a PNG file.
pub fn png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut file = std::io::Cursor::new(Vec::new());
    picture
        .write_to(&mut file, image::ImageFormat::Png)
        .map_err(|error| Error::environment(format!("no PNG: {error}"), "report this"))?;
    Ok(file.into_inner())
}
