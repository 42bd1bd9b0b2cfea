//! The rays of a golden's pixels, stored as six vectors instead of a film.
//!
//! The origins and directions of a camera's rays change evenly from pixel to pixel, so
//! three corners of Mitsuba's ray film are enough, and the report stays small.

use glam::DVec3;
use pinhole::{Film, Ray, Resolution};
use pinhole_course::outcome::OwnRays;
use serde::Serialize;

/// Rays that change evenly from column to column and from row to row.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RayGrid {
    /// World space, scene units.
    pub origin: Steps,
    /// World space, not normalised.
    pub direction: Steps,
    /// Whether the rays' directions are these, normalised.
    pub is_normalised: bool,
}

/// A vector at every pixel: `first` + i `per_column` + j `per_row`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Steps {
    /// At pixel (0, 0), bottom left.
    pub first: [f64; 3],
    /// How it changes from one column to the next on the right.
    pub per_column: [f64; 3],
    /// How it changes from one row to the next above.
    pub per_row: [f64; 3],
}

/// A submission's rays, as the page describes them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum SubmittedRays {
    /// Nothing is known.
    Unknown,
    /// They are the expected rays.
    Right,
    /// They don't change evenly from pixel to pixel, so they would make the page too large.
    Uneven,
    /// They change evenly, and this is their grid.
    #[serde(untagged)]
    Grid(RayGrid),
}

impl SubmittedRays {
    /// How the page describes these rays. `expected` are Mitsuba's.
    pub fn of(rays: &OwnRays, expected: Option<&RayGrid>) -> SubmittedRays {
        match rays {
            OwnRays::Unknown => SubmittedRays::Unknown,
            OwnRays::Right => SubmittedRays::Right,
            OwnRays::Asked(film) => RayGrid::of(film)
                .or_else(|| RayGrid::of_normalised(film, expected?))
                .map_or(SubmittedRays::Uneven, SubmittedRays::Grid),
        }
    }
}

/// How far the grid may be from a ray film's sample, relative to the film's largest sample: a few
/// roundings to 32 bits.
const ROUNDING: f64 = 1e-6;

impl RayGrid {
    /// The grid of a ray film; `None` if its rays do not change evenly.
    pub fn of(film: &Film) -> Option<RayGrid> {
        Some(RayGrid {
            origin: Steps::of(film, ["O.X", "O.Y", "O.Z"])?,
            direction: Steps::of(film, ["D.X", "D.Y", "D.Z"])?,
            is_normalised: false,
        })
    }

    /// The grid of rays with normalised directions: they change evenly when they are long enough
    /// to reach the image plane of the expected rays.
    fn of_normalised(film: &Film, expected: &RayGrid) -> Option<RayGrid> {
        let Steps {
            first,
            per_column,
            per_row,
        } = expected.direction;
        let across = DVec3::from(per_column).cross(per_row.into());
        let rays = (0..film.resolution().pixels()).map(|index| film.ray(index));
        let rays = rays.map(|ray| {
            let direction = across.dot(first.into()) / across.dot(ray.direction) * ray.direction;
            let is_unit = (ray.direction.length() - 1.0).abs() < ROUNDING;
            (is_unit && direction.is_finite()).then_some(Ray { direction, ..ray })
        });
        let rays: Vec<Ray> = rays.collect::<Option<_>>()?;
        Some(RayGrid {
            is_normalised: true,
            ..RayGrid::of(&Film::of_rays(film.resolution(), &rays))?
        })
    }
}

