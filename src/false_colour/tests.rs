use super::*;
use crate::camera::{Camera, Projection, Resolution};
use crate::testing::{Random, grid, row};
use glam::DVec3;

/// Hits of object 0 at these t, all facing +z.
fn at(ts: &[f32]) -> Film {
    hits(&vec![0.0; ts.len()], ts)
}

fn hits(ids: &[f32], ts: &[f32]) -> Film {
    let zero = vec![0.0; ids.len()];
    let one = vec![1.0; ids.len()];
    row(&[
        ("id", ids),
        ("t", ts),
        ("N.X", &zero),
        ("N.Y", &zero),
        ("N.Z", &one),
    ])
}

fn facing(normal: [f32; 3]) -> Film {
    let [x, y, z] = normal;
    row(&[
        ("id", &[0.0]),
        ("t", &[1.0]),
        ("N.X", &[x]),
        ("N.Y", &[y]),
        ("N.Z", &[z]),
    ])
}

fn brightness(colour: &Rgb<u8>) -> u32 {
    colour.0.iter().map(|value| u32::from(*value)).sum()
}

#[test]
fn depths_twice_too_large_look_wrong_in_the_goldens_range() {
    let golden = at(&[1.0, 2.0, 3.0, 4.0]);
    let doubled = at(&[2.0, 4.0, 6.0, 8.0]);
    let range = depth_range(&golden, 1.0);
    assert_ne!(
        depth(&golden, 1.0, range.clone()),
        depth(&doubled, 1.0, range)
    );
    // With a range of its own the mistake would be invisible.
    assert_eq!(
        depth(&golden, 1.0, depth_range(&golden, 1.0)),
        depth(&doubled, 1.0, depth_range(&doubled, 1.0))
    );
}

#[test]
fn nearer_pixels_are_brighter() {
    let film = at(&[1.0, 1.5, 2.0, 3.0, 5.0]);
    let picture = depth(&film, 1.0, 1.0..5.0);
    let shades: Vec<u32> = picture.pixels().map(brightness).collect();
    assert!(shades.is_sorted_by(|near, far| near > far), "{shades:?}");
}

#[test]
fn depth_is_t_times_the_cameras_factor() {
    let projection = Projection::Perspective { focal_length: 4.0 };
    let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (1.0, 1.0), projection).unwrap();
    assert_eq!(
        depth_range(&at(&[1.0, 2.5]), camera.depth_per_t()).start,
        4.0
    );
    assert_eq!(
        depth(&at(&[1.0, 2.5]), 4.0, 4.0..10.0),
        depth(&at(&[4.0, 10.0]), 1.0, 4.0..10.0)
    );
}

#[test]
fn depth_outside_the_range_is_clamped() {
    let picture = depth(&at(&[0.5, 1.0, 2.0, 9.0]), 1.0, 1.0..2.0);
    assert_eq!(picture.get_pixel(0, 0), picture.get_pixel(1, 0));
    assert_eq!(picture.get_pixel(2, 0), picture.get_pixel(3, 0));
}

#[test]
fn a_horizon_does_not_stretch_the_range() {
    let mut ts: Vec<f32> = (1..=100).map(|t| t as f32).collect();
    ts[99] = 1e9;
    assert_eq!(depth_range(&at(&ts), 1.0), 1.0..95.0);
}

#[test]
fn range_of_huge_depths_is_finite() {
    let range = depth_range(&at(&[1.0, 3e38, 3e38]), 1e300);
    assert_eq!(range, 1e300..f64::MAX);
}

#[test]
fn rounding_of_a_wall_that_faces_the_camera_is_not_seen() {
    let film = at(&[2.0, 2.000_000_2, 2.000_000_1]);
    let picture = depth(&film, 1.0, depth_range(&film, 1.0));
    let [one, other] = [0, 1].map(|x| picture.get_pixel(x, 0).0);
    assert!((0..3).all(|k| one[k].abs_diff(other[k]) <= 1));
}

