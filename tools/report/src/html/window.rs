//! The part of a film that a report holds pixel by pixel.

use pinhole::{Pixel, Resolution};
use serde::Serialize;

/// How many pixels of a film in a report are embedded with all their numbers, if it is the report's
/// only film. They take less than 2 MB.
pub const MOST_ALONE: usize = 140_000;

/// The same if the report has several films. Our assignments' scenes have fewer pixels. The limit of
/// one film doesn't depend on the others, because some of these may be withheld.
pub const MOST_EACH: usize = 20_000;

/// The share of a film that fits if at most `most` pixels are embedded.
pub fn share(film: Resolution, most: usize) -> f64 {
    (most as f64 / film.pixels() as f64).min(1.0)
}

/// A rectangle of a film.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    /// Its first column.
    pub left: usize,
    /// Its first row, from the **top**.
    pub top: usize,
    /// How many columns it has.
    pub n_x: usize,
    /// How many rows.
    pub n_y: usize,
}

impl Window {
    /// The window around `centre` that holds this share of a film's pixels, in the film's
    /// proportions.
    pub fn around(centre: Pixel, film: Resolution, share: f64) -> Window {
        let part = |n: usize| ((n as f64 * share.sqrt()) as usize).max(1);
        let [n_x, n_y] = [part(film.n_x), part(film.n_y)];
        let from =
            |centre: usize, part: usize, n: usize| centre.saturating_sub(part / 2).min(n - part);
        Window {
            left: from(centre.i, n_x, film.n_x),
            top: from(film.n_y - 1 - centre.j, n_y, film.n_y),
            n_x,
            n_y,
        }
    }

    /// Whether the whole film is in it.
    pub fn is_whole(&self, film: Resolution) -> bool {
        (self.n_x, self.n_y) == (film.n_x, film.n_y)
    }

    /// The places of its pixels in a film's image order.
    pub fn indices(self, film: Resolution) -> impl Iterator<Item = usize> + Clone {
        let rows = self.top..self.top + self.n_y;
        rows.flat_map(move |y| (self.left..self.left + self.n_x).map(move |x| y * film.n_x + x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILM: Resolution = Resolution { n_x: 400, n_y: 100 };

    #[test]
    fn a_large_film_is_embedded_in_part() {
        assert_eq!(share(FILM, MOST_ALONE), 1.0);
        assert_eq!(share(FILM, MOST_EACH), 0.5);
    }

    #[test]
    fn a_small_film_is_shown_whole() {
        let window = Window::around(Pixel { i: 399, j: 0 }, FILM, 1.0);
        assert!(window.is_whole(FILM));
        assert!(window.indices(FILM).eq(0..40_000));
    }

    #[test]
    fn a_large_film_is_cut_around_its_worst_pixel_and_never_beyond_its_edge() {
        let cut = |i, j| Window::around(Pixel { i, j }, FILM, 0.25);
        let middle = cut(200, 50);
        assert_eq!(
            (middle.left, middle.top, middle.n_x, middle.n_y),
            (100, 24, 200, 50)
        );
        assert_eq!((cut(0, 0).left, cut(0, 0).top), (0, 50));
        assert_eq!((cut(399, 99).left, cut(399, 99).top), (200, 0));
        assert_eq!(middle.indices(FILM).next(), Some(24 * 400 + 100));
    }
}
