//! Casts the films of mistakes. Each mistake is compiled like a student's answers.

use std::time::Duration;

use pinhole::Film;
use pinhole::ask::Ending;
use pinhole::job::Job;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::mistake::MistakeFolder;
use pinhole_course::sandbox::{Limits, Sandbox};
use pinhole_course::{examine, overlay};

use super::strip::SceneGolden;
use crate::error::{Problem, Result};

/// The longest time that a mistake may take to cast a scene.
const WALL: Duration = Duration::from_secs(30);

/// Compiles mistakes and lets them cast scenes.
pub struct Caster<'a> {
    assignment: &'a Assignment,
    checkout: &'a Checkout,
    compiler: Compiler,
}

impl<'a> Caster<'a> {
    /// Prepares the compiler.
    pub fn new(assignment: &'a Assignment, checkout: &'a Checkout) -> Result<Caster<'a>> {
        Ok(Caster {
            assignment,
            checkout,
            compiler: Compiler::new(assignment, checkout, &Sandbox::Trusted)?,
        })
    }

    /// The films of this mistake in each of these scenes.
    pub fn films(&self, mistake: &MistakeFolder, scenes: &[&SceneGolden]) -> Result<Vec<Film>> {
        let submission = overlay::reference(self.assignment)?.overlaid(&mistake.folder)?;
        let program = self.compiler.compile(&submission)?;
        let limits = Limits::of_answers(WALL);
        let film = |scene: &&SceneGolden| {
            let job = Job::Film(scene.scene.clone());
            let reply = examine::run(&program, &Sandbox::Trusted, &limits, &job, &mut |_| {})?;
            if reply.ending == Ending::Complete {
                return Ok(reply.film(scene.scene.resolution));
            }
            let problem = format!("it casts no film of {}: {:?}", scene.name, reply.ending);
            let remedy = "store the mistakes' films again: cargo pinhole golden mistakes";
            Err(Problem::of(self.checkout.inside(&mistake.folder), problem, remedy).into())
        };
        scenes.iter().map(film).collect()
    }
}
