//! What may be asked of a submission, what it may answer, and how both travel.
//!
//! A submission runs as a process of its own. It reads one [`Job`] and writes a stream
//! of [`Message`]s: each a four-byte little-endian length and that many bytes of
//! postcard. The reader trusts none of it (see [`ask`](crate::ask)).

use std::io::{self, Read, Write};
use std::ops::Range;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::counter::counted;
use crate::kind::{
    self, Answer, AnswerFn, CameraQuestion, Kind, Questions, Test, Unregistered, WireAnswer,
};
use crate::ray::Ray;
use crate::scene::Scene;
use crate::shape::{Shape, ShapeKind};

/// One piece of work, with a fixed number of answers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Job {
    /// Cast a scene: a hit for every pixel, in image order.
    Film(Scene),
    /// Cast these pixels of a scene, given by their places in image order.
    Pixels(Scene, Range<usize>),
    /// Cast several scenes, one after the other.
    Films(Vec<Scene>),
    /// An answer to each question.
    Ask(Questions),
    /// The first hit of one ray among real shapes: a single answer.
    Cast(Ray, f64, Vec<Shape>),
    /// Where each of these rays meets one of the scene's objects, given by its place in the list.
    Meet(Scene, Vec<(Ray, usize)>),
}

impl Job {
    /// How many answers this job has.
    pub fn len(&self) -> usize {
        match self {
            Job::Film(scene) => scene.resolution.pixels(),
            Job::Pixels(_, pixels) => pixels.len(),
            Job::Films(scenes) => scenes.iter().map(|scene| scene.resolution.pixels()).sum(),
            Job::Ask(questions) => questions.len(),
            Job::Cast(..) => 1,
            Job::Meet(_, rays) => rays.len(),
        }
    }

    /// Whether there is nothing to answer.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the tests that its answers take are counted.
    pub fn is_counted(&self) -> bool {
        self.questions()
            .is_some_and(|questions| questions.kind().is_counted())
    }

    /// Whether it needs the answer to a task of this kind, about this shape if the kind is about
    /// one.
    pub fn needs(&self, kind: Kind, shape: Option<ShapeKind>) -> bool {
        match self {
            Job::Film(scene) | Job::Pixels(scene, _) | Job::Meet(scene, _) => {
                kind.is_needed_by(shape, scene)
            }
            Job::Films(scenes) => scenes.iter().any(|scene| kind.is_needed_by(shape, scene)),
            Job::Ask(questions) => kind == questions.kind(),
            Job::Cast(..) => true,
        }
    }

    /// The questions it asks one by one, if it does.
    pub fn questions(&self) -> Option<&Questions> {
        match self {
            Job::Ask(questions) => Some(questions),
            Job::Film(_) | Job::Pixels(..) | Job::Films(_) | Job::Cast(..) | Job::Meet(..) => None,
        }
    }

    /// The job for only the answers in this range, if it asks one question after the other or casts
    /// one scene.
    pub fn part(&self, range: Range<usize>) -> Option<Job> {
        match self {
            Job::Ask(questions) => Some(Job::Ask(questions.part(range))),
            Job::Film(scene) => Some(Job::Pixels(scene.clone(), range)),
            Job::Pixels(..) | Job::Films(_) | Job::Cast(..) | Job::Meet(..) => None,
        }
    }

    /// One of its answers, by a submission's functions.
    pub(crate) fn answer(
        &self,
        index: usize,
        functions: &[AnswerFn],
    ) -> Result<WireAnswer, Unregistered> {
        let hit = match self {
            Job::Film(scene) => return pixel(scene, index, functions),
            Job::Pixels(scene, pixels) => return pixel(scene, pixels.start + index, functions),
            Job::Films(scenes) => {
                let mut index = index;
                for scene in scenes {
                    match index.checked_sub(scene.resolution.pixels()) {
                        None => return pixel(scene, index, functions),
                        Some(later) => index = later,
                    }
                }
                unreachable!("the index is less than the number of answers");
            }
            Job::Ask(questions) => return questions.answer(index, functions),
            Job::Cast(ray, min_t, objects) => kind::cast(ray, *min_t, objects, functions),
            Job::Meet(scene, rays) => {
                let (ray, object) = rays[index];
                kind::meet(&ray, scene.min_t, &scene.objects[object], functions)
            }
        };
        hit.map(WireAnswer::Answer)
    }

