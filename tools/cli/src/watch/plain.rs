//! The watch without a terminal: prints every verdict as it comes, as lines or as JSON.

use std::io::{self, Read, stdin};
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use serde_json::json;

use super::state::State;
use super::{Course, Event};
use pinhole_course::outcome::Examination;
use pinhole_course::shell::from_here;
use pinhole_report::escape::printable;
use pinhole_report::{json, terminal};

/// Prints verdicts.
pub struct Plain {
    json: bool,
    /// The width of the column of tasks' names.
    width: usize,
}

/// If standard input is a pipe, ends the watch when it closes, because then the program at its
/// other end is gone.
pub fn listen(events: Sender<Event>) {
    if is_pipe() {
        thread::spawn(move || {
            let _ended = io::copy(&mut stdin().lock().by_ref(), &mut io::sink());
            let _ = events.send(Event::Closed);
        });
    }
}

#[cfg(unix)]
fn is_pipe() -> bool {
    use std::fs::File;
    use std::os::fd::AsFd;
    use std::os::unix::fs::FileTypeExt;

    let file = stdin().as_fd().try_clone_to_owned().map(File::from);
    let metadata = file.and_then(|file| file.metadata());
    metadata
        .is_ok_and(|metadata| metadata.file_type().is_fifo() || metadata.file_type().is_socket())
}

#[cfg(not(unix))]
fn is_pipe() -> bool {
    false
}

impl Plain {
    /// Prints which folder is watched.
    pub fn begin(course: &Course, json: bool) -> Plain {
        if !json {
            let place = printable(&from_here(&course.submission.place).display().to_string());
            anstream::println!("watching {place}: each answer is judged when you save it");
        }
        let names = course.assignment.tasks.iter().map(|task| task.name.len());
        let width = names.max().unwrap_or(0) + 2;
        Plain { json, width }
    }

    /// Prints an event, unless it is stale.
    pub fn tell(&mut self, event: &Event, state: &State) {
        match event {
            Event::Judged {
                order,
                examination,
                at,
            } if state.awaits(*order) => {
                let after = state.waiting(examination, *at);
                self.verdict(examination, after);
            }
            Event::Failed { order, error } if state.awaits(*order) => self.problem(error),
            Event::Lost(error) => self.problem(error),
            _ => {}
        }
    }

    fn verdict(&self, examination: &Examination, after: Option<Duration>) {
        let after = after.map(|after| after.as_secs_f64());
        if self.json {
            let mut document = json::document(&examination.outcome);
            document["seconds_after_save"] = json!(after);
            anstream::println!("{document}");
            return;
        }
        let tasks = examination.outcome.tasks.iter();
        let tasks: String = tasks.map(|task| terminal::task(task, self.width)).collect();
        let scenes = terminal::scenes(examination);
        let printed = terminal::printed(&examination.outcome.printed);
        anstream::print!("{tasks}{scenes}{printed}");
        if let Some(after) = after {
            anstream::println!("  judged {after:.2} s after you saved");
        }
    }

    fn problem(&self, error: &pinhole_course::error::Error) {
        match self.json {
            true => anstream::println!(
                "{}",
                json!({ "error": error.problem, "remedy": error.remedy })
            ),
            false => anstream::println!(
                "{}\n  remedy: {}",
                printable(&error.problem),
                printable(&error.remedy)
            ),
        }
    }
}
