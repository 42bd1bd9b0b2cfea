//! A drawing of where a ray meets the image plane, and where it should.

use pinhole_course::outcome::Picture;
use serde::Serialize;

/// Two points on an image plane, in the units of the drawing.
#[derive(Debug, PartialEq, Serialize)]
pub struct RayDrawing {
    /// The `viewBox`: left, top, width and height.
    pub view: [f64; 4],
    /// Half the size of the image plane, whose middle is the origin.
    pub area: [f64; 2],
    /// Half the size of a pixel.
    pub pixel: [f64; 2],
    /// The pixel's centre. Like the submission's point, it counts downwards.
    pub expected: [f64; 2],
    pub yours: [f64; 2],
}

/// Half the size of the image plane, along its longer side.
const HALF: f64 = 100.0;

/// Draw no points farther from the middle than this.
const FARTHEST: f64 = 4.0 * HALF;

/// Draw no points that are closer together than this, because their marks would overlap.
const NEAREST: f64 = 5.0;

/// Room around everything, for the marks.
const MARGIN: f64 = 12.0;

impl RayDrawing {
    /// Draws the worst ray of a group; `None` if the points nearly agree, or one is far off.
    pub fn of(shows: &Picture) -> Option<RayDrawing> {
        let Picture::Ray {
            question,
            expected,
            got,
        } = shows
        else {
            return None;
        };
        let (camera, resolution) = (&question.camera, question.resolution);
        let scale = 2.0 * HALF / camera.width.max(camera.height);
        let downwards = |[u, v]: [f64; 2]| [scale * u, -scale * v];
        let (expected, yours) = (downwards(*expected), downwards(*got));
        let area = [camera.width, camera.height].map(|size| scale * size / 2.0);
        let apart = (expected[0] - yours[0]).hypot(expected[1] - yours[1]);
        let is_near = yours.iter().all(|at| at.abs() <= FARTHEST);
        if !is_near || apart.is_nan() || apart < NEAREST {
            return None;
        }
        let reach = [0, 1].map(|axis| area[axis].max(yours[axis].abs()) + MARGIN);
        Some(RayDrawing {
            view: [-reach[0], -reach[1], 2.0 * reach[0], 2.0 * reach[1]],
            area,
            pixel: [
                area[0] / resolution.n_x as f64,
                area[1] / resolution.n_y as f64,
            ],
            expected,
            yours,
        })
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use pinhole::kind::CameraQuestion;
    use pinhole::{Camera, Pixel, Projection, Resolution};

    use super::*;

    #[test]
    fn a_ray_one_pixel_too_high_is_drawn_one_pixel_above_the_circle() {
        let projection = Projection::Orthographic;
        let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (4.0, 2.0), projection);
        let question = CameraQuestion {
            camera: camera.expect("view and up differ"),
            pixel: Pixel { i: 2, j: 0 },
            resolution: Resolution { n_x: 4, n_y: 2 },
        };
        let drawing = |got| {
            let expected = [0.5, -0.5];
            RayDrawing::of(&Picture::Ray {
                question,
                expected,
                got,
            })
        };
        let drawn = drawing([0.5, 0.5]).expect("the points differ");
        assert_eq!((drawn.area, drawn.pixel), ([100.0, 50.0], [25.0, 25.0]));
        assert_eq!((drawn.expected, drawn.yours), ([25.0, 25.0], [25.0, -25.0]));
        for nothing_to_see in [[0.5, -0.5], [f64::NAN, 0.0], [1e9, 0.0]] {
            assert_eq!(drawing(nothing_to_see), None);
        }
    }
}
