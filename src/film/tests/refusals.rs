//! Files that are not films, or that claim to hold more than they do.

use super::*;

#[test]
fn file_that_is_not_a_film_is_refused() {
    let mut random = Random::new(3);
    refused("", "this is not a readable OpenEXR file");
    refused("a film, honestly", "this is not a readable OpenEXR file");
    for length in 1..200 {
        refused(random.bytes(length), "this is not a readable OpenEXR file");
    }
}

#[test]
fn a_picture_is_refused_as_a_film() {
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
            "{length} of {} bytes are not a film",
            whole.len()
        );
    }
}

#[test]
fn a_film_with_any_one_byte_wrong_is_read_or_refused() {
    let whole = bytes(&small());
    let (_folder, path) = testing::file("film.exr", "");
    let mut random = Random::new(4);
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
    // A length of four bytes follows the name.
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
fn film_that_claims_more_pixels_than_it_holds_is_refused() {
    same(&small(), &read(claiming(&small(), 3, 2)).unwrap());
    for (n_x, n_y) in [(1 << 30, 1), (1, 1 << 30), (i32::MAX, i32::MAX)] {
        refused(claiming(&small(), n_x, n_y), "");
    }
    refused(
        claiming(&small(), 1 << 12, 1 << 12),
        "claims to have 4096×4096 pixels",
    );
}

#[test]
fn a_film_that_claims_more_than_memory_holds_is_refused() {
    // The file is long enough that compression could explain the size it claims.
    let padding = vec![0; 4 << 20];
    let bytes = [claiming(&small(), 1 << 14, 1 << 14), padding].concat();
    refused(bytes, "claims to have 16384×16384 pixels");
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
fn half_floats_are_refused() {
    use exr::prelude::*;
    let (_folder, path) = testing::file("film.exr", "");
    let channel = SpecificChannels::build()
        .with_channel("t")
        .with_pixel_fn(|_| (f16::from_f32(1.0),));
    let image = Image::from_channels((2, 2), channel);
    image.write().to_file(&path).unwrap();
    refused(
        fs::read(path).unwrap(),
        "channel `t` does not hold 32-bit floats",
    );
}

#[test]
fn a_file_that_claims_deep_data_is_refused() {
    let mut bytes = bytes(&row(&[("t", &[1.0])]));
    // The flag is bit 11 of the file's version.
    bytes[5] |= 1 << 3;
    refused(bytes, "the file has deep data");
}

#[test]
fn two_channels_of_one_name_are_refused() {
    let film = row(&[("ta", &[1.0]), ("tb", &[2.0])]);
    let mut bytes = bytes(&film);
    let place = bytes.windows(3).position(|w| w == b"tb\0").unwrap();
    bytes[place + 1] = b'a';
    refused(bytes, "channel names are not unique");
}

#[test]
fn spoilt_films_do_not_harm_the_reader() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.exr");
    // A panic in the decoder becomes an error.
    std::panic::set_hook(Box::new(|_| ()));
    bolero::check!().for_each(|bytes| {
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
