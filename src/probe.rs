//! Question films: pixels that are arbitrary questions instead of a camera's rays.
//!
//! A scene needs every answer at once; a probe asks one answer alone. Each pixel
//! holds a ray (origin `O`, direction `D`, `min_t`) and what it is to meet, or a
//! camera and one of its pixels. The golden film of the same name holds Mitsuba's
//! answers. All values are exact in 32-bit floats, so that Mitsuba and a submission
//! are asked the same.

use std::path::Path;

use glam::DVec3;

use crate::camera::{Camera, Pixel, Projection, Resolution};
use crate::error::Error;
use crate::film::Film;
use crate::job::{CameraQuestion, CannedQuestion, Job, ShapeQuestion};
use crate::ray::{Intersection, Ray};
use crate::shape::{Canned, Plane, Shape, Sphere, Triangle, TriangleSoup};

/// A question can hold at most this many canned objects.
const MOST_OBJECTS: usize = 6;

/// Reads the question film at `path` as a job for `task`, with the film's size.
///
/// # Errors
/// If the film cannot be read, lacks a channel of this task's questions, or holds a
/// value that makes no question.
pub fn read(path: &Path, task: &str) -> Result<(Job, Resolution), Error> {
    let film = Film::read(path)?;
    let resolution = film.resolution();
    let all = 0..resolution.pixels();
    let job = questions(&film, task, all).map_err(|problem| {
        let remedy = "make the probes again: cargo run --release -- golden render";
        Error::new(
            path,
            format!("this is no question film for `{task}`: {problem}"),
            remedy,
        )
    })?;
    Ok((job, resolution))
}

fn questions(film: &Film, task: &str, all: std::ops::Range<usize>) -> Result<Job, String> {
    let columns = Columns(film);
    Ok(match task {
        "viewing_ray" => {
            Job::ViewingRay(all.map(|at| columns.camera(at)).collect::<Result<_, _>>()?)
        }
        "first_hit" => Job::FirstHit(all.map(|at| columns.canned(at)).collect::<Result<_, _>>()?),
        "triangle_soup" => {
            Job::TriangleSoup(all.map(|at| columns.canned(at)).collect::<Result<_, _>>()?)
        }
        "sphere" | "plane" | "triangle" => Job::Intersect(
            all.map(|at| columns.shape(task, at))
                .collect::<Result<_, _>>()?,
        ),
        _ => return Err("no such task".into()),
    })
}

/// A film read by channel name and index.
struct Columns<'a>(&'a Film);

impl Columns<'_> {
    fn number(&self, name: &str, at: usize) -> Result<f64, String> {
        let samples = self
            .0
            .channel(name)
            .ok_or_else(|| format!("it has no channel `{name}`"))?;
        match samples[at] {
            value if value.is_finite() => Ok(f64::from(value)),
            _ => Err(format!(
                "channel `{name}` is not finite at {}",
                self.0.resolution().pixel(at)
            )),
        }
    }

    fn count(&self, name: &str, at: usize) -> Result<usize, String> {
        let value = self.number(name, at)?;
        if value < 0.0 || value.fract() != 0.0 {
            return Err(format!(
                "channel `{name}` holds {value}, which counts nothing"
            ));
        }
        Ok(value as usize)
    }

    fn vector(&self, name: &str, at: usize) -> Result<DVec3, String> {
        let axis = |axis| self.number(&format!("{name}.{axis}"), at);
        Ok(DVec3::new(axis("X")?, axis("Y")?, axis("Z")?))
    }

    fn ray(&self, at: usize) -> Result<Ray, String> {
        Ok(Ray {
            origin: self.vector("O", at)?,
            direction: self.vector("D", at)?,
        })
    }

    fn min_t(&self, at: usize) -> Result<f64, String> {
        match self.number("min_t", at)? {
            min_t if min_t < 0.0 => Err(format!(
                "channel `min_t` holds {min_t}, behind the ray's origin"
            )),
            min_t => Ok(min_t),
        }
    }

    fn shape(&self, kind: &str, at: usize) -> Result<ShapeQuestion, String> {
        let vector = |name| self.vector(name, at);
        let shape = match kind {
            "sphere" => Shape::Sphere(Sphere {
                center: vector("center")?,
                radius: self.number("radius", at)?,
            }),
            "plane" => Shape::Plane(Plane {
                point: vector("point")?,
                normal: vector("normal")?,
            }),
            _ => Shape::Triangle(Triangle {
                corners: [vector("a")?, vector("b")?, vector("c")?],
            }),
        };
        Ok(ShapeQuestion {
            shape,
            ray: self.ray(at)?,
            min_t: self.min_t(at)?,
        })
    }

    fn canned(&self, at: usize) -> Result<CannedQuestion, String> {
        let object = |k: usize| {
            let hits = self.count(&format!("{k}.hits"), at)?;
            let intersection = |n: usize| {
                Ok(Intersection {
                    t: self.number(&format!("{k}.{n}.t"), at)?,
                    normal: self.vector(&format!("{k}.{n}.N"), at)?,
                })
            };
            let intersections = (0..hits).map(intersection).collect::<Result<_, String>>()?;
            Ok(Canned { intersections })
        };
        let count = self.count("count", at)?;
        if count > MOST_OBJECTS {
            return Err(format!(
                "channel `count` holds {count}, more than {MOST_OBJECTS} objects"
            ));
        }
        let triangles = (0..count).map(object).collect::<Result<_, String>>()?;
        Ok(CannedQuestion {
            objects: TriangleSoup { triangles },
            ray: self.ray(at)?,
            min_t: self.min_t(at)?,
        })
    }

    fn camera(&self, at: usize) -> Result<CameraQuestion, String> {
        let projection = match self.number("focal_length", at)? {
            0.0 => Projection::Orthographic,
            focal_length => Projection::Perspective { focal_length },
        };
        let size = (self.number("width", at)?, self.number("height", at)?);
        let vector = |name| self.vector(name, at);
        let camera = Camera::new(
            vector("eye")?,
            vector("view")?,
            vector("up")?,
            size,
            projection,
        )
        .ok_or("its view and up are parallel")?;
        let count = |name| self.count(name, at);
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
}

#[cfg(test)]
mod tests;
