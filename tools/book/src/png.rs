//! Puts pictures side by side and writes PNG files. Gaps are transparent, because the page may be
//! light or dark.

use image::imageops::{FilterType, replace, resize, rotate90, rotate270};
use image::{DynamicImage, ImageFormat, RgbImage, Rgba, RgbaImage};

use crate::error::{Error, Result};

/// The picture with an alpha channel, opaque everywhere.
pub fn opaque(picture: &RgbImage) -> RgbaImage {
    DynamicImage::from(picture.clone()).into_rgba8()
}

/// The picture with each pixel repeated this many times in both directions.
pub fn enlarged(picture: &RgbImage, times: u32) -> RgbaImage {
    let (width, height) = (picture.width() * times, picture.height() * times);
    opaque(&resize(picture, width, height, FilterType::Nearest))
}

/// Pictures from left to right, with this many pixels between two.
pub fn beside(pictures: &[RgbaImage], gap: u32) -> RgbaImage {
    let height = pictures.iter().map(RgbaImage::height).max().unwrap_or(0);
    let width: u32 = pictures.iter().map(RgbaImage::width).sum();
    let width = width + gap * (pictures.len() as u32).saturating_sub(1);
    let mut all = RgbaImage::from_pixel(width, height, Rgba([0; 4]));
    let mut x = 0;
    for picture in pictures {
        replace(&mut all, picture, x.into(), 0);
        x += picture.width() + gap;
    }
    all
}

/// Pictures from top to bottom.
pub fn stacked(pictures: &[RgbaImage], gap: u32) -> RgbaImage {
    let turned: Vec<RgbaImage> = pictures.iter().rev().map(rotate90).collect();
    rotate270(&beside(&turned, gap))
}

/// The picture as a PNG file.
pub fn png(picture: &RgbaImage) -> Result<Vec<u8>> {
    let mut file = std::io::Cursor::new(Vec::new());
    picture
        .write_to(&mut file, ImageFormat::Png)
        .map_err(|error| {
            Error::environment(format!("cannot write a PNG: {error}"), "report this")
        })?;
    Ok(file.into_inner())
}