impl Steps {
    fn of(film: &Film, channels: [&str; 3]) -> Option<Steps> {
        let Resolution { n_x, n_y } = film.resolution();
        let mut steps = Steps {
            first: [0.0; 3],
            per_column: [0.0; 3],
            per_row: [0.0; 3],
        };
        for (axis, channel) in channels.into_iter().enumerate() {
            let samples = film.channel(channel)?;
            // Image order begins at the top.
            let at = |i: usize, j: usize| f64::from(samples[(n_y - 1 - j) * n_x + i]);
            let per = |span: f64, n: usize| if n > 1 { span / (n - 1) as f64 } else { 0.0 };
            let first = at(0, 0);
            let per_column = per(at(n_x - 1, 0) - first, n_x);
            let per_row = per(at(0, n_y - 1) - first, n_y);
            let largest = samples
                .iter()
                .fold(0.0f32, |most, sample| most.max(sample.abs()));
            let is_near = |(i, j): (usize, usize)| {
                let even = first + i as f64 * per_column + j as f64 * per_row;
                (even - at(i, j)).abs() <= ROUNDING * f64::from(largest)
            };
            let mut pixels = (0..n_y).flat_map(|j| (0..n_x).map(move |i| (i, j)));
            if !pixels.all(is_near) {
                return None;
            }
            steps.first[axis] = first;
            steps.per_column[axis] = per_column;
            steps.per_row[axis] = per_row;
        }
        Some(steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pinhole_course::assignment::Assignment;
    use pinhole_course::checkout::Checkout;

    #[test]
    fn every_golden_ray_film_is_a_grid() {
        let checkout = Checkout::find().expect("the checkout");
        let assignment = Assignment::read(&checkout, "ray_casting").expect("it is there");
        let golden = assignment.golden();
        let films = std::fs::read_dir(golden).expect("the goldens are committed");
        let films = films.flatten().map(|entry| entry.path());
        let films: Vec<_> = films
            .filter(|path| path.to_string_lossy().ends_with(".rays.exr"))
            .collect();
        assert!(films.len() >= 12, "{films:?}");
        for path in films {
            let film = Film::read(&path).expect("a golden can be read");
            assert!(RayGrid::of(&film).is_some(), "{}", path.display());
        }
    }

    #[test]
    fn rays_that_change_unevenly_are_no_grid() {
        let bent = [0.0, 1.0, 4.0].map(|x| Ray {
            origin: DVec3::ZERO,
            direction: DVec3::new(x, 0.0, -1.0),
        });
        let row = Resolution { n_x: 3, n_y: 1 };
        let bent = Film::of_rays(row, &bent);
        assert_eq!(RayGrid::of(&bent), None);
        let told =
            |rays| serde_json::to_value(SubmittedRays::of(&rays, None)).expect("it is plain data");
        assert_eq!(told(OwnRays::Asked(bent)), "uneven");
        let even = [1.0, 2.0].map(|x| Ray {
            origin: DVec3::ZERO,
            direction: DVec3::new(x, 0.0, -1.0),
        });
        let even = Film::of_rays(Resolution { n_x: 1, n_y: 2 }, &even);
        assert_eq!(told(OwnRays::Asked(even))["direction"]["per_row"][0], -1.0);
    }

    #[test]
    fn normalised_rays_are_the_grid_of_their_points_on_the_image_plane() {
        let size = Resolution { n_x: 3, n_y: 2 };
        let film = |shift: f64, is_normalised: bool| {
            let rays = (0..size.pixels()).map(|index| {
                let pixel = size.pixel(index);
                let direction = DVec3::new(pixel.i as f64 + shift, pixel.j as f64, -2.0);
                Ray {
                    origin: DVec3::ONE,
                    direction: if is_normalised {
                        direction.normalize()
                    } else {
                        direction
                    },
                }
            });
            Film::of_rays(size, &rays.collect::<Vec<_>>())
        };
        let expected = RayGrid::of(&film(0.0, false)).expect("it is even");
        let own = SubmittedRays::of(&OwnRays::Asked(film(0.5, true)), Some(&expected));
        let SubmittedRays::Grid(own) = own else {
            panic!("{own:?}");
        };
        assert!(own.is_normalised);
        let near = |a: [f64; 3], b: [f64; 3]| DVec3::from(a).abs_diff_eq(b.into(), 1e-6);
        assert!(near(own.direction.first, [0.5, 0.0, -2.0]), "{own:?}");
        assert!(near(own.direction.per_column, [1.0, 0.0, 0.0]), "{own:?}");
    }
}
