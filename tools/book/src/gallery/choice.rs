//! Chooses the scene and view that show a mistake best. Its picture should differ from the
//! expected one, and from those of other mistakes in the same chapters.

use std::collections::BTreeMap;

use image::RgbImage;

use super::View;

/// What a mistake casts of one scene, in one view.
pub struct Shot {
    /// The scene's name.
    pub scene: String,
    /// The kind of false colours.
    pub view: View,
    /// How much it differs from the expected picture, see [`difference`].
    pub visible: f64,
    /// The picture.
    pub picture: RgbImage,
}

/// Whether readers see that two pictures are not the same: at least one pixel in five hundred
/// differs by more than a shade.
pub fn is_seen(one: &RgbImage, other: &RgbImage) -> bool {
    let pixels = one.pixels().zip(other.pixels());
    let apart = |a: &[u8; 3], b: &[u8; 3]| (0..3).any(|k| a[k].abs_diff(b[k]) > 8);
    let different = pixels.filter(|(a, b)| apart(&a.0, &b.0)).count();
    different * 500 >= one.pixels().len()
}

/// A mistake, and every picture that could show it.
pub struct Candidate {
    /// The mistake's name.
    pub slug: String,
    /// The tasks whose chapters show it.
    pub tasks: Vec<String>,
    /// Pictures that differ from the expected ones.
    pub shots: Vec<Shot>,
}

/// The scene and view for each mistake that shows in a scene, by name. No two mistakes of a
/// chapter get the same picture.
pub fn choose(candidates: &[Candidate]) -> BTreeMap<&str, &Shot> {
    // Mistakes with few pictures choose first.
    let mut order: Vec<&Candidate> = candidates.iter().collect();
    order.sort_by_key(|candidate| candidate.shots.len());
    let mut chosen: Vec<(&Candidate, &Shot)> = Vec::new();
    for candidate in order {
        let rivals = |other: &Candidate| {
            other.slug != candidate.slug
                && other.tasks.iter().any(|it| candidate.tasks.contains(it))
        };
        let worth = |shot: &Shot| {
            let others = candidates.iter().filter(|other| rivals(other));
            let same_view = others
                .flat_map(|other| &other.shots)
                .filter(|other| (&other.scene, other.view) == (&shot.scene, shot.view));
            let nearest = same_view.map(|other| difference(&shot.picture, &other.picture));
            let distinct = nearest.fold(1.0, f64::min);
            // Beyond this difference, a picture with many colours is better than one
            // with a larger difference.
            let enough = |share: f64, most: f64| 0.02 + (share / most).min(1.0);
            enough(shot.visible, 0.3) * enough(distinct, 0.1) * enough(variety(&shot.picture), 0.5)
        };
        let taken = |shot: &Shot| {
            chosen.iter().any(|(other, its)| {
                rivals(other)
                    && (&its.scene, its.view) == (&shot.scene, shot.view)
                    && its.picture == shot.picture
            })
        };
        let free = candidate.shots.iter().filter(|shot| !taken(shot));
        let rated = free.map(|shot| (worth(shot), shot));
        if let Some((_, best)) = rated.max_by(|one, other| one.0.total_cmp(&other.0)) {
            chosen.push((candidate, best));
        }
    }
    chosen
        .into_iter()
        .map(|(candidate, shot)| (candidate.slug.as_str(), shot))
        .collect()
}

/// How different two pictures look, from 0 to 1: the mean over pixels. A third of one channel's
/// range counts as the largest difference.
pub fn difference(one: &RgbImage, other: &RgbImage) -> f64 {
    let unlike = |a: &[u8; 3], b: &[u8; 3]| {
        let apart: u32 = (0..3).map(|k| u32::from(a[k].abs_diff(b[k]))).sum();
        f64::from(apart.min(85)) / 85.0
    };
    let pixels = one.pixels().zip(other.pixels());
    let sum: f64 = pixels.map(|(a, b)| unlike(&a.0, &b.0)).sum();
    sum / f64::from(one.width() * one.height())
}

/// The share of pixels that don't have the picture's most common colour.
fn variety(picture: &RgbImage) -> f64 {
    let mut colours: BTreeMap<[u8; 3], usize> = BTreeMap::new();
    for pixel in picture.pixels() {
        *colours.entry(pixel.0).or_default() += 1;
    }
    let commonest = colours.into_values().max().unwrap_or(0);
    1.0 - commonest as f64 / f64::from(picture.width() * picture.height())
}

#[cfg(test)]
mod tests {
    use image::Rgb;

    use super::*;

    const BLACK: [u8; 3] = [0; 3];
    const BLUE: [u8; 3] = [0, 0, 250];
    const RED: [u8; 3] = [250, 0, 0];

    fn shot(scene: &str, pixels: [[u8; 3]; 4]) -> Shot {
        let picture = RgbImage::from_fn(4, 1, |x, _| Rgb(pixels[x as usize]));
        let expected = RgbImage::from_pixel(4, 1, Rgb(RED));
        Shot {
            scene: scene.into(),
            view: View::Id,
            visible: difference(&expected, &picture),
            picture,
        }
    }

    fn candidate(slug: &str, shots: Vec<Shot>) -> Candidate {
        Candidate {
            slug: slug.into(),
            tasks: vec!["sphere".into()],
            shots,
        }
    }

    fn scenes(candidates: &[Candidate]) -> Vec<(&str, &str)> {
        let chosen = choose(candidates).into_iter();
        chosen
            .map(|(slug, shot)| (slug, shot.scene.as_str()))
            .collect()
    }

    #[test]
    fn a_single_pixel_of_many_is_not_seen() {
        let picture = |red: u32| {
            RgbImage::from_fn(40, 40, |i, j| match i + 40 * j < red {
                true => image::Rgb([255, 0, 0]),
                false => image::Rgb([0; 3]),
            })
        };
        let seen = [0, 1, 3, 4, 1600].map(|red| is_seen(&picture(0), &picture(red)));
        assert_eq!(seen, [false, false, false, true, true]);
    }

    #[test]
    fn the_picture_that_no_other_mistake_casts_is_chosen() {
        let candidates = [
            candidate(
                "hole",
                vec![
                    shot("a", [BLACK, BLACK, RED, RED]),
                    shot("b", [BLUE, BLACK, RED, RED]),
                ],
            ),
            candidate(
                "half",
                vec![
                    shot("a", [BLACK, BLACK, RED, RED]),
                    shot("c", [BLUE, BLUE, RED, RED]),
                ],
            ),
        ];
        assert_eq!(scenes(&candidates), [("half", "c"), ("hole", "b")]);
    }

    #[test]
    fn each_picture_is_used_once_and_first_where_it_is_the_only_one() {
        let black = || shot("a", [BLACK; 4]);
        let candidates = [
            candidate("many", vec![black(), shot("b", [BLACK, RED, RED, RED])]),
            candidate("one", vec![black()]),
            candidate("twin", vec![black()]),
        ];
        assert_eq!(scenes(&candidates), [("many", "b"), ("one", "a")]);
    }

    #[test]
    fn more_colourful_of_two_equally_distinct_pictures_is_chosen() {
        let candidates = [candidate(
            "one",
            vec![shot("a", [BLACK; 4]), shot("b", [BLACK, BLUE, BLACK, BLUE])],
        )];
        assert_eq!(scenes(&candidates), [("one", "b")]);
    }
}
