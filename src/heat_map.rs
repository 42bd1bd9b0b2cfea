//! Pictures of a counter: how many tests each pixel took. They are for people; no verdict is
//! made from them.

use std::fmt;

use image::{Rgb, RgbImage};

use crate::false_colour::BACKGROUND;
use crate::film::{Film, TESTS};
use crate::words::number;

/// Which colour stands for how many tests.
///
/// Films that are shown side by side share one scale, because a film that took ten times as many
/// tests everywhere would look right with a scale of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatScale {
    most: f64,
}

/// The colours at the quarters of the scale, in words.
const COLOURS: [&str; 5] = ["black", "purple", "red", "orange", "pale yellow"];

impl HeatScale {
    /// A scale that spans the tests of all these films; `None` if one of them doesn't count
    /// any. Its end is a multiple of four, so that its quarters are whole.
    pub fn of(films: &[&Film]) -> Option<HeatScale> {
        let counts = films.iter().map(|film| film.channel(TESTS));
        let counts: Vec<&[f32]> = counts.collect::<Option<_>>()?;
        let finite = counts
            .concat()
            .into_iter()
            .filter(|tests| tests.is_finite());
        let most = f64::from(finite.fold(1.0, f32::max));
        Some(HeatScale {
            most: 4.0 * (most / 4.0).ceil(),
        })
    }

    /// From black for no tests through purple, red and orange to pale yellow for the most. A pixel
    /// without a finite number of tests gets the colour of a miss.
    pub fn picture(&self, film: &Film) -> RgbImage {
        let resolution = film.resolution();
        let tests = film.channel(TESTS).unwrap_or_default();
        RgbImage::from_fn(resolution.n_x as u32, resolution.n_y as u32, |x, y| {
            let index = y as usize * resolution.n_x + x as usize;
            match tests.get(index) {
                Some(tests) if tests.is_finite() => heat(f64::from(*tests) / self.most),
                _ => BACKGROUND,
            }
        })
    }

    /// Five colours in words, from none to the most, and how many tests each stands for.
    pub fn steps(&self) -> [(&'static str, f64); 5] {
        [0, 1, 2, 3, 4].map(|step| (COLOURS[step], step as f64 / 4.0 * self.most))
    }

    /// The colours from none to the most, from left to right.
    pub fn bar() -> RgbImage {
        RgbImage::from_fn(256, 1, |x, _| heat(f64::from(x) / 255.0))
    }
}

impl fmt::Display for HeatScale {
    /// `black 0, purple 11, red 22, orange 33, pale yellow 44 tests`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let step = |(colour, tests): (&str, f64)| format!("{colour} {}", number(tests, 9));
        write!(f, "{} tests", self.steps().map(step).join(", "))
    }
}

/// The tests of all pixels together.
pub fn sum(film: &Film) -> f64 {
    let tests = film.channel(TESTS).unwrap_or_default().iter();
    tests.map(|tests| f64::from(*tests)).sum()
}

/// The colour at a share of the scale, from 0 to 1 (Smith and van der Walt's Inferno, 2015).
fn heat(share: f64) -> Rgb<u8> {
    let colour = colorous::INFERNO.eval_continuous(share.clamp(0.0, 1.0));
    Rgb([colour.r, colour.g, colour.b])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Resolution;

    /// A film of a row that counts these tests.
    fn row(tests: &[f32]) -> Film {
        let n_x = tests.len();
        Film::new(Resolution { n_x, n_y: 1 }, Vec::new()).with(TESTS, tests.to_vec())
    }

    #[test]
    fn films_side_by_side_share_a_scale_of_whole_quarters() {
        let (few, many) = (row(&[0.0, 10.0]), row(&[5.0, 41.0]));
        let scale = HeatScale::of(&[&few, &many]).expect("both count");
        assert_eq!(
            scale.steps().map(|(_, tests)| tests),
            [0.0, 11.0, 22.0, 33.0, 44.0]
        );
        assert_eq!(
            scale.to_string(),
            "black 0, purple 11, red 22, orange 33, pale yellow 44 tests"
        );
        let [few, many] = [&few, &many].map(|film| scale.picture(film));
        assert_eq!(few.get_pixel(0, 0), &heat(0.0));
        assert_eq!(few.get_pixel(1, 0), &heat(10.0 / 44.0));
        assert_eq!(many.get_pixel(1, 0), &heat(41.0 / 44.0));
    }

    #[test]
    fn what_counts_nothing_has_no_scale() {
        let resolution = Resolution { n_x: 1, n_y: 1 };
        let silent = Film::of_hits(resolution, &[None]);
        assert_eq!(HeatScale::of(&[&silent]), None);
        assert_eq!(HeatScale::of(&[&row(&[3.0]), &silent]), None);
    }

    #[test]
    fn hostile_counts_have_a_colour() {
        let film = row(&[f32::NAN, f32::INFINITY, -3.0, f32::MAX]);
        let scale = HeatScale::of(&[&film]).expect("it counts");
        let picture = scale.picture(&film);
        let colours: Vec<_> = picture.pixels().copied().collect();
        assert_eq!(colours, [BACKGROUND, BACKGROUND, heat(0.0), heat(1.0)]);
    }

    #[test]
    fn the_words_of_the_scale_name_its_colours() {
        let colours = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| heat(share).0);
        assert!(colours[0].iter().all(|value| *value < 10), "{colours:?}");
        let [red, green, blue] = colours[1];
        assert!(red > 2 * green && blue > red, "{colours:?}");
        let [red, green, blue] = colours[2];
        assert!(red > 2 * green && red > 2 * blue, "{colours:?}");
        let [red, green, blue] = colours[3];
        assert!(red > 200 && green > 100 && blue < 50, "{colours:?}");
        assert!(colours[4].iter().all(|value| *value > 150), "{colours:?}");
    }
}
