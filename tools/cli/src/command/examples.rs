//! `pinhole examples`: judges answers that a student has worked out by hand.

use std::fs::File;
use std::io::Write;
use std::path::Path;

use clap::CommandFactory;
use serde_json::json;

use crate::cli::{Cli, Examples};
use pinhole_course::assignment::examples_file;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::examples::{self, JudgedExample, JudgedExamples, Verdict};
use pinhole_report::escape::printable;
use pinhole_report::program::Status;
use pinhole_report::terminal::{self, FAIL, PASS, QUIET, STRONG};

pub fn run(checkout: &Checkout, arguments: &Examples) -> Result<Status> {
    let file = arguments.file.as_deref();
    let assignment = arguments.assignment.find(checkout, file)?;
    if let Some(task) = &arguments.new {
        let named = examples_file(task);
        let file = file.unwrap_or(Path::new(&named));
        write_new(file, &examples::new_file(task, &assignment, file)?)?;
        let shown = printable(&file.display().to_string());
        match arguments.json {
            true => anstream::println!("{:#}", json!({ "task": task, "file": shown })),
            false => anstream::println!("wrote {shown}; the comments in it say what to do next"),
        }
        return Ok(Status::Well);
    }
    let Some(file) = file else {
        let mut help = Cli::command();
        help.build();
        let help = help.find_subcommand_mut("examples");
        let help = help.map(|it| it.render_long_help().ansi().to_string());
        anstream::println!("{}", help.unwrap_or_default());
        return Ok(Status::Well);
    };
    let judged = examples::judge_file(file, &assignment, checkout)?;
    match arguments.json {
        true => anstream::println!("{:#}", json!(judged)),
        false => print(&judged),
    }
    Ok(match judged.count(Verdict::Wrong) {
        0 => Status::Well,
        _ => Status::JudgedWrong,
    })
}

/// Writes a file, unless it exists.
fn write_new(file: &Path, text: &str) -> Result<()> {
    let wrong = Error::input(
        format!("cannot write {}", file.display()),
        "name a file that does not exist yet: cargo pinhole examples --new TASK FILE",
    );
    let mut file = File::create_new(file).or_fail(&wrong)?;
    file.write_all(text.as_bytes()).or_fail(&wrong)
}

fn print(judged: &JudgedExamples) {
    for example in &judged.examples {
        let (style, mark) = match example.verdict {
            Verdict::Right => (PASS, '✓'),
            Verdict::Wrong => (FAIL, '✗'),
            Verdict::Unanswered => (QUIET, '?'),
        };
        let JudgedExample {
            group, question, ..
        } = example;
        let said = said(example);
        let named = format!("{group} {question:<4} {said}");
        anstream::println!("{style}{mark}{style:#} {}", named.trim_end());
        if example.verdict != Verdict::Right {
            for row in terminal::facts(&example.asked).lines() {
                anstream::println!("      {row}");
            }
        }
    }
    anstream::println!("{STRONG}{}{STRONG:#}", summary(judged));
}

fn said(example: &JudgedExample) -> String {
    match (example.verdict, example.wrong.as_slice()) {
        (Verdict::Right, _) => String::new(),
        (Verdict::Unanswered, _) => "has no answer yet".into(),
        (Verdict::Wrong, ["hit"]) => "Mitsuba disagrees about whether there is a hit".into(),
        (Verdict::Wrong, parts) => format!(
            "Mitsuba gives a different {}",
            parts.join(" and a different ")
        ),
    }
}

fn summary(judged: &JudgedExamples) -> String {
    let JudgedExamples {
        caught, mistakes, ..
    } = judged;
    let of_all = format!("{mistakes} mistakes that people make in this task");
    let right = match judged.count(Verdict::Right) {
        0 => return format!("No example is correct yet. Correct ones can catch {of_all}."),
        1 => "correct example catches".into(),
        right => format!("{right} correct examples catch"),
    };
    match caught == mistakes {
        true => format!("Your {right} all {of_all}."),
        false => format!("Your {right} {caught} of {of_all}."),
    }
}
