//! Explains one pixel. Each answer is asked alone, so that one failure hides no other.

mod fault;

use std::path::PathBuf;
use std::time::Duration;

use pinhole::job::Job;
use pinhole::kind::{Answer, CameraQuestion, Questions, ShapeQuestion};
use pinhole::{Film, Hit, Kind, Pixel, Ray, Scene};
use serde::Serialize;

use crate::assignment::{Assignment, Task};
use crate::compile::{Program, Replacement};
use crate::error::Result;
use crate::examine;
use crate::outcome::FilmOutcome;
use crate::sandbox::{Limits, Sandbox};

/// What Mitsuba found at a pixel, where a golden is committed.
pub struct Mitsuba {
    /// The ray of its sensor.
    pub ray: Ray,
    /// Its first hit.
    pub hit: Option<Hit>,
}

impl Mitsuba {
    /// Reads ray and hit at `index` of the golden films, if there are any.
    pub fn read(golden: Option<PathBuf>, index: usize) -> Result<Option<Mitsuba>> {
        let Some(path) = golden else { return Ok(None) };
        let hits = Film::read(&path)?;
        let rays = Film::read(&path.with_extension("rays.exr"))?;
        Ok(Some(Mitsuba {
            ray: rays.ray(index),
            hit: hits.hit(index),
        }))
    }
}

/// An answer's reply, or why there is none.
pub type AnswerResult<T> = std::result::Result<T, NoAnswer>;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAnswer {
    /// There is no ray to ask about.
    NoRay,
    /// There is no usable file of this name.
    NoFile(String),
    /// This file does not compile.
    DoesNotCompile(String),
    /// It failed when it was asked.
    Failed(FilmOutcome),
    /// It was asked, and gave no answer.
    Nothing,
}

/// One pixel, answer by answer.
pub struct PixelExplanation {
    /// The ray through the pixel.
    pub ray: AnswerResult<Ray>,
    /// The ray that all other answers were asked about: the submission's, or else Mitsuba's.
    pub asked: Option<Ray>,
    /// What each object answers by itself, in the scene's order.
    pub candidates: Vec<AnswerResult<Option<Hit>>>,
    /// The nearest object.
    pub nearest: AnswerResult<Option<Hit>>,
    /// What Mitsuba found at this pixel.
    pub mitsuba: Option<Mitsuba>,
    /// What the submission's code printed.
    pub printed: PixelOutput,
}

/// What a submission's code printed for each question.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PixelOutput {
    /// For the ray.
    pub ray: String,
    /// For each object alone.
    pub candidates: Vec<String>,
    /// For the nearest object.
    pub nearest: String,
}

/// A built submission that can be asked about one pixel.
pub struct PixelAsker<'a> {
    /// The submission's program.
    pub program: &'a Program,
    /// The sandbox that it runs in.
    pub sandbox: &'a Sandbox,
    /// The assignment whose tasks it answers.
    pub assignment: &'a Assignment,
    /// How long each answer may take.
    pub wall: Duration,
}

impl PixelAsker<'_> {
    /// Asks every answer that has to do with `pixel`, each alone.
    pub fn explain(
        &self,
        scene: &Scene,
        pixel: Pixel,
        mitsuba: Option<Mitsuba>,
    ) -> Result<PixelExplanation> {
        let Scene {
            camera,
            resolution,
            min_t,
            ref objects,
        } = *scene;
        let question = CameraQuestion {
            camera,
            pixel,
            resolution,
        };
        let mut printed = PixelOutput::default();
        let ray = self.ask(
            self.assignment.task_of_kind(Kind::ViewingRay, None),
            &Job::Ask(Questions::ViewingRay(vec![question])),
            |answer| match answer {
                Answer::Ray(ray) => Some(ray),
                _ => None,
            },
            &mut printed.ray,
        )?;
        let asked = ray
            .as_ref()
            .ok()
            .copied()
            .or(mitsuba.as_ref().map(|mitsuba| mitsuba.ray));
        let mut candidates = Vec::new();
        let mut nearest = Err(NoAnswer::NoRay);
        if let Some(ray) = asked {
            let hit = |answer| match answer {
                Answer::Hit(hit) => Some(hit),
                _ => None,
            };
            // Ask an answer that never ends only once, because each further object would take as
            // long again.
            let mut endless = None;
            for shape in objects {
                let question = ShapeQuestion {
                    shape: shape.clone(),
                    ray,
                    min_t,
                };
                let kind = shape.kind();
                let task = self
                    .assignment
                    .task_of_kind(Kind::of_shape(kind), Some(kind));
                let job = Job::Ask(Questions::Intersect(vec![question]));
                let mut text = String::new();
                let said = match &endless {
                    Some((known, why)) if *known == kind => Err(NoAnswer::clone(why)),
                    _ => self.ask(task, &job, hit, &mut text)?,
                };
                printed.candidates.push(text);
                if let Err(why @ NoAnswer::Failed(FilmOutcome::TimedOut { .. })) = &said {
                    endless = Some((kind, why.clone()));
                }
                candidates.push(said);
            }
            let task = self.assignment.task_of_kind(Kind::FirstHit, None);
            let job = Job::Cast(ray, min_t, objects.clone());
            nearest = self.ask(task, &job, hit, &mut printed.nearest)?;
        }
        Ok(PixelExplanation {
            ray,
            asked,
            candidates,
            nearest,
            mitsuba,
            printed,
        })
    }

    /// Asks one answer one question. A failure hides no other answer.
    fn ask<T>(
        &self,
        task: Option<&Task>,
        job: &Job,
        pick: impl Fn(Answer) -> Option<T>,
        printed: &mut String,
    ) -> Result<AnswerResult<T>> {
        let replaced = |task: &Task| self.program.replaced.get(&task.name);
        if let Some((task, replaced)) = task.and_then(|task| Some((task, replaced(task)?))) {
            let file = task.file();
            return Ok(Err(match replaced {
                Replacement::Unusable(_) => NoAnswer::NoFile(file),
                Replacement::DoesNotCompile(_) => NoAnswer::DoesNotCompile(file),
            }));
        }
        let reply = examine::run(
            self.program,
            self.sandbox,
            &Limits::of_own_answers(self.wall),
            job,
            &mut |_| {},
        )?;
        printed.push_str(&reply.printed);
        let answer = reply.answers.first().copied().flatten().and_then(pick);
        Ok(answer.ok_or_else(|| {
            let task = task.map(|task| task.name.as_str());
            examine::failure(&reply, self.program, task).map_or(NoAnswer::Nothing, NoAnswer::Failed)
        }))
    }
}
