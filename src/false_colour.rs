//! False-colour pictures of a film of hits. They are for people; no verdict is made
//! from them.

use std::ops::Range;

use image::{Rgb, RgbImage};

use crate::film::{Film, HIT_CHANNELS, MISS};
use crate::judge::Golden;

/// What a pixel that hits nothing looks like.
pub const BACKGROUND: Rgb<u8> = Rgb([24, 24, 28]);

/// Eight colours that colour-blind readers can tell apart (Okabe & Ito, "Color
/// Universal Design", 2008), without their black and with a light grey instead.
const OBJECTS: [[u8; 3]; 8] = [
    [230, 159, 0],
    [86, 180, 233],
    [0, 158, 115],
    [240, 228, 66],
    [0, 114, 178],
    [213, 94, 0],
    [204, 121, 167],
    [200, 200, 200],
];

/// Gives every object its own colour. After eight objects, the colours repeat in a darker shade.
pub fn id(film: &Film) -> RgbImage {
    picture(film, |hit| object(hit.id as usize))
}

/// The number of objects after which the colours repeat.
pub const OBJECT_COLOURS: usize = 4 * OBJECTS.len();

/// The colour of an object in [`id`] pictures.
pub fn object(id: usize) -> Rgb<u8> {
    let shade = 1.0 / (1.0 + 0.35 * ((id / OBJECTS.len()) % 4) as f32);
    Rgb(OBJECTS[id % OBJECTS.len()].map(|value| (f32::from(value) * shade) as u8))
}

/// Depth from near (bright) to far (dark) over `range`, in scene units. A depth beyond one end of
/// the range gets the colour of that end.
///
/// `depth_per_t` is the camera's (see [`Camera::depth_per_t`](crate::Camera::depth_per_t)).
pub fn depth(film: &Film, depth_per_t: f64, range: Range<f64>) -> RgbImage {
    let length = (range.end - range.start).max(f64::MIN_POSITIVE);
    picture(film, |hit| {
        far((f64::from(hit.t) * depth_per_t - range.start) / length)
    })
}

/// The colour in [`depth`] pictures at a share of their range, from 0 (near) to 1.
pub fn far(share: f64) -> Rgb<u8> {
    let colour = colorous::VIRIDIS.eval_continuous(1.0 - share.clamp(0.0, 1.0));
    Rgb([colour.r, colour.g, colour.b])
}

/// The normal's x, y, z from −1..1 as red, green, blue.
pub fn normal(film: &Film) -> RgbImage {
    picture(film, |hit| {
        Rgb(hit
            .normal
            .map(|value| ((value.clamp(-1.0, 1.0) + 1.0) * 127.5) as u8))
    })
}

/// The depths a picture of this film should span, in scene units: from the nearest hit to the 95th
/// percentile, because a plane that reaches the horizon has no greatest depth. The two ends differ
/// by at least a thousandth of the nearest depth. Otherwise, the picture of a wall that faces the
/// camera would show rounding errors.
///
/// If there is a golden, take the range from it for both films, because a film whose depths are all
/// doubled would look right with a range of its own.
pub fn depth_range(film: &Film, depth_per_t: f64) -> Range<f64> {
    let samples = film
        .channel("id")
        .unwrap_or_default()
        .iter()
        .zip(film.channel("t").unwrap_or_default());
    let mut depths: Vec<f64> = samples
        .filter(|(id, t)| **id != MISS && t.is_finite())
        .map(|(_, t)| (f64::from(*t) * depth_per_t).min(f64::MAX))
        .collect();
    depths.sort_by(f64::total_cmp);
    match depths.as_slice() {
        [] => 0.0..1.0,
        all => {
            let (near, far) = (all[0], all[(all.len() - 1) * 95 / 100]);
            near..far.max(1.001 * near).min(f64::MAX)
        }
    }
}

/// Where a film differs from its golden, one colour for each kind of difference.
/// Pixels that agree show the golden's objects, faintly.
pub fn difference(golden: &Golden, film: &Film) -> RgbImage {
    let [ids, ts, xs, ys, zs] = HIT_CHANNELS.map(|channel| golden.missed(film, channel));
    let faint = id(golden.film());
    let resolution = film.resolution();
    RgbImage::from_fn(resolution.n_x as u32, resolution.n_y as u32, |x, y| {
        let index = y as usize * resolution.n_x + x as usize;
        if ids[index] {
            Difference::Object.colour()
        } else if ts[index] {
            Difference::T.colour()
        } else if xs[index] || ys[index] || zs[index] {
            Difference::Normal.colour()
        } else {
            Rgb(faint.get_pixel(x, y).0.map(|value| value / 4))
        }
    })
}

/// The kinds of difference, worst first; a pixel shows the first that applies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Difference {
    /// Another object, or none.
    Object,
    /// The right object at the wrong t.
    T,
    /// The right point with the wrong normal.
    Normal,
}

impl Difference {
    /// All of them with the words a legend needs.
    pub const LEGEND: [(Difference, &str); 3] = [
        (Difference::Object, "orange: another object, or none"),
        (Difference::T, "blue: the right object at the wrong t"),
        (
            Difference::Normal,
            "white: the right point with the wrong normal",
        ),
    ];

    /// Its colour. Colour-blind readers, too, can tell all three from each other and from the faint
    /// background.
    pub fn colour(self) -> Rgb<u8> {
        Rgb(match self {
            Difference::Object => [255, 120, 20],
            Difference::T => [60, 150, 255],
            Difference::Normal => [255, 255, 255],
        })
    }
}

/// Fades these pixels of a picture, in image order, towards the background.
pub fn fade(picture: &mut RgbImage, faded: &[bool]) {
    for (pixel, _) in picture.pixels_mut().zip(faded).filter(|(_, faded)| **faded) {
        for (value, background) in pixel.0.iter_mut().zip(BACKGROUND.0) {
            *value = ((u16::from(*value) + 2 * u16::from(background)) / 3) as u8;
        }
    }
}

/// A pixel that hit something.
struct HitSample {
    id: f32,
    t: f32,
    normal: [f32; 3],
}

fn picture(film: &Film, colour: impl Fn(HitSample) -> Rgb<u8>) -> RgbImage {
    let resolution = film.resolution();
    let channel = |name| film.channel(name).unwrap_or_default();
    let [ids, ts, xs, ys, zs] = ["id", "t", "N.X", "N.Y", "N.Z"].map(channel);
    RgbImage::from_fn(resolution.n_x as u32, resolution.n_y as u32, |x, y| {
        let index = y as usize * resolution.n_x + x as usize;
        let at = |samples: &[f32]| samples.get(index).copied().unwrap_or(MISS);
        match at(ids) {
            // Every other value is background, because another program's film may hold
            // anything.
            id if id >= 0.0 => colour(HitSample {
                id,
                t: at(ts),
                normal: [at(xs), at(ys), at(zs)],
            }),
            _ => BACKGROUND,
        }
    })
}

#[cfg(test)]
mod tests;
