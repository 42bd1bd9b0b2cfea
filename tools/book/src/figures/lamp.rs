//! The scene that grew through the book, lit by a lamp: a preview of shading and shadows.

use glam::{DVec3, dvec3};
use image::{Rgb, RgbImage};
use pinhole::{Intersection, Ray, Resolution, Shape, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::pictures::{GAP, made};
use crate::error::Result;
use crate::png::{beside, enlarged};
use crate::reference::Reference;
use crate::worked::nine_pixels::{camera, objects};

/// The width and height of each picture, in pixels.
const SIZE: usize = 150;

/// Where the lamp hangs.
const LAMP: DVec3 = dvec3(3.0, 5.0, 5.0);

/// The light in places that the lamp does not reach.
const AMBIENT: f64 = 0.2;

/// A shadow ray begins a little off its surface.
const OFF: f64 = 1e-6;

/// Three pictures: the objects, the same with a lamp, and also with its shadows.
pub fn scene_with_lamp(checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let resolution = Resolution {
        n_x: SIZE,
        n_y: SIZE,
    };
    let rays = reference.viewing_rays(camera()?, resolution)?;
    let shapes = objects().map(|(_, shape)| shape);
    let hits = first_hits(&shapes, &rays, 1.0, &reference)?;
    let to_lamp: Vec<Ray> = rays
        .iter()
        .zip(&hits)
        .map(|(ray, hit)| {
            let origin = hit.map_or(ray.origin, |(_, met)| ray.at(met.t));
            let direction = LAMP - origin;
            Ray { origin, direction }
        })
        .collect();
    let between = first_hits(&shapes, &to_lamp, OFF, &reference)?;
    let pixel = |place: usize, lamp: bool, shadows: bool| {
        let Some((object, met)) = hits[place] else {
            return false_colour::BACKGROUND;
        };
        // A shader may turn its own copy of the normal to the eye.
        let towards = -rays[place].direction.dot(met.normal).signum() * met.normal;
        let dark = shadows && between[place].is_some_and(|(_, met)| met.t < 1.0);
        let cosine = towards.dot(to_lamp[place].direction.normalize()).max(0.0);
        let light = match (lamp, dark) {
            (false, _) => 1.0,
            (true, true) => AMBIENT,
            (true, false) => AMBIENT + (1.0 - AMBIENT) * cosine,
        };
        Rgb(false_colour::object(object)
            .0
            .map(|value| (f64::from(value) * light) as u8))
    };
    let picture = |lamp, shadows| {
        let side = SIZE as u32;
        let picture = RgbImage::from_fn(side, side, |x, y| {
            pixel(y as usize * SIZE + x as usize, lamp, shadows)
        });
        enlarged(&picture, 2)
    };
    made(&beside(
        &[
            picture(false, false),
            picture(true, false),
            picture(true, true),
        ],
        GAP,
    ))
}

/// For each ray, the object that it meets first, and where.
fn first_hits(
    shapes: &[Shape],
    rays: &[Ray],
    min_t: f64,
    reference: &Reference,
) -> Result<Vec<Option<(usize, Intersection)>>> {
    let mut first: Vec<Option<(usize, Intersection)>> = vec![None; rays.len()];
    for (object, shape) in shapes.iter().enumerate() {
        let met = reference.intersect_all(shape, rays, min_t)?;
        for (best, met) in first.iter_mut().zip(met) {
            let nearer = |met: &Intersection| best.is_none_or(|(_, best)| met.t < best.t);
            if let Some(met) = met.filter(nearer) {
                *best = Some((object, met));
            }
        }
    }
    Ok(first)
}
