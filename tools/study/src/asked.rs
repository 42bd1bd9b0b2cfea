//! Every question of the study's quick mode, for somebody else to answer.

use glam::DVec3;
use pinhole::job::Job;
use pinhole::kind::{Questions, ShapeQuestion};

use crate::family::mesh::{Aim, Inside};
use crate::family::{Family, Studied, questions};
use crate::leaks::rays_at;
use crate::question::Question;
use crate::scenes;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::theirs::{Asked, DATA, MESH_RAYS, family_part, mesh_part, scene_part};
use crate::vector::Vector;

/// All parts: families of questions, each followed by the same with their numbers near
/// 1, which tell whether a fault is one of range; closed meshes; scenes.
///
/// # Errors
/// If a scene cannot be read.
pub fn asked(count: usize, seed: u64) -> Result<Vec<Asked>, pinhole::Error> {
    let mut all = families::<Sphere<f64>>(count, seed);
    all.extend(families::<Plane<f64>>(count, seed));
    all.extend(families::<Triangle<f64>>(count, seed));
    for aim in Aim::BOTH {
        let rays = rays_at(aim, DATA, seed).take(MESH_RAYS);
        let faces = |inside: Inside| {
            let questions = inside
                .triangles
                .iter()
                .map(|face| put(&inside.question(*face)));
            questions.collect::<Vec<_>>()
        };
        all.push(Asked {
            part: mesh_part(aim),
            job: Job::Ask(Questions::Intersect(rays.flat_map(faces).collect())),
        });
    }
    for file in scenes::files() {
        let scene = scenes::read(&file)?;
        all.push(Asked {
            part: scene_part(&file.file_stem().unwrap_or_default().to_string_lossy()),
            job: Job::Film(scene),
        });
    }
    Ok(all)
}

fn families<S: Studied + Askable>(count: usize, seed: u64) -> Vec<Asked> {
    let job = |family: &Family<S>| {
        let mut all = Vec::new();
        for exponent in (family.exponents)(DATA) {
            let asked = questions(family, exponent, DATA, count, seed);
            all.extend(asked.iter().map(put));
            all.extend(asked.iter().map(|question| put(&question.normalized())));
        }
        Job::Ask(Questions::Intersect(all))
    };
    let part = |family: &Family<S>| Asked {
        part: family_part(S::NAME, family.name),
        job: job(family),
    };
    S::families().iter().map(part).collect()
}

/// A shape that the harness knows too.
trait Askable: Copy {
    fn harness(self) -> pinhole::Shape;
}

fn put<S: Askable>(question: &Question<S>) -> ShapeQuestion {
    let Ray { origin, direction } = question.ray;
    ShapeQuestion {
        shape: question.shape.harness(),
        ray: pinhole::Ray {
            origin: vector(origin),
            direction: vector(direction),
        },
        min_t: question.min_t,
    }
}

fn vector(v: Vector<f64>) -> DVec3 {
    DVec3::from_array(v.array())
}

impl Askable for Sphere<f64> {
    fn harness(self) -> pinhole::Shape {
        pinhole::Shape::Sphere(pinhole::Sphere {
            center: vector(self.center),
            radius: self.radius,
        })
    }
}

impl Askable for Plane<f64> {
    fn harness(self) -> pinhole::Shape {
        pinhole::Shape::Plane(pinhole::Plane {
            point: vector(self.point),
            normal: vector(self.normal),
        })
    }
}

impl Askable for Triangle<f64> {
    fn harness(self) -> pinhole::Shape {
        pinhole::Shape::Triangle(pinhole::Triangle {
            corners: self.corners.map(vector),
        })
    }
}
