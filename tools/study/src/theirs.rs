//! A student's answers beside the kernels: what they are asked, and what they said.
//!
//! Their code never runs in here. [`asked`](crate::asked) writes down the questions, `pinhole study
//! --submission` has them answered in its sandbox, and [`Theirs`] looks up what came. In
//! tables and plots they are one more kernel, [`NAME`].

mod told;

use std::collections::{BTreeMap, HashMap};

use pinhole::job::Job;
use pinhole::kind::Answer;
use serde::{Deserialize, Serialize};

pub use told::Told;

use crate::family::mesh::Aim;
use crate::question::Data;

/// How tables call them.
pub const NAME: &str = "yours";
/// Rays at edges of closed meshes, and as many at corners: each is asked of every face.
pub const MESH_RAYS: usize = 2_000;

/// One part of the study, as a student's code is asked it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Asked {
    /// Which part: the key to the answers.
    pub part: String,
    /// Its questions.
    pub job: Job,
}

/// What came of one part.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Said {
    /// Which part.
    pub part: String,
    /// One for each question; `None` where none came.
    pub answers: Vec<Option<Answer>>,
    /// Why some did not come, in words.
    pub problem: Option<String>,
}

/// All that a student's code said.
#[derive(Clone, Debug, Default)]
pub struct Theirs(HashMap<String, Said>);

impl Theirs {
    /// By part.
    pub fn new(said: Vec<Said>) -> Theirs {
        Theirs(
            said.into_iter()
                .map(|said| (said.part.clone(), said))
                .collect(),
        )
    }

    /// What was said to a family of questions; `None` if nothing was.
    pub fn family(&self, shape: &str, family: &str) -> Option<Told<'_>> {
        self.part(&family_part(shape, family)).map(Told::new)
    }

    /// Which faces of closed meshes were met: for each ray, every face in turn.
    pub fn mesh(&self, aim: Aim) -> Option<Told<'_>> {
        self.part(&mesh_part(aim)).map(Told::new)
    }

    /// What was seen at each pixel of a scene.
    pub fn scene(&self, scene: &str) -> Option<&[Option<Answer>]> {
        self.part(&scene_part(scene))
    }

    /// What went wrong while they were asked, and in which parts.
    pub fn problems(&self) -> Vec<String> {
        let mut parts: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for said in self.0.values() {
            if let Some(problem) = &said.problem {
                parts.entry(problem).or_default().push(&said.part);
            }
        }
        let lines = parts.into_iter().map(|(problem, mut parts)| {
            parts.sort_unstable();
            format!("{problem} ({})", parts.join("; "))
        });
        lines.collect()
    }

    fn part(&self, part: &str) -> Option<&[Option<Answer>]> {
        let answers = &self.0.get(part)?.answers;
        answers.iter().any(Option::is_some).then_some(answers)
    }
}

/// Begins with the task, where there is one.
pub(crate) fn family_part(shape: &str, family: &str) -> String {
    format!("{shape}, {family}")
}

pub(crate) fn mesh_part(aim: Aim) -> String {
    match aim {
        Aim::Edge => "triangle, edges of closed meshes".into(),
        Aim::Vertex => "triangle, corners of closed meshes".into(),
    }
}

pub(crate) fn scene_part(scene: &str) -> String {
    format!("scene {scene}")
}

/// The numbers of their data.
pub const DATA: Data = Data::F64;