#[test]
fn misses_have_no_depth() {
    let film = hits(&[-1.0, 0.0, 0.0, -1.0], &[0.0, 2.0, 3.0, 0.0]);
    assert_eq!(depth_range(&film, 1.0).start, 2.0);
    assert_eq!(depth_range(&hits(&[-1.0], &[0.0]), 1.0), 0.0..1.0);
}

#[test]
fn misses_are_background_in_every_picture() {
    let film = hits(&[-1.0, 0.0], &[0.0, 1.0]);
    for picture in [id(&film), normal(&film), depth(&film, 1.0, 0.0..2.0)] {
        assert_eq!(*picture.get_pixel(0, 0), BACKGROUND);
        assert_ne!(*picture.get_pixel(1, 0), BACKGROUND);
    }
}

#[test]
fn thirty_two_objects_have_colours_of_their_own() {
    let ids: Vec<f32> = (0..32).map(|id| id as f32).collect();
    let picture = id(&hits(&ids, &[1.0; 32]));
    let mut colours: Vec<[u8; 3]> = picture.pixels().map(|colour| colour.0).collect();
    colours.sort();
    colours.dedup();
    assert_eq!(colours.len(), 32);
    assert!(!colours.contains(&BACKGROUND.0));
}

#[test]
fn the_six_directions_of_a_normal_have_colours_of_their_own() {
    let colour = |axis: [f32; 3]| normal(&facing(axis)).get_pixel(0, 0).0;
    assert_eq!(colour([1.0, 0.0, 0.0]), [255, 127, 127]);
    assert_eq!(colour([0.0, 1.0, 0.0]), [127, 255, 127]);
    assert_eq!(colour([0.0, 0.0, 1.0]), [127, 127, 255]);
    assert_eq!(colour([-1.0, 0.0, 0.0]), [0, 127, 127]);
    assert_eq!(colour([0.0, -1.0, 0.0]), [127, 0, 127]);
    assert_eq!(colour([0.0, 0.0, -1.0]), [127, 127, 0]);
}

#[test]
fn the_top_row_of_a_film_is_the_top_row_of_its_picture() {
    let channel = ("id", [-1.0, -1.0, 0.0, -1.0, -1.0, -1.0]);
    let zero = [0.0; 6];
    let film = grid(
        3,
        &[
            (channel.0, &channel.1),
            ("t", &zero),
            ("N.X", &zero),
            ("N.Y", &zero),
            ("N.Z", &zero),
        ],
    );
    let picture = id(&film);
    assert_eq!(picture.dimensions(), (3, 2));
    let lit: Vec<_> = picture
        .enumerate_pixels()
        .filter(|(.., colour)| **colour != BACKGROUND)
        .map(|(x, y, _)| (x, y))
        .collect();
    assert_eq!(lit, [(2, 0)]);
}

#[test]
fn each_kind_of_difference_has_its_colour_and_the_worst_wins() {
    let golden = golden(hits(&[0.0; 4], &[1.0; 4]));
    let mut ids = [0.0; 4];
    let mut ts = [1.0; 4];
    let mut zs = [1.0; 4];
    (ids[1], ts[1], zs[1]) = (1.0, 9.0, -1.0);
    (ts[2], zs[2]) = (9.0, -1.0);
    zs[3] = -1.0;
    let zero = [0.0; 4];
    let film = row(&[
        ("id", &ids),
        ("t", &ts),
        ("N.X", &zero),
        ("N.Y", &zero),
        ("N.Z", &zs),
    ]);
    let picture = difference(&golden, &film);
    let colours: Vec<Rgb<u8>> = picture.pixels().copied().collect();
    assert_eq!(colours[1], Difference::Object.colour());
    assert_eq!(colours[2], Difference::T.colour());
    assert_eq!(colours[3], Difference::Normal.colour());
    assert!(
        !Difference::LEGEND
            .iter()
            .any(|(kind, _)| kind.colour() == colours[0])
    );
}

