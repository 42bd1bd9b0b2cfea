//! A film of a submission's answers so far, with the golden film filling in the rest.
//!
//! A film needs every answer, so a student would see no picture before writing the last one. A
//! preview asks each answer alone. Missing viewing rays come from the golden film of rays. The
//! nearest object of each pixel comes from the golden film, and so does the whole pixel if its
//! shape can't be intersected yet. Nothing is judged by a preview.

use crate::ask::Reply;
use crate::film::Film;
use crate::job::Job;
use crate::kind::{CameraQuestion, Kind, Questions};
use crate::ray::{Hit, Ray};
use crate::scene::Scene;
use crate::shape::{Shape, ShapeKind};

/// What is answered, or is not: a kind of question, and the shape it is about, if it is
/// about one.
pub type TaskKind = (Kind, Option<ShapeKind>);

/// A film that is made with the answers that a submission has so far.
#[derive(Clone, Debug)]
pub struct Preview {
    /// What it shows.
    pub film: Film,
    /// For each pixel, whether it was copied from the golden film.
    pub copied: Vec<bool>,
    /// What the submission answered.
    pub answered: Vec<TaskKind>,
    /// What has no answer yet, and came from the golden films instead. The choice of the nearest
    /// object always does.
    pub missing: Vec<TaskKind>,
}

impl Preview {
    /// The film of `scene`, whose golden film is `golden` and whose golden rays are `rays`.
    /// `ask` gives the submission's reply to a job, or `None` if it has no answer yet.
    ///
    /// # Errors
    /// If `ask` fails.
    pub fn new<E>(
        scene: &Scene,
        golden: &Film,
        rays: &Film,
        ask: &mut dyn FnMut(&Job) -> Result<Option<Reply>, E>,
    ) -> Result<Preview, E> {
        let pixels = 0..scene.resolution.pixels();
        let mut preview = Preview {
            film: Film::new(scene.resolution, Vec::new()),
            copied: vec![false; pixels.len()],
            answered: Vec::new(),
            missing: Vec::new(),
        };
        let questions = pixels
            .clone()
            .map(|index| CameraQuestion::of_scene(scene, index));
        let reply = ask(&Job::Ask(Questions::ViewingRay(questions.collect())))?;
        preview.note((Kind::ViewingRay, None), reply.is_some());
        let rays: Vec<Ray> = match reply.and_then(|reply| reply.rays()) {
            Some(rays) => rays,
            None => pixels.clone().map(|index| rays.ray(index)).collect(),
        };
        let mut hits: Vec<Option<Hit>> = pixels.map(|index| golden.hit(index)).collect();
        for shape in shapes(scene) {
            let is_met = |hit: &Hit| scene.objects.get(hit.object).map(Shape::kind) == Some(shape);
            let met: Vec<(usize, Hit)> = hits
                .iter()
                .enumerate()
                .filter_map(|(index, hit)| Some((index, hit.filter(is_met)?)))
                .collect();
            if met.is_empty() {
                continue;
            }
            let asked = met.iter().map(|(index, hit)| (rays[*index], hit.object));
            let reply = ask(&Job::Meet(scene.clone(), asked.collect()))?;
            preview.note((Kind::of_shape(shape), Some(shape)), reply.is_some());
            match reply.and_then(|reply| reply.hits()) {
                Some(theirs) => {
                    for ((index, Hit { object, .. }), hit) in met.into_iter().zip(theirs) {
                        hits[index] = hit.map(|hit| Hit { object, ..hit });
                    }
                }
                None => met
                    .iter()
                    .for_each(|(index, _)| preview.copied[*index] = true),
            }
        }
        preview.film = Film::of_hits(scene.resolution, &hits);
        Ok(preview)
    }

    fn note(&mut self, asked: TaskKind, is_answered: bool) {
        match is_answered {
            true => self.answered.push(asked),
            false => self.missing.push(asked),
        }
    }
}

/// The shapes that a scene's objects have, each once, in the scene's order.
fn shapes(scene: &Scene) -> Vec<ShapeKind> {
    let mut shapes = Vec::new();
    for shape in scene.objects.iter().map(Shape::kind) {
        if !shapes.contains(&shape) {
            shapes.push(shape);
        }
    }
    shapes
}

#[cfg(test)]
mod tests;
