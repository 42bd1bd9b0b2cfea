//! A strip: the expected picture, what a mistake casts, and where they differ, side by side.

use image::RgbImage;
use pinhole::film::HIT_CHANNELS;
use pinhole::judge::Golden;
use pinhole::{Film, Scene, false_colour};
use pinhole_course::assignment::Assignment;

use super::{StripSubject, View};
use crate::error::Result;
use crate::png::{beside, opaque, png};

/// A strip, and what it shows.
pub struct Strip {
    /// See [`StripSubject`].
    pub shown: StripSubject,
    /// The file.
    pub png: Vec<u8>,
}

/// Pixels between two pictures.
const GAP: u32 = 4;

/// A scene with its golden film.
pub struct SceneGolden {
    /// The scene's name.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// Mitsuba's film of it.
    pub golden: Golden,
}

impl SceneGolden {
    /// Reads the scene and its film.
    pub fn read(name: &str, assignment: &Assignment) -> Result<SceneGolden> {
        let film = assignment.golden().join(format!("{name}.exr"));
        Ok(SceneGolden {
            name: name.into(),
            scene: Scene::read(&assignment.scene(name))?,
            golden: Golden::read(&film)?,
        })
    }

    /// A film of the scene in false colours. Depths span the golden's range.
    pub fn picture(&self, film: &Film, view: View) -> RgbImage {
        let per_t = self.scene.camera.depth_per_t();
        match view {
            View::Id => false_colour::id(film),
            View::Depth => {
                let range = false_colour::depth_range(self.golden.film(), per_t);
                false_colour::depth(film, per_t, range)
            }
            View::Normal => false_colour::normal(film),
        }
    }

    /// The strip of a film in one view.
    pub fn strip(&self, film: &Film, view: View) -> Result<Strip> {
        let missed = HIT_CHANNELS.map(|channel| self.golden.missed(film, channel));
        let of = film.resolution().pixels();
        let is_wrong = |at: &usize| missed.iter().any(|channel| channel[*at]);
        let pictures = [
            self.picture(self.golden.film(), view),
            self.picture(film, view),
            false_colour::difference(&self.golden, film),
        ];
        Ok(Strip {
            shown: StripSubject {
                scene: self.name.clone(),
                view,
                pixels: (0..of).filter(is_wrong).count(),
                of,
            },
            png: png(&beside(&pictures.map(|picture| opaque(&picture)), GAP))?,
        })
    }
}
