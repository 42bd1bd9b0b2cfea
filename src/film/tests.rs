use std::fs;

use super::*;
use crate::ray::Intersection;
use crate::testing::{self, Random, grid, row};
use glam::{DVec3, dvec3};

mod refusals;

fn read(bytes: impl AsRef<[u8]>) -> Result<Film, Error> {
    let (_folder, path) = testing::file("film.exr", bytes);
    Film::read(&path)
}

fn bytes(film: &Film) -> Vec<u8> {
    let (_folder, path) = testing::file("film.exr", "");
    film.write(&path).unwrap();
    fs::read(path).unwrap()
}

#[track_caller]
fn refused(bytes: impl AsRef<[u8]>, problem: &str) {
    let error = read(bytes).expect_err("this film should be refused");
    assert!(error.problem.contains(problem), "{error}");
    assert!(error.remedy.contains("in the book"), "{error}");
}

/// Asserts that both have the same size and the same bits in every channel, in any order of
/// channels.
#[track_caller]
fn same(one: &Film, other: &Film) {
    assert_eq!(one.resolution(), other.resolution());
    assert_eq!(one.channels().len(), other.channels().len());
    for channel in one.channels() {
        let bits = |samples: &[f32]| samples.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        let found = other
            .channel(&channel.name)
            .unwrap_or_else(|| panic!("no channel `{}`", channel.name));
        assert_eq!(bits(&channel.samples), bits(found), "{}", channel.name);
    }
}

/// A film of this size, with every kind of number that a float can be.
fn any_film(random: &mut Random, n_x: usize, n_y: usize) -> Film {
    let resolution = Resolution { n_x, n_y };
    let mut channel = |name: &&str| Channel {
        name: (*name).into(),
        samples: (0..resolution.pixels())
            .map(|_| f32::from_bits(random.bits() as u32))
            .collect(),
    };
    Film::new(resolution, HIT_CHANNELS.iter().map(&mut channel).collect())
}

fn small() -> Film {
    grid(
        3,
        &[
            ("id", &[0.0, 1.0, -1.0, 2.0, 2.0, -1.0]),
            ("t", &[1.5, 2.5, 0.0, 3.5, 4.5, 0.0]),
        ],
    )
}

#[test]
fn a_film_comes_back_as_it_was_to_the_last_bit() {
    let mut random = Random::new(1);
    for (n_x, n_y) in [(1, 1), (1, 9), (9, 1), (5, 3), (40, 70)] {
        let film = any_film(&mut random, n_x, n_y);
        same(&film, &read(bytes(&film)).unwrap());
    }
}

#[test]
fn a_film_written_twice_is_the_same_file() {
    let film = any_film(&mut Random::new(2), 300, 200);
    assert!(bytes(&film) == bytes(&film));
}

#[test]
fn the_order_of_channels_does_not_change_the_file() {
    let one = row(&[("id", &[1.0]), ("t", &[2.0])]);
    let other = row(&[("t", &[2.0]), ("id", &[1.0])]);
    assert!(bytes(&one) == bytes(&other));
}

#[test]
fn a_hit_is_an_id_a_t_and_a_normal() {
    let intersection = Intersection {
        t: 2.5,
        normal: dvec3(0.0, -1.0, 0.25),
    };
    let hit = Hit {
        object: 3,
        intersection,
    };
    let film = Film::of_hits(Resolution { n_x: 2, n_y: 1 }, &[Some(hit), None]);
    same(
        &film,
        &row(&[
            ("id", &[3.0, -1.0]),
            ("t", &[2.5, 0.0]),
            ("N.X", &[0.0, 0.0]),
            ("N.Y", &[-1.0, 0.0]),
            ("N.Z", &[0.25, 0.0]),
        ]),
    );
}

#[test]
fn a_ray_is_an_origin_and_a_direction() {
    let ray = Ray {
        origin: dvec3(1.0, 2.0, 3.0),
        direction: DVec3::NEG_Z,
    };
    let film = Film::of_rays(Resolution { n_x: 1, n_y: 1 }, &[ray]);
    same(
        &film,
        &row(&[
            ("O.X", &[1.0]),
            ("O.Y", &[2.0]),
            ("O.Z", &[3.0]),
            ("D.X", &[0.0]),
            ("D.Y", &[0.0]),
            ("D.Z", &[-1.0]),
        ]),
    );
}

#[test]
fn samples_are_read_back_as_the_hits_they_were_made_of() {
    let resolution = Resolution { n_x: 2, n_y: 1 };
    let met = Some(Hit {
        object: 7,
        intersection: Intersection {
            t: 1.5,
            normal: DVec3::NEG_Y,
        },
    });
    let hits = Film::of_hits(resolution, &[None, met]);
    assert_eq!([hits.hit(0), hits.hit(1)], [None, met]);
    let ray = |x| Ray {
        origin: dvec3(x, 2.0, 3.0),
        direction: dvec3(-0.5, 0.25, x),
    };
    let rays = Film::of_rays(resolution, &[ray(1.0), ray(4.0)]);
    assert_eq!([rays.ray(0), rays.ray(1)], [ray(1.0), ray(4.0)]);
}

#[test]
#[should_panic = "one sample per pixel"]
fn a_channel_cannot_lack_a_sample() {
    row(&[("id", &[1.0, 2.0]), ("t", &[1.0])]);
}

#[test]
fn a_channel_is_found_by_its_exact_name() {
    let film = small();
    assert_eq!(film.channel("t").map(<[f32]>::len), Some(6));
    assert_eq!(film.channel("T"), None);
}

#[test]
fn missing_film_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("absent.exr"), folder.path().into()] {
        let error = Film::read(&path).unwrap_err();
        assert_eq!(error.path, path);
        assert!(error.problem.starts_with("cannot read this film"));
    }
}

#[test]
fn a_film_cannot_be_written_into_a_folder_that_is_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let error = small()
        .write(&folder.path().join("no/film.exr"))
        .unwrap_err();
    assert!(
        error.problem.starts_with("cannot write this film"),
        "{error}"
    );
    assert!(error.remedy.contains("may write"), "{error}");
}
