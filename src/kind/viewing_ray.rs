use serde::Serialize;

use super::{Answer, AnswerFn, Kind, Question, Unregistered};
use crate::camera::{Camera, Pixel, Projection, Resolution};
use crate::fact::Fact;
use crate::film::Samples;
use crate::ray::Ray;
use crate::scene::Scene;
use crate::words::{number, vector};

/// Which ray passes through the centre of `pixel`?
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CameraQuestion {
    /// Who looks.
    pub camera: Camera,
    /// Through which pixel.
    pub pixel: Pixel,
    /// Of how many.
    pub resolution: Resolution,
}

impl CameraQuestion {
    /// What is asked about the pixel at `index` of a scene's film.
    pub fn of_scene(scene: &Scene, index: usize) -> CameraQuestion {
        let Scene {
            camera, resolution, ..
        } = *scene;
        CameraQuestion {
            camera,
            pixel: resolution.pixel(index),
            resolution,
        }
    }

    pub(super) fn read(samples: Samples<'_>) -> Result<CameraQuestion, String> {
        let projection = match samples.number("focal_length")? {
            0.0 => Projection::Orthographic,
            focal_length => Projection::Perspective { focal_length },
        };
        let size = (samples.number("width")?, samples.number("height")?);
        let vector = |name| samples.vector(name);
        let (eye, view, up) = (vector("eye")?, vector("view")?, vector("up")?);
        let camera =
            Camera::new(eye, view, up, size, projection).ok_or("its view and up are parallel")?;
        let count = |name| samples.count(name);
        let resolution = Resolution {
            n_x: count("n_x")?,
            n_y: count("n_y")?,
        };
        let pixel = Pixel {
            i: count("i")?,
            j: count("j")?,
        };
        if pixel.i >= resolution.n_x || pixel.j >= resolution.n_y {
            return Err(format!("{pixel} is no pixel of {resolution}"));
        }
        Ok(CameraQuestion {
            camera,
            pixel,
            resolution,
        })
    }

    /// The submission's ray.
    pub(crate) fn ray(&self, functions: &[AnswerFn]) -> Result<Ray, Unregistered> {
        let viewing_ray = AnswerFn::find(functions, Kind::ViewingRay, |function| match function {
            AnswerFn::ViewingRay(viewing_ray) => Some(*viewing_ray),
            _ => None,
        })?;
        Ok(viewing_ray(&self.camera, self.pixel, self.resolution))
    }
}

impl Question for CameraQuestion {
    fn answer(&self, functions: &[AnswerFn]) -> Result<Answer, Unregistered> {
        self.ray(functions).map(Answer::Ray)
    }

    fn describe(&self, part: &str, digits: usize) -> Vec<Fact> {
        let camera = &self.camera;
        let projection = match camera.projection {
            Projection::Perspective { focal_length } => {
                format!("perspective, focal length {}", number(focal_length, digits))
            }
            Projection::Orthographic => "orthographic".into(),
        };
        let [eye, u, v, w] =
            [camera.eye, camera.u, camera.v, camera.w].map(|value| vector(value, digits));
        let [width, height] = [camera.width, camera.height].map(|value| number(value, digits));
        let camera = format!("{projection}, {width} × {height}, eye {eye}\nu {u}  v {v}  w {w}");
        vec![
            Fact::new(
                "pixel",
                format!("{} of {}, {part}", self.pixel, self.resolution),
            ),
            Fact::new("camera", camera),
        ]
    }
}
