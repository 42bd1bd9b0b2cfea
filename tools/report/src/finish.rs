//! What a student who has all points sees: a picture of their own, and what to do next.

use std::path::Path;

use anstyle::{Reset, RgbColor, Style};
use image::RgbImage;
use image::imageops::thumbnail;
use pinhole::false_colour;
use pinhole_course::assignment::Assignment;
use pinhole_course::outcome::Examination;

use crate::escape::printable;
use crate::passage::Passage;
use crate::pictures;
use pinhole_course::error::Result;

/// The end of an assignment: everything is right.
#[derive(Clone, Debug)]
pub struct Finish {
    /// Points that can be earned here.
    pub points: u32,
    /// The scene of the picture.
    pub scene: String,
    /// The normals that the student's own code saw in it.
    pub picture: RgbImage,
    /// The archive to hand in, or the command that packs one.
    pub pack: String,
    /// What to read next.
    pub next: Passage,
}

impl Finish {
    /// `None` unless everything was asked and passes. `check` is the command that checks it all.
    pub fn of(examination: &Examination, assignment: &Assignment, check: &str) -> Option<Finish> {
        let Examination { outcome, films, .. } = examination;
        let finish = assignment.finish.as_ref()?;
        let is_all = outcome.tasks.len() == assignment.tasks.len()
            && outcome.scenes.len() == assignment.scenes.len();
        if !outcome.passes || !is_all {
            return None;
        }
        let mut films = outcome.scenes.iter().zip(films);
        let (_, film) = films.find(|(scene, _)| scene.name == finish.scene)?;
        Some(Finish {
            points: outcome.possible,
            scene: finish.scene.clone(),
            picture: false_colour::normal(film.film.as_ref()?),
            pack: format!("{check} --pack answers.zip"),
            next: Passage::chapter(&finish.chapter),
        })
    }

    /// Writes the picture.
    pub fn save(&self, path: &Path) -> Result<()> {
        pictures::save(&self.picture, path)
    }

    /// What it means and what to do next, in three lines.
    pub fn words(&self) -> String {
        let Finish {
            points, pack, next, ..
        } = self;
        format!(
            "All {points} points: every answer agrees with Mitsuba's.\n\
             to hand in: {pack}\n\
             read next: {next}\n"
        )
    }

    /// A line that says where the picture is.
    pub fn caption(&self, path: &Path) -> String {
        let path = printable(&path.display().to_string());
        format!("{}, rendered by your code: {path}\n", self.scene)
    }

    /// The picture in a terminal's characters, each an upper and a lower pixel.
    pub fn in_blocks(&self, columns: usize) -> String {
        let width = columns.clamp(1, MOST_COLUMNS) as u32;
        let (full_width, full_height) = self.picture.dimensions();
        let height = (width * full_height / full_width.max(1)).max(2) & !1;
        let small = thumbnail(&self.picture, width, height);
        let colour = |x, y| {
            let [red, green, blue] = small.get_pixel(x, y).0;
            Some(RgbColor(red, green, blue).into())
        };
        let mut text = String::new();
        for y in (0..height).step_by(2) {
            for x in 0..width {
                let style = Style::new()
                    .fg_color(colour(x, y))
                    .bg_color(colour(x, y + 1));
                text.push_str(&format!("{style}▀"));
            }
            text.push_str(&format!("{Reset}\n"));
        }
        text
    }
}

/// Wide enough to recognise the picture.
const MOST_COLUMNS: usize = 64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_in_blocks_has_two_rows_of_pixels_in_each_line() {
        let finish = Finish {
            points: 1,
            scene: "any".into(),
            picture: RgbImage::from_pixel(64, 32, image::Rgb([255, 0, 128])),
            pack: String::new(),
            next: Passage::chapter("Any"),
        };
        let text = finish.in_blocks(8);
        assert_eq!(text.lines().count(), 2);
        assert_eq!(text.matches('▀').count(), 16);
        assert!(
            text.starts_with("\u{1b}[38;2;255;0;128m\u{1b}[48;2;255;0;128m▀"),
            "{text:?}"
        );
    }
}
