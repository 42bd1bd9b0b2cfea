use glam::{DMat3, DVec3};
use serde::Serialize;

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::camera::{Camera, Pixel, Projection, Resolution};
use crate::fact::Fact;
use crate::film::{RAY_CHANNELS, Samples};
use crate::part::{Condition, Part, Quantity};
use crate::ray::Ray;
use crate::scene::Scene;
use crate::words::{number, vector};

/// Which ray passes through the centre of `pixel`?
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CameraQuestion {
    /// The camera.
    pub camera: Camera,
    /// The pixel that the ray passes through.
    pub pixel: Pixel,
    /// How many pixels the picture has.
    pub resolution: Resolution,
}

impl CameraQuestion {
    /// The question about the pixel at `index` of a scene's film.
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
            return Err(format!("{pixel} is not a pixel of {resolution}"));
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
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        Ok(Answer::Ray(self.ray(functions)?).into())
    }

    fn receive(&self, sent: &WireAnswer) -> Option<Answer> {
        match sent {
            WireAnswer::Answer(answer @ Answer::Ray(_)) => Some(*answer),
            _ => None,
        }
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

    /// A ray in the camera's own frame: where it crosses the image plane, where it starts,
    /// and its direction.
    fn parts(&self, answer: &Answer) -> Option<Vec<Part>> {
        let Answer::Ray(ray) = answer else {
            return None;
        };
        let camera = &self.camera;
        let Ray {
            origin: start,
            direction,
        } = self.in_camera_space(ray);
        let [across_u, across_v] = self.on_image_plane(ray);
        let Resolution { n_x, n_y } = self.resolution;
        let per_unit = [n_x as f64 / camera.width, n_y as f64 / camera.height];
        let (origin, along) = RAY_CHANNELS.split_at(3);
        let channels = match self.focal_length() {
            Some(_) => along,
            None => origin,
        };
        let of_frame = |name, vector: DVec3, channels| Part {
            name,
            values: vector.to_array().to_vec(),
            axes: &["u", "v", "w"],
            unit: "",
            channels,
            scale: 1.0,
            is_limit: false,
        };
        Some(vec![
            Part {
                name: "the point where the ray's line meets the image plane",
                values: vec![across_u * per_unit[0], across_v * per_unit[1]],
                axes: &["u", "v"],
                unit: " pixels",
                channels,
                scale: 1.0 / per_unit[0].max(per_unit[1]),
                is_limit: false,
            },
            of_frame("the vector from the eye to the ray's origin", start, origin),
            of_frame("the direction", direction, along),
        ])
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let Camera { width, height, .. } = self.camera;
        let [n_x, n_y] = [self.resolution.n_x, self.resolution.n_y].map(|count| count as f64);
        let length = match right {
            Answer::Ray(ray) => ray.direction.length(),
            _ => f64::NAN,
        };
        let focal_length = self.focal_length().unwrap_or(f64::NAN);
        vec![
            Quantity::new("the focal length", focal_length),
            Quantity::new("|s − e|", length),
            Quantity::new("n_x", n_x),
            Quantity::new("n_y", n_y),
            Quantity::new("n_x / (n_x − 1)", n_x / (n_x - 1.0)),
            Quantity::new("n_y / (n_y − 1)", n_y / (n_y - 1.0)),
            Quantity::new("the width", width),
            Quantity::new("the height", height),
            Quantity::new("the aspect ratio", width / height),
            Quantity::new("n_x / n_y", n_x / n_y),
        ]
    }

    fn conditions(&self, _: &Answer) -> Vec<Condition> {
        vec![Condition::new(
            "the camera is orthographic",
            "the camera is perspective",
            self.focal_length().is_none(),
        )]
    }

    fn others(&self, right: &Answer) -> Vec<(&'static str, Answer)> {
        let Answer::Ray(right) = right else {
            return Vec::new();
        };
        let Camera { eye, u, v, w, .. } = self.camera;
        let [start, direction] = [right.origin - eye, right.direction];
        let frame = DMat3::from_cols(u, v, w);
        let turned = |matrix: DMat3| Ray {
            origin: eye + matrix * self.in_frame(start),
            direction: matrix * self.in_frame(direction),
        };
        let to_point = Ray {
            direction: right.at(1.0),
            ..*right
        };
        [
            (
                "what you get with the columns and rows of the camera's frame exchanged",
                turned(frame.transpose()),
            ),
            (
                "what you get without the camera's frame",
                turned(DMat3::IDENTITY),
            ),
            (
                "the point on the image plane instead of the vector to it",
                to_point,
            ),
        ]
        .map(|(name, ray)| (name, Answer::Ray(ray)))
        .to_vec()
    }
}

impl CameraQuestion {
    /// A ray of world space in camera space.
    pub fn in_camera_space(&self, ray: &Ray) -> Ray {
        super::refuse_in_submission();
        Ray {
            origin: self.in_frame(ray.origin - self.camera.eye),
            direction: self.in_frame(ray.direction),
        }
    }

    /// Where a ray of world space meets the image plane, along u and v from its middle; not
    /// finite where it never does.
    pub fn on_image_plane(&self, ray: &Ray) -> [f64; 2] {
        let Ray { origin, direction } = self.in_camera_space(ray);
        let plane = -self.focal_length().unwrap_or(0.0);
        let at = origin + (plane - origin.z) / direction.z * direction;
        [at.x, at.y]
    }

    /// `None` if the camera is orthographic.
    fn focal_length(&self) -> Option<f64> {
        match self.camera.projection {
            Projection::Perspective { focal_length } => Some(focal_length),
            Projection::Orthographic => None,
        }
    }

    /// A vector by its components along u, v and w.
    fn in_frame(&self, vector: DVec3) -> DVec3 {
        let Camera { u, v, w, .. } = self.camera;
        DVec3::new(vector.dot(u), vector.dot(v), vector.dot(w))
    }
}