#[test]
fn nan_is_a_difference() {
    let golden = golden(at(&[1.0]));
    let picture = difference(&golden, &at(&[f32::NAN]));
    assert_eq!(*picture.get_pixel(0, 0), Difference::T.colour());
}

#[test]
fn no_film_makes_a_picture_panic() {
    let mut random = Random::new(1);
    let golden = golden(at(&[1.0; 8]));
    for _ in 0..500 {
        let mut samples = || -> Vec<f32> {
            (0..8)
                .map(|_| match random.below(3) {
                    0 => *random.one_of(&[f32::NAN, f32::INFINITY, f32::MIN, 1e30, -0.0]),
                    _ => f32::from_bits(random.bits() as u32),
                })
                .collect()
        };
        let film = row(&[
            ("id", &samples()),
            ("t", &samples()),
            ("N.X", &samples()),
            ("N.Y", &samples()),
            ("N.Z", &samples()),
        ]);
        let range = depth_range(&film, 1.5);
        depth(&film, 1.5, range);
        depth(&film, 1.5, 0.0..0.0);
        id(&film);
        normal(&film);
        difference(&golden, &film);
    }
}

#[test]
fn a_film_of_other_channels_is_all_background() {
    let film = row(&[("R", &[1.0, 1.0])]);
    assert!(id(&film).pixels().all(|colour| *colour == BACKGROUND));
    assert_eq!(film.resolution(), Resolution { n_x: 2, n_y: 1 });
}

/// A golden whose tolerance is 0 everywhere.
fn golden(film: Film) -> Golden {
    let nothing = film.channels().iter().map(|channel| crate::film::Channel {
        name: channel.name.clone(),
        samples: vec![0.0; channel.samples.len()],
    });
    let tolerance = Film::new(film.resolution(), nothing.collect());
    Golden::new(film, tolerance).unwrap()
}

#[test]
fn colour_blind_readers_can_tell_the_kinds_of_difference_apart() {
    // What is left of a colour without the long, middle or short cones (Machado, Oliveira
    // & Fernandes, "A Physiologically-based Model for Simulation of Color Vision
    // Deficiency", 2009, table 1, severity 1), on linear samples.
    const BLIND: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];
    let mut colours: Vec<Rgb<u8>> = Difference::LEGEND.map(|(kind, _)| kind.colour()).into();
    // Pixels that agree are faded. Their brightest colour is the easiest to confuse with these.
    let faint = |id| Rgb(object(id).0.map(|value| value / 4));
    colours.extend((0..OBJECTS.len()).map(faint));
    for seen in BLIND {
        let see = |colour: &Rgb<u8>| -> [f64; 3] {
            let linear = colour.0.map(|value| (f64::from(value) / 255.0).powf(2.2));
            seen.map(|row| {
                let sum: f64 = row.iter().zip(linear).map(|(a, b)| a * b).sum();
                sum.clamp(0.0, 1.0).powf(1.0 / 2.2)
            })
        };
        for kind in 0..3 {
            for other in (0..colours.len()).filter(|other| *other != kind) {
                let (one, two) = (see(&colours[kind]), see(&colours[other]));
                let squares = one.iter().zip(two).map(|(a, b)| (a - b).powi(2));
                let distance = squares.sum::<f64>().sqrt();
                assert!(
                    distance > 0.4,
                    "{:?} and {:?} are {distance} apart to {seen:?}",
                    colours[kind],
                    colours[other]
                );
            }
        }
    }
}

#[test]
fn faded_pixels_go_two_thirds_of_the_way_to_the_background() {
    let mut picture = RgbImage::from_pixel(2, 1, Rgb([255, 24, 0]));
    fade(&mut picture, &[false, true]);
    assert_eq!(picture.get_pixel(0, 0), &Rgb([255, 24, 0]));
    assert_eq!(picture.get_pixel(1, 0), &Rgb([101, 24, 18]));
}
