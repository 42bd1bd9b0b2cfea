//! `pinhole check`: a student's loop.

use std::time::Duration;

use clap::ValueEnum;

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::{Check, Run};
use crate::compile::compile;
use crate::describe::printable;
use crate::error::{Error, Result};
use crate::examination::Examination;
use crate::examine::{Examiner, Selection};
use crate::goldens::Goldens;
use crate::passage::{self, Passage};
use crate::progress::Progress;
use crate::report::{Again, Report};
use crate::sandbox::{Choice, Sandbox};
use crate::second_judge::SecondJudge;
use crate::shell::{PINHOLE, in_shell};
use crate::submission::flags::flags;
use crate::watch::{self, Course};
use crate::{json, table};

pub fn run(checkout: &Checkout, arguments: &Check) -> Result<Outcome> {
    let here = std::env::current_dir().unwrap_or_default();
    let assignment = Assignment::around(checkout, arguments.dir.as_ref().unwrap_or(&here))?;
    let goldens = match &arguments.golden {
        Some(folder) => Goldens::find(folder, &assignment, checkout)?,
        None => Goldens::read(&checkout.golden(&assignment.name), &assignment)?,
    };
    let selection = selection(arguments, &assignment, &goldens)?;
    let submission = super::submission(arguments.dir.as_ref(), &assignment, assignment.handout())?;
    let sandbox = Sandbox::around(
        &submission.folder,
        checkout,
        arguments.run.walls(),
        &arguments.golden.iter().cloned().collect::<Vec<_>>(),
    )?;

    let default_report = checkout.scratch().join("report.html");
    if arguments.watch {
        let course = Course {
            assignment,
            goldens,
            checkout: checkout.clone(),
            sandbox,
            wall: Duration::from_secs(arguments.run.timeout),
            submission,
            tasks: selection.tasks,
            report: arguments.report.clone().unwrap_or(default_report),
            again: again(arguments),
        };
        // However it ends: the student has seen the verdicts.
        return watch::run(course, arguments.json).map(|()| Outcome::Well);
    }
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
        clock: None,
        progress: &|what, share| progress.show(what, share),
    };
    let examination = examiner.examine(&submission, &selection)?;
    progress.clear();

    let path = match &arguments.report {
        Some(path) => Some(path.clone()),
        None if arguments.no_report => None,
        None => Some(default_report),
    };
    // The verdict is worth more than its report: it is shown before anything is said of
    // a report that could not be written.
    let written = path.map(|path| {
        let mut report = Report::of_examination(&examination, &goldens.folder, &again(arguments))?;
        report.book = passage::built(checkout.root());
        report.write(&path).map(|()| path)
    });
    let path = match &written {
        Some(Ok(path)) => Some(path.display().to_string()),
        _ => None,
    };
    if arguments.json {
        let mut document = json::examination(&examination);
        document["report"] = path.into();
        document["sandbox"] = sandbox.name().into();
        document["flags"] = json::flags(&flags(&submission));
        anstream::println!("{document:#}");
    } else {
        anstream::print!("{}", table::examination(&examination));
        if let Some(path) = path {
            anstream::println!("\nreport: {}", printable(&path));
        }
        if let Some(passage) = arguments
            .read
            .then(|| worth_reading(&examination))
            .flatten()
        {
            anstream::println!("\n{}", printable(&passage.open(checkout.root())));
        }
    }
    written.transpose()?;
    Ok(if examination.passes() {
        Outcome::Well
    } else {
        Outcome::JudgedWrong
    })
}

/// What helps with the first task that fails, or with the first scene.
fn worth_reading(examination: &Examination) -> Option<Passage> {
    let mut tasks = examination.tasks.iter();
    let task = tasks.find(|task| task.groups.iter().any(|group| !group.outcome.passes()));
    let scenes = examination.scenes.iter();
    let mut scenes = scenes.filter(|scene| !scene.diagnosis.is_empty());
    match (task, scenes.next()) {
        (Some(task), _) => Passage::against(&task.diagnosis, &task.chapter),
        (None, Some(scene)) => Passage::against(&scene.diagnosis, ""),
        (None, None) => Vec::new(),
    }
    .into_iter()
    .next()
}

/// The command that does the same again.
fn again(arguments: &Check) -> Again {
    let mut part = format!("{PINHOLE} check");
    let add = |words: &mut String, word: &str| {
        words.push(' ');
        words.push_str(&in_shell(word));
    };
    if let Some(dir) = &arguments.dir {
        add(&mut part, &dir.display().to_string());
    }
    if let Some(golden) = &arguments.golden {
        add(&mut part, "--golden");
        add(&mut part, &golden.display().to_string());
    }
    if arguments.run.timeout != Run::TIMEOUT {
        add(&mut part, "--timeout");
        add(&mut part, &arguments.run.timeout.to_string());
    }
    if let Some(walls) = arguments.run.walls().to_possible_value()
        && arguments.run.walls() != Choice::Auto
    {
        add(&mut part, "--sandbox");
        add(&mut part, walls.get_name());
    }
    let mut whole = part.clone();
    for (option, names) in [("--task", &arguments.task), ("--scene", &arguments.scene)] {
        for name in names {
            add(&mut whole, option);
            add(&mut whole, name);
        }
    }
    Again { whole, part }
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
