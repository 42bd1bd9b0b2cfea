use std::fs;

use super::*;
use crate::ray::Intersection;
use crate::testing::{self, Random, grid, row};
use glam::{DVec3, dvec3};

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
    assert!(error.remedy.contains("README.md"), "{error}");
}

/// Same size, and the same bits in every channel, wherever in the list it stands.
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

/// Of this size, with every kind of number a float can be.
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
    let mut random = Random(1);
    for (n_x, n_y) in [(1, 1), (1, 9), (9, 1), (5, 3), (40, 70)] {
        let film = any_film(&mut random, n_x, n_y);
        same(&film, &read(bytes(&film)).unwrap());
    }
}

#[test]
fn a_film_written_twice_is_the_same_file() {
    let film = any_film(&mut Random(2), 300, 200);
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
fn a_film_that_is_not_there_is_told_so() {
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

#[test]
fn what_is_no_film_is_refused() {
    let mut random = Random(3);
    refused("", "this is not a readable OpenEXR file");
    refused("a film, honestly", "this is not a readable OpenEXR file");
    for length in 1..200 {
        refused(random.bytes(length), "this is not a readable OpenEXR file");
    }
}

#[test]
fn a_picture_is_no_film() {
    let (_folder, path) = testing::file("film.png", "");
    image::RgbImage::new(4, 3).save(&path).unwrap();
    refused(
        fs::read(path).unwrap(),
        "this is not a readable OpenEXR file",
    );
}

#[test]
fn a_film_cut_short_anywhere_is_refused() {
    let whole = bytes(&small());
    for length in 0..whole.len() {
        assert!(
            read(&whole[..length]).is_err(),
            "{length} of {} bytes are no film",
            whole.len()
        );
    }
}

#[test]
fn a_film_with_any_one_byte_wrong_is_read_or_refused() {
    let whole = bytes(&small());
    let (_folder, path) = testing::file("film.exr", "");
    let mut random = Random(4);
    for place in 0..whole.len() {
        for wrong in [0, 255, random.bits() as u8] {
            let mut damaged = whole.clone();
            damaged[place] = wrong;
            fs::write(&path, &damaged).unwrap();
            if let Ok(film) = Film::read(&path) {
                assert!(film.resolution().pixels() < 1000, "byte {place} is {wrong}");
            }
        }
    }
}

const DATA_WINDOW: &str = "dataWindow\0box2i\0";
const DISPLAY_WINDOW: &str = "displayWindow\0box2i\0";

/// Rewrites one of a file's windows: x and y of its first and of its last pixel.
fn set_window(bytes: &mut [u8], name: &str, corners: [i32; 4]) {
    let mut windows = bytes.windows(name.len());
    let place = windows.position(|w| w == name.as_bytes()).unwrap();
    // Behind the name stands a length of four bytes.
    let values = &mut bytes[place + name.len() + 4..][..16];
    for (value, corner) in values.chunks_exact_mut(4).zip(corners) {
        value.copy_from_slice(&corner.to_le_bytes());
    }
}

/// The film's file, claiming this many pixels.
fn claiming(film: &Film, n_x: i32, n_y: i32) -> Vec<u8> {
    let mut bytes = bytes(film);
    for name in [DATA_WINDOW, DISPLAY_WINDOW] {
        set_window(&mut bytes, name, [0, 0, n_x - 1, n_y - 1]);
    }
    bytes
}

#[test]
fn a_film_that_claims_more_than_it_can_hold_is_refused() {
    same(&small(), &read(claiming(&small(), 3, 2)).unwrap());
    for (n_x, n_y) in [(1 << 30, 1), (1, 1 << 30), (i32::MAX, i32::MAX)] {
        refused(claiming(&small(), n_x, n_y), "");
    }
    refused(
        claiming(&small(), 1 << 12, 1 << 12),
        "claims 4096×4096 pixels",
    );
}

#[test]
fn a_film_that_claims_more_than_memory_holds_is_refused() {
    // Long enough to be no lie about compression.
    let padding = vec![0; 4 << 20];
    let bytes = [claiming(&small(), 1 << 14, 1 << 14), padding].concat();
    refused(bytes, "claims 16384×16384 pixels");
}

#[test]
fn a_window_that_is_not_the_whole_picture_is_refused() {
    for (data, display) in [
        ([0, 0, 2, 1], [0, 0, 7, 1]),
        ([1, 0, 3, 1], [0, 0, 2, 1]),
        ([0, 0, 2, 1], [1, 0, 3, 1]),
        ([1, 0, 3, 1], [1, 0, 3, 1]),
    ] {
        let mut bytes = bytes(&small());
        set_window(&mut bytes, DATA_WINDOW, data);
        set_window(&mut bytes, DISPLAY_WINDOW, display);
        refused(bytes, "is not the whole picture");
    }
}

#[test]
fn halves_are_not_precise_enough() {
    use exr::prelude::*;
    let (_folder, path) = testing::file("film.exr", "");
    let channel = SpecificChannels::build()
        .with_channel("t")
        .with_pixel_fn(|_| (f16::from_f32(1.0),));
    let image = Image::from_channels((2, 2), channel);
    image.write().to_file(&path).unwrap();
    refused(
        fs::read(path).unwrap(),
        "channel `t` is not of 32-bit floats",
    );
}

#[test]
fn a_film_has_no_two_channels_of_one_name() {
    let film = row(&[("ta", &[1.0]), ("tb", &[2.0])]);
    let mut bytes = bytes(&film);
    let place = bytes.windows(3).position(|w| w == b"tb\0").unwrap();
    bytes[place + 1] = b'a';
    refused(bytes, "channel names are not unique");
}

#[test]
fn no_spoilt_film_harms_its_reader() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.exr");
    let goldens = concat!(env!("CARGO_MANIFEST_DIR"), "/golden/ray_casting");
    let ids: Vec<f32> = (0..64).map(|id| id as f32).collect();
    testing::grid(8, &[("id", &ids), ("t", &ids)])
        .write(&path)
        .unwrap();
    let seeds = [
        fs::read(&path).unwrap(),
        fs::read(format!("{goldens}/slide_example.exr")).unwrap(),
        fs::read(format!("{goldens}/slide_example.tol.exr")).unwrap(),
    ];
    let words: [&[u8]; 8] = [
        b"channels\0",
        b"compression\0",
        b"dataWindow\0",
        b"tiles\0",
        b"\x76\x2f\x31\x01",
        b"N.X\0",
        b"box2i\0",
        b"lineOrder\0",
    ];
    // Whoever reads a damaged film is told so by a panic that goes no further.
    std::panic::set_hook(Box::new(|_| ()));
    testing::fuzz::fuzz("film", &seeds, &words, |bytes| {
        fs::write(&path, bytes).unwrap();
        if let Ok(film) = Film::read(&path) {
            let pixels = film.resolution().pixels();
            assert!(
                film.channels()
                    .iter()
                    .all(|channel| channel.samples.len() == pixels)
            );
        }
    });
    let _ours = std::panic::take_hook();
}
