//! The other loop: for each triangle its pixels, with a depth buffer.
//!
//! The book compares it with ray casting, which must draw the same picture, and counts the steps of
//! both loops. A triangle with a corner nearer than min_t is refused, because the chapter doesn't
//! explain clipping.

use glam::{DVec2, DVec3, dvec2, dvec3};
use pinhole::{Camera, Projection, Resolution, Triangle};

/// The picture, and the number of steps.
pub struct Raster {
    /// For each pixel, in the film's order, the nearest triangle.
    pub nearest: Vec<Option<usize>>,
    /// Triangles visited, and pixels asked whether a triangle covers them.
    pub steps: usize,
}

/// A corner in pixel space, and 1/t there: seen from an eye, 1/t is linear in the picture.
#[derive(Clone, Copy)]
struct Corner {
    place: DVec2,
    nearness: f64,
}

/// Draws triangles as a perspective camera sees them.
///
/// # Panics
/// If the camera is orthographic, or a corner lies nearer than `min_t`.
pub fn rasterize(
    camera: &Camera,
    resolution: Resolution,
    min_t: f64,
    triangles: &[Triangle],
) -> Raster {
    let Projection::Perspective { focal_length } = camera.projection else {
        panic!("an orthographic camera");
    };
    let project = |corner: DVec3| {
        let from_eye = corner - camera.eye;
        let t = -from_eye.dot(camera.w) / focal_length;
        assert!(t >= min_t, "a corner lies nearer than min_t");
        let on_plane = dvec2(from_eye.dot(camera.u), from_eye.dot(camera.v)) / t;
        let size = dvec2(camera.width, camera.height);
        let pixels = dvec2(resolution.n_x as f64, resolution.n_y as f64);
        Corner {
            place: (on_plane + size / 2.0) / size * pixels,
            nearness: 1.0 / t,
        }
    };
    let mut depth_buffer = vec![0.0; resolution.pixels()];
    let mut drawn = Raster {
        nearest: vec![None; resolution.pixels()],
        steps: 0,
    };
    for (number, triangle) in triangles.iter().enumerate() {
        drawn.steps += 1;
        let corners = triangle.corners.map(project);
        let [columns, rows] = box_of(corners, resolution);
        for j in rows {
            for i in columns.clone() {
                drawn.steps += 1;
                let center = dvec2(i as f64 + 0.5, j as f64 + 0.5);
                let Some(nearness) = nearness_at(center, corners) else {
                    continue;
                };
                let index = resolution.index(pinhole::Pixel { i, j });
                if nearness > depth_buffer[index] {
                    depth_buffer[index] = nearness;
                    drawn.nearest[index] = Some(number);
                }
            }
        }
    }
    drawn
}

/// The columns and rows whose centres a triangle may cover.
fn box_of(corners: [Corner; 3], resolution: Resolution) -> [std::ops::Range<usize>; 2] {
    let places = corners.map(|corner| corner.place);
    let least = places[0].min(places[1]).min(places[2]);
    let most = places[0].max(places[1]).max(places[2]);
    let range = |least: f64, most: f64, pixels: usize| {
        // A float that is negative or too large becomes the nearest whole number there is.
        let first = (least - 0.5).ceil() as usize;
        let end = ((most - 0.5).floor() + 1.0) as usize;
        first.min(pixels)..end.min(pixels)
    };
    [
        range(least.x, most.x, resolution.n_x),
        range(least.y, most.y, resolution.n_y),
    ]
}

/// 1/t of a triangle at a place in the picture, if it covers that place. The areas between the
/// place and the three edges then have the same sign, and each is the weight of the opposite
/// corner.
fn nearness_at(place: DVec2, corners: [Corner; 3]) -> Option<f64> {
    let area = |k: usize| {
        let [from, to] = [(k + 1) % 3, (k + 2) % 3].map(|at| corners[at].place);
        (to - from).perp_dot(place - from)
    };
    let areas = [area(0), area(1), area(2)];
    let covers = areas.iter().all(|area| *area >= 0.0) || areas.iter().all(|area| *area <= 0.0);
    let whole: f64 = areas.iter().sum();
    let weighted = areas.iter().zip(corners);
    let sum: f64 = weighted.map(|(area, corner)| area * corner.nearness).sum();
    (covers && whole != 0.0).then(|| sum / whole)
}

/// The camera that sees the triangles of [`strewn`].
pub fn camera() -> Camera {
    let projection = Projection::Perspective { focal_length: 1.0 };
    let size = (1.6, 0.9);
    Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, size, projection).expect("it is a frame")
}

/// `count` triangles of about this size, scattered in front of the camera in the same way each
/// time.
pub fn strewn(count: usize, size: f64) -> Vec<Triangle> {
    // The fractions of multiples of three irrational numbers fill a cube evenly.
    let spread = |number: usize, by: f64| (number as f64 * by).fract() - 0.5;
    let triangle = |number: usize| {
        let at = [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|by| spread(number + 1, by));
        let middle = dvec3(at[0] * 6.0, at[1] * 3.4, at[2] * 2.0 - 4.0);
        let corner = |k: usize| {
            let by = [0.754_877_7, 0.569_840_3, 0.618_034];
            middle + size * DVec3::from(by.map(|by| spread(3 * number + k, by)))
        };
        Triangle {
            corners: [corner(0), corner(1), corner(2)],
        }
    };
    (0..count).map(triangle).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::Reference;
    use pinhole::{Scene, Shape};
    use pinhole_course::checkout::Checkout;

    #[test]
    fn both_loops_draw_the_same_picture() {
        let checkout = Checkout::find().expect("tests run in a checkout");
        let reference = Reference::build(&checkout).expect("it builds");
        let resolution = Resolution { n_x: 160, n_y: 90 };
        let triangles = strewn(60, 0.9);
        let drawn = rasterize(&camera(), resolution, 1.0, &triangles);
        let scene = Scene {
            camera: camera(),
            resolution,
            min_t: 1.0,
            objects: triangles.into_iter().map(Shape::Triangle).collect(),
        };
        let film = reference.film(&scene).expect("it is cast");
        let ids = film.channel("id").expect("films have ids");
        let ids: Vec<Option<usize>> = ids
            .iter()
            .map(|id| (*id >= 0.0).then_some(*id as usize))
            .collect();
        assert!(ids.iter().flatten().count() > 2000, "an empty picture");
        assert_eq!(drawn.nearest, ids);
    }
}
