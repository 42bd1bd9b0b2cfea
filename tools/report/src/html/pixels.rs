//! Films packed for a page: every number of every pixel in one string.
//!
//! `unpack.js` is the inverse. Bytes are grouped by place (the first bytes of all
//! floats, then the second ones, …), because that compresses to two thirds of the size.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use pinhole::Film;
use pinhole::judge::Golden;

use super::cause::{Cause, PixelCauses, samples};
use super::window::Window;

/// A higher level takes twice as long and makes the result only a twentieth smaller.
const EFFORT: u8 = 4;

/// The pixels of a window: which channels miss; the cause (0 if nothing is wrong, otherwise one
/// more than its place in [`Cause::ALL`]); then the five channels of what was expected, allowed
/// and got.
pub fn pack(golden: &Golden, film: &Film, wrong: &PixelCauses, window: Window) -> String {
    let indices = window.indices(golden.film().resolution());
    let code = |cause: Option<Cause>| {
        let place = Cause::ALL.iter().position(|other| Some(*other) == cause);
        place.map_or(0, |place| place as u8 + 1)
    };
    let mut bytes: Vec<u8> = indices.clone().map(|index| wrong.missed[index]).collect();
    bytes.extend(indices.clone().map(|index| code(wrong.causes[index])));

    let films = [golden.film(), golden.tolerance(), film].map(samples);
    let channels = films.iter().flatten();
    let floats: Vec<[u8; 4]> = channels
        .flat_map(|channel| indices.clone().map(|index| channel[index].to_le_bytes()))
        .collect();
    for place in 0..4 {
        bytes.extend(floats.iter().map(|float| float[place]));
    }
    STANDARD.encode(compress_to_vec_zlib(&bytes, EFFORT))
}
