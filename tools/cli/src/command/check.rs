//! `pinhole check`: judges the answers.

mod shown;

use std::thread;

use clap::ValueEnum;

use self::shown::Checked;
use crate::cli::Check;
use crate::watch::{self, Course};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::{Error, Result};
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::examples::add_handed_in;
use pinhole_course::goldens::Goldens;
use pinhole_course::progress::Progress;
use pinhole_course::run_options::RunOptions;
use pinhole_course::sandbox::{Choice, Sandbox};
use pinhole_course::second_judge::SecondJudge;
use pinhole_course::shell::PINHOLE;
use pinhole_course::submission::Submission;
use pinhole_course::timings::timed;
use pinhole_report::escape::printable_word;
use pinhole_report::html::RepeatCommands;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Check) -> Result<Status> {
    let assignment = arguments
        .assignment
        .find(checkout, arguments.dir.as_deref())?;
    let goldens = match &arguments.golden {
        Some(folder) => Goldens::find(folder, &assignment)?,
        None => Goldens::read(&assignment.golden(), &assignment)?,
    };
    let selection = selection(arguments, &assignment, &goldens)?;
    let submission = Submission::named_or(arguments.dir.as_deref(), &assignment)?;
    let sandbox = Sandbox::around(
        &submission.read_from,
        checkout,
        arguments.run.sandbox.choice(),
        &arguments.golden.iter().cloned().collect::<Vec<_>>(),
    )?;

    let default_report = checkout.scratch().join("report.html");
    if arguments.watch {
        let course = Course {
            assignment,
            goldens,
            checkout: checkout.clone(),
            sandbox,
            wall: arguments.run.wall(),
            submission,
            tasks: selection.tasks,
            report: arguments.report.clone().unwrap_or(default_report),
            again: again(arguments),
        };
        // The exit code is always 0, because the student has already seen the verdicts.
        return watch::run(course, arguments.json).map(|()| Status::Well);
    }
    let second_judge = arguments
        .oiiotool
        .then(|| SecondJudge::find(checkout))
        .transpose()?;
    let progress = Progress::new();
    progress.say("building");
    let program = thread::scope(|scope| {
        scope.spawn(|| Examiner::warm_up(&assignment, &goldens, &selection));
        let compiler = Compiler::new(&assignment, checkout, &sandbox)?;
        let compiler = compiler
            .naming_places()
            .allowing(arguments.allow_everything);
        compiler.compile(&submission)
    })?;
    let examiner = Examiner {
        assignment: &assignment,
        goldens: &goldens,
        program: &program,
        sandbox: &sandbox,
        wall: arguments.run.wall(),
        interactive: true,
        second_judge: second_judge.as_ref(),
        clock: None,
        withheld: &[],
        known: None,
        progress: &|what, share| progress.show(what, share),
    };
    let mut examination = examiner.examine(&submission, &selection)?;
    progress.clear();
    add_handed_in(
        &mut examination.outcome,
        &submission,
        &assignment,
        checkout,
        true,
    )?;
    let path = match &arguments.report {
        Some(path) => Some(path.clone()),
        None if arguments.no_report => None,
        None => Some(default_report),
    };
    let done = Checked {
        arguments,
        checkout,
        examiner: &examiner,
        submission: &submission,
        selection: &selection,
        examination: &examination,
    };
    // Show the verdict even if the report could not be written, because it matters more.
    let written = path.map(|path| timed("write the report", || done.write_report(path)));
    let path = match &written {
        Some(Ok(path)) => Some(path.as_path()),
        _ => None,
    };
    let packed = match &arguments.pack {
        Some(zip) => Some((zip.as_path(), submission.pack(zip, &assignment)?)),
        None => None,
    };
    match arguments.json {
        true => done.print_json(path, packed),
        false => done.print(path, packed)?,
    }
    written.transpose()?;
    Ok(if examination.outcome.passes {
        Status::Well
    } else {
        Status::JudgedWrong
    })
}

/// The command that repeats this check.
fn again(arguments: &Check) -> RepeatCommands {
    let mut part = format!("{PINHOLE} check");
    let add = |words: &mut String, word: &str| {
        words.push(' ');
        words.push_str(&printable_word(word));
    };
    if let Some(dir) = &arguments.dir {
        add(&mut part, &dir.display().to_string());
    }
    if let Some(assignment) = &arguments.assignment.name {
        add(&mut part, "--assignment");
        add(&mut part, assignment);
    }
    if let Some(golden) = &arguments.golden {
        add(&mut part, "--golden");
        add(&mut part, &golden.display().to_string());
    }
    if arguments.run.timeout != RunOptions::TIMEOUT {
        add(&mut part, "--timeout");
        add(&mut part, &arguments.run.timeout.to_string());
    }
    if let Some(walls) = arguments.run.sandbox.choice().to_possible_value()
        && arguments.run.sandbox.choice() != Choice::Auto
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
    RepeatCommands { whole, part }
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
