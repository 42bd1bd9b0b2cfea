//! `pinhole check --watch`: judges each answer when it is saved.
//!
//! Everything that happens is an [`Event`] in one channel: a save ([`saves`]), a verdict
//! ([`judge`]), a key ([`keys`]). Only [`state`] decides what to do about it, and it knows
//! nothing of terminals. [`screen`] and [`hints`] write the text, and [`terminal`] shows it.
//! Without a terminal, [`plain`] prints lines.

mod hints;
mod judge;
mod keys;
mod order;
mod plain;
mod report;
mod saves;
mod screen;
mod signals;
mod state;
mod terminal;

use std::io::{IsTerminal, stdin, stdout};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use judge::Judge;
use keys::Key;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::Examination;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::submission::Submission;
use pinhole_report::html::RepeatCommands;
use plain::Plain;
use state::{Action, State};
use terminal::Terminal;

/// The watched submission, and everything needed to judge it.
pub struct Course {
    pub assignment: Assignment,
    pub goldens: Goldens,
    pub checkout: Checkout,
    pub sandbox: Sandbox,
    /// How long each process may take.
    pub wall: Duration,
    /// The answers to begin with.
    pub submission: Submission,
    /// Only these tasks and no scenes; empty for everything.
    pub tasks: Vec<String>,
    /// Where the report is written when the student asks for it.
    pub report: PathBuf,
    /// The command that repeats the examination, for the report.
    pub again: RepeatCommands,
}

/// Everything that can happen.
#[derive(Debug)]
pub enum Event {
    /// The answers have changed.
    Saved {
        /// All answers.
        submission: Submission,
        /// The tasks whose files differ.
        tasks: Vec<String>,
        /// When they were written.
        at: Instant,
    },
    /// The answers cannot be read any more.
    Lost(Error),
    /// The judge began a part of an order.
    Asking {
        order: u64,
        what: String,
        at: Instant,
    },
    /// Part of an order has been judged.
    Judged {
        order: u64,
        examination: Box<Examination>,
        at: Instant,
    },
    /// All of an order has been judged.
    Finished { order: u64 },
    /// An order cannot be judged.
    Failed { order: u64, error: Error },
    /// A key was pressed.
    Key(Key),
    /// The terminal has another size.
    Resized,
    /// No more saves will come. End when everything is reported.
    Closed,
    /// End now.
    Quit,
    /// One of our threads has panicked. Its message has been printed.
    Broken,
}

/// How often the screen updates the time that the current question has taken.
const TICK: Duration = Duration::from_millis(250);

/// Watches until the user quits.
pub fn run(course: Course, json: bool) -> Result<()> {
    let (send, events) = mpsc::channel();
    let course = Arc::new(course);
    let mut judge = Judge::prepare(Arc::clone(&course), send.clone())?;
    signals::listen(&send)?;
    saves::listen(&course, send.clone());
    let mut state = State::new(&course);
    let on_screen = !json && stdin().is_terminal() && stdout().is_terminal();
    let mut view = match on_screen && !terminal::is_dumb() {
        true => View::Screen(Terminal::enter(send)?),
        false => {
            plain::listen(send);
            View::Plain(Plain::begin(&course, json))
        }
    };
    let mut acts = state.begin();
    loop {
        for act in acts {
            match act {
                Action::Ask(order) => judge.ask(order),
                Action::Report => state.say(report::show(&course, &state.known)),
                Action::Quit => return view.leave(&mut state),
            }
        }
        view.show(&mut state)?;
        let event = match events.recv_timeout(TICK) {
            Ok(Event::Broken) => return Err(Error::environment("internal error", "report it")),
            Ok(event) => event,
            Err(_) => {
                acts = Vec::new();
                continue;
            }
        };
        match &mut view {
            View::Plain(plain) => plain.tell(&event, &state),
            View::Screen(terminal) if matches!(event, Event::Resized) => terminal.forget(),
            View::Screen(_) => {}
        }
        acts = state.step(event);
    }
}

/// Shows results.
enum View {
    Screen(Terminal),
    Plain(Plain),
}

impl View {
    fn show(&mut self, state: &mut State) -> Result<()> {
        match self {
            View::Screen(terminal) => terminal.show(state),
            View::Plain(_) => Ok(()),
        }
    }

    fn leave(self, state: &mut State) -> Result<()> {
        match self {
            View::Screen(terminal) => terminal.leave(state),
            View::Plain(_) => Ok(()),
        }
    }
}
