//! The static pictures of interactive figures: how each begins.

use glam::{DVec2, dvec2};
use image::{Rgb, RgbImage, Rgba, RgbaImage};
use pinhole::{Film, Resolution, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, INK, Side, colour, ink, stroke};
use super::pictures::{GAP, made};
use crate::course::golden;
use crate::error::Result;
use crate::png::{beside, enlarged, stacked};
use crate::silhouette::{DISTANCES, Meets, SIDE, WAYS, on};
use crate::worked::{PIXEL, Quadratic, RAY, SPHERE};

/// How wide and high a pixel of the lecture's picture is drawn.
const CELL: u32 = 13;

/// The lecture's picture with its pixel marked.
pub fn pixel_to_ray(checkout: &Checkout) -> Result<FigureFile> {
    let film = Film::read(&golden(checkout).join("slide_example.exr"))?;
    let mut picture = enlarged(&false_colour::id(&film), CELL);
    let Resolution { n_x, .. } = film.resolution();
    let index = film.resolution().index(PIXEL);
    let (left, top) = ((index % n_x) as u32 * CELL, (index / n_x) as u32 * CELL);
    for step in 0..CELL {
        for (x, y) in [(step, 0), (step, CELL - 1), (0, step), (CELL - 1, step)] {
            picture.put_pixel(left + x, top + y, Rgba([255; 4]));
        }
    }
    made(&picture)
}

/// The worked ray and its sphere, in the plane of both.
pub fn sphere_roots(_: &Checkout) -> Result<FigureFile> {
    let stride = RAY.direction.length();
    let to_center = SPHERE.center - RAY.origin;
    let ahead = to_center.dot(RAY.direction) / stride;
    let center = dvec2(ahead, (to_center.length_squared() - ahead * ahead).sqrt());
    let at = |t: f64| dvec2(t * stride, 0.0);
    let mut drawing = Drawing::new(dvec2(-0.9, -1.3), dvec2(8.8, 3.25));
    drawing.circle(center, SPHERE.radius, &colour(1), 0.3, &ink());
    drawing.dot(DVec2::ZERO, INK);
    drawing.text(DVec2::ZERO, Side::Above, "*e*");
    drawing.line(at(0.0), at(1.0), &ink().dashed());
    drawing.line(at(1.0), at(2.8), &stroke(colour(5)).thick());
    drawing.line(
        at(1.0) - dvec2(0.0, 0.25),
        at(1.0) + dvec2(0.0, 0.25),
        &stroke(colour(4)).thick(),
    );
    drawing.text(at(1.0) - dvec2(0.0, 0.2), Side::Below, "min_t");
    let quadratic = Quadratic::new(&RAY, &SPHERE);
    let [t0, t1] = quadratic.roots();
    drawing.dot(at(t0), &colour(5));
    drawing.ring(at(t1));
    drawing.text(at(t0), Side::Below, "t₀");
    drawing.text(at(t1), Side::Below, "t₁");
    drawing.text(
        dvec2(7.4, 2.9),
        Side::On,
        &format!("Δ = {}", quadratic.discriminant()),
    );
    Ok(drawing.made())
}

/// Balls of equal size in a row, and the rays to their tops and feet.
pub fn projections(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-0.6, -5.6), dvec2(13.0, 2.2));
    let balls = [5.0, 7.5, 10.0].map(|x| dvec2(x, 0.0));
    let (radius, plane) = (0.8, 2.5);
    for (row, name) in [(0.0, "perspective"), (-3.7, "orthographic")] {
        let origin = dvec2(0.0, row);
        let left = origin + dvec2(plane, 0.0);
        drawing.line(
            left - dvec2(0.0, 1.2),
            left + dvec2(0.0, 1.2),
            &ink().thick(),
        );
        for (number, ball) in balls.iter().enumerate() {
            let fill = colour([0, 1, 2][number]);
            drawing.circle(origin + *ball, radius, &fill, 0.5, &ink());
            for side in [-1.0, 1.0] {
                // The tangent from the eye, and its point of contact.
                let sine = radius / ball.x;
                let touch = match name {
                    "perspective" => dvec2(
                        ball.x * (1.0 - sine * sine),
                        side * radius * (1.0 - sine * sine).sqrt(),
                    ),
                    _ => *ball + dvec2(0.0, side * radius),
                };
                let from = match name {
                    "perspective" => DVec2::ZERO,
                    _ => dvec2(plane, touch.y),
                };
                drawing.line(origin + from, origin + touch, &stroke(fill.clone()));
            }
        }
        drawing.text(origin + dvec2(6.0, -1.6), Side::On, name);
    }
    drawing.dot(DVec2::ZERO, INK);
    drawing.text(DVec2::ZERO, Side::Above, "*e*");
    Ok(drawing.made())
}

/// The silhouettes of one sphere at a hundred million radii, by three computations.
pub fn breaking_distance(_: &Checkout) -> Result<FigureFile> {
    made(&row(&WAYS.map(|(_, meets)| (meets, 1e8)), 5))
}

/// One sphere from farther and farther away: by the textbook's discriminant above, from
/// the foot of the perpendicular below.
pub fn sphere_from_afar(_: &Checkout) -> Result<FigureFile> {
    let [_, (_, textbook), (_, foot)] = WAYS;
    from_afar([textbook, foot])
}

/// The same sphere by the textbook's discriminant alone: in `f32` above, in `f64` below.
pub fn sphere_in_f32(_: &Checkout) -> Result<FigureFile> {
    let [(_, single), (_, double), _] = WAYS;
    from_afar([single, double])
}

fn from_afar(ways: [Meets; 2]) -> Result<FigureFile> {
    let rows = ways.map(|meets| row(&DISTANCES.map(|far| (meets, far)), 3));
    made(&stacked(&rows, GAP))
}

/// Silhouettes beside each other.
fn row(of: &[(Meets, f64)], times: u32) -> RgbaImage {
    let [r, g, b] = false_colour::object(1).0;
    let picture = |(meets, far): &(Meets, f64)| {
        let picture = RgbImage::from_fn(SIDE, SIDE, |i, j| match meets(on(i), on(j), *far) {
            true => Rgb([r, g, b]),
            false => false_colour::BACKGROUND,
        });
        enlarged(&picture, times)
    };
    beside(&of.iter().map(picture).collect::<Vec<_>>(), GAP)
}
