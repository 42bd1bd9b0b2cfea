//! `pinhole check`: a student's loop.

use std::time::Duration;

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Check;
use crate::compile::compile;
use crate::error::{Error, Result};
use crate::examine::{Examiner, Selection};
use crate::goldens::Goldens;
use crate::progress::Progress;
use crate::sandbox::Sandbox;
use crate::second_judge::SecondJudge;
use crate::{json, table};

pub fn run(checkout: &Checkout, arguments: &Check) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, arguments.dir.as_ref().unwrap_or(&here))?;
    let goldens = match &arguments.golden {
        Some(folder) => Goldens::read(folder, &assignment)?,
        None => Goldens::read(&checkout.golden(&assignment.name), &assignment)?,
    };
    let selection = selection(arguments, &assignment, &goldens)?;
    let submission = super::submission(arguments.dir.as_ref(), &assignment, assignment.handout())?;
    let sandbox = Sandbox::around(&submission.folder, checkout, arguments.run.trust)?;

    let second_judge = arguments
        .oiiotool
        .then(|| SecondJudge::find(checkout))
        .transpose()?;
    let progress = Progress::new();
    progress.say("building");
    let program = compile(&submission, &assignment, checkout, &sandbox)?;
    let examiner = Examiner {
        assignment: &assignment,
        goldens: &goldens,
        program: &program,
        sandbox: &sandbox,
        wall: Duration::from_secs(arguments.run.timeout),
        second_judge: second_judge.as_ref(),
        progress: &|what, share| progress.show(what, share),
    };
    let examination = examiner.examine(&submission, &selection)?;
    progress.clear();

    if arguments.json {
        anstream::println!("{:#}", json::examination(&examination));
    } else {
        anstream::print!("{}", table::examination(&examination));
    }
    Ok(if examination.passes() {
        Outcome::Well
    } else {
        Outcome::JudgedWrong
    })
}

fn selection(arguments: &Check, assignment: &Assignment, goldens: &Goldens) -> Result<Selection> {
    let known = |what: &str, named: &[String], names: Vec<&str>| match named
        .iter()
        .find(|name| !names.contains(&name.as_str()))
    {
        Some(name) => Err(Error::input(
            format!("there is no {what} `{name}`"),
            format!("name one of: {}", names.join(", ")),
        )),
        None => Ok(()),
    };
    let tasks = assignment
        .tasks
        .iter()
        .map(|task| task.name.as_str())
        .collect();
    known("task", &arguments.task, tasks)?;
    let scenes = goldens
        .scenes
        .iter()
        .map(|scene| scene.name.as_str())
        .collect();
    known("scene", &arguments.scene, scenes)?;
    Ok(Selection {
        tasks: arguments.task.clone(),
        scenes: arguments.scene.clone(),
    })
}