    /// Turns what was sent for one of its questions into an answer; `None` if it answers another
    /// kind of question.
    pub(crate) fn receive(&self, index: usize, sent: &WireAnswer) -> Option<Answer> {
        match self {
            Job::Ask(questions) => questions.receive(index, sent),
            Job::Film(_) | Job::Pixels(..) | Job::Films(_) => match sent {
                WireAnswer::Counted(answer, _) => WireAnswer::Answer(*answer).hit(),
                sent => sent.hit(),
            },
            Job::Cast(..) | Job::Meet(..) => sent.hit(),
        }
    }
}

/// The hit at a pixel of a scene.
fn pixel(scene: &Scene, index: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
    let ray = CameraQuestion::of_scene(scene, index).ray(functions)?;
    let (hit, tests) = counted(|| kind::cast(&ray, scene.min_t, &scene.objects, functions));
    Ok(match tests {
        0 => WireAnswer::Answer(hit?),
        _ => WireAnswer::Counted(hit?, tests),
    })
}

/// A panic inside a student's code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Panic {
    /// Its text, at most [`MOST_PANIC_TEXT`] bytes.
    pub message: String,
    /// The source file it came from, as the compiler named it; cut like the message.
    pub file: String,
    /// Line in that file, from 1; 0 if unknown.
    pub line: u32,
    /// The place of the question in its job.
    pub index: usize,
}

/// Longer panic texts are cut.
pub const MOST_PANIC_TEXT: usize = 2000;

impl Panic {
    /// Whether it came from `todo!` or `unimplemented!`: nothing was attempted yet.
    pub fn is_unanswered(&self) -> bool {
        ["not yet implemented", "not implemented"]
            .iter()
            .any(|start| self.message.starts_with(start))
    }
}

/// What a submission sends back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Message {
    /// Answers to consecutive questions, at most [`CHUNK`] of them.
    Answers {
        /// The place of the first of them in the job.
        first: usize,
        /// The answers, in the job's order.
        answers: Vec<WireAnswer>,
    },
    /// A search asks for a test. The number is the place of its question in the job.
    Test(usize, Test),
    /// The student's code panicked; nothing more will come.
    Panicked(Panic),
    /// There is no function to ask; nothing more will come.
    Unregistered(Unregistered),
    /// The place of a question that is still being answered. The asker wants to know it when it
    /// gives up.
    StillAt(usize),
    /// The submission has read the job, and begins to answer. Nothing comes before this.
    Started,
}

/// A message holds at most this many answers. They are few enough for smooth progress, and for
/// several threads to share a group of questions.
pub const CHUNK: usize = 64;

/// Writes one length-prefixed value.
pub(crate) fn send<T: Serialize>(value: &T, out: &mut impl Write) -> io::Result<()> {
    let bytes = postcard::to_stdvec(value).map_err(io::Error::other)?;
    let length = u32::try_from(bytes.len()).map_err(io::Error::other)?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(&bytes)?;
    out.flush()
}

/// Reads one length-prefixed value of at most `most` bytes; `None` at the end.
///
/// # Errors
/// If the stream breaks off inside a value, a value is longer than `most`, or its
/// bytes are not exactly one `T`.
pub(crate) fn receive<T: DeserializeOwned>(
    input: &mut impl Read,
    most: usize,
) -> io::Result<Option<T>> {
    let mut length = [0; 4];
    let begun = loop {
        match input.read(&mut length[..1]) {
            // This happens when someone suspends the asker's process and resumes it.
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            begun => break begun?,
        }
    };
    if begun == 0 {
        return Ok(None);
    }
    input.read_exact(&mut length[1..])?;
    let length = u32::from_le_bytes(length) as usize;
    if length > most {
        return Err(io::Error::other(format!(
            "a message of {length} bytes is too long"
        )));
    }
    let mut bytes = vec![0; length];
    input.read_exact(&mut bytes)?;
    match postcard::take_from_bytes(&bytes) {
        Ok((value, [])) => Ok(Some(value)),
        _ => Err(io::Error::other("a message could not be read")),
    }
}

#[cfg(test)]
mod tests;
