//! Heat maps: how many tests each pixel took, expected and yours side by side.

use pinhole::Film;
use pinhole::heat_map::{self, HeatScale};
use pinhole::words::number;
use serde::Serialize;

use super::picture;

/// The tests of a film, beside those that are expected.
#[derive(Debug, Serialize)]
pub struct HeatMaps {
    /// What is expected, if that is known.
    pub expected: Option<HeatMap>,
    pub yours: HeatMap,
    /// The colours of the scale, as a picture's address.
    pub bar: String,
    /// How many tests the colours stand for, at even steps along the bar.
    pub steps: Vec<String>,
}

/// One film's tests.
#[derive(Debug, Serialize)]
pub struct HeatMap {
    /// The picture's address.
    pub picture: String,
    /// The tests of all pixels together.
    pub sum: String,
}

impl HeatMaps {
    /// The maps of a film and its golden, both on one scale; `None` unless both count tests.
    pub fn beside(golden: &Film, film: &Film) -> Option<HeatMaps> {
        let scale = HeatScale::of(&[golden, film])?;
        Some(HeatMaps {
            expected: Some(HeatMap::of(golden, &scale)),
            ..HeatMaps::of(film, &scale)
        })
    }

    /// The map of a film without a golden that counts tests.
    pub fn alone(film: &Film) -> Option<HeatMaps> {
        Some(HeatMaps::of(film, &HeatScale::of(&[film])?))
    }

    fn of(film: &Film, scale: &HeatScale) -> HeatMaps {
        HeatMaps {
            expected: None,
            yours: HeatMap::of(film, scale),
            bar: picture::address(&HeatScale::bar()),
            steps: scale.steps().map(|(_, tests)| number(tests, 9)).into(),
        }
    }
}

impl HeatMap {
    fn of(film: &Film, scale: &HeatScale) -> HeatMap {
        HeatMap {
            picture: picture::address(&scale.picture(film)),
            sum: number(heat_map::sum(film), 9),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pinhole::Resolution;
    use pinhole::film::TESTS;

    fn row(tests: &[f32]) -> Film {
        let n_x = tests.len();
        Film::new(Resolution { n_x, n_y: 1 }, Vec::new()).with(TESTS, tests.to_vec())
    }

    #[test]
    fn expected_and_yours_share_a_scale_and_have_their_own_sums() {
        let maps = HeatMaps::beside(&row(&[4.0, 6.0]), &row(&[40.0, 6.0])).expect("both count");
        assert_eq!(maps.steps, ["0", "10", "20", "30", "40"]);
        let expected = maps.expected.expect("the golden counts");
        assert_eq!([expected.sum, maps.yours.sum], ["10", "46"]);
        let alone = HeatMaps::alone(&row(&[4.0, 6.0])).expect("it counts");
        assert_ne!(
            alone.yours.picture, expected.picture,
            "its own scale is finer"
        );
    }

    #[test]
    fn a_film_that_counts_nothing_has_no_heat_map() {
        let silent = Film::new(Resolution { n_x: 2, n_y: 1 }, Vec::new());
        assert!(HeatMaps::alone(&silent).is_none());
        assert!(HeatMaps::beside(&silent, &row(&[1.0, 2.0])).is_none());
    }
}
