//! Turns orders into verdicts, with a thread for each order.
//!
//! The harness, the stubs and the golden films are kept in memory. So each order needs only
//! one run of the compiler, and one process for each task.

use std::ops::ControlFlow;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use pinhole::ask::Stop;

use super::order::{Item, Order};
use super::{Course, Event};
use pinhole_course::compile::{Attempt, Compiler, Replacements};
use pinhole_course::error::Result;
use pinhole_course::examine::{Examiner, Selection};
use pinhole_course::outcome::{Examination, Outcome, TaskOutcome};
use pinhole_course::progress::Progress;
use pinhole_course::submission::flags::flags;

/// Takes orders. A new order replaces the one before.
pub struct Judge {
    course: Arc<Course>,
    /// Built again after a failure, because the folder of the harness may have been deleted.
    compiler: Arc<Mutex<Option<Arc<Compiler>>>>,
    events: Sender<Event>,
    stop: Stop,
    threads: Vec<JoinHandle<()>>,
}

/// How long a cancelled compiler may take to end.
const LAST_WORDS: Duration = Duration::from_secs(3);

impl Judge {
    /// Builds the harness, which takes a while the first time.
    pub fn prepare(course: Arc<Course>, events: Sender<Event>) -> Result<Judge> {
        let progress = Progress::new();
        progress.say("building");
        let compiler = gather(&course)?;
        progress.clear();
        Ok(Judge {
            course,
            compiler: Arc::new(Mutex::new(Some(compiler))),
            events,
            stop: Stop::default(),
            threads: Vec::new(),
        })
    }

    /// Begins an order and cancels the last one.
    pub fn ask(&mut self, order: Order) {
        self.stop.raise();
        self.stop = Stop::default();
        self.threads.retain(|thread| !thread.is_finished());
        let judge = OrderJudge {
            course: Arc::clone(&self.course),
            compiler: Arc::clone(&self.compiler),
            events: self.events.clone(),
            stop: self.stop.clone(),
            order,
        };
        self.threads.push(thread::spawn(move || judge.work()));
    }
}

impl Drop for Judge {
    /// Wait, so that no process of a submission outlives the watch.
    fn drop(&mut self) {
        self.stop.raise();
        let end = Instant::now() + LAST_WORDS;
        while Instant::now() < end && self.threads.iter().any(|thread| !thread.is_finished()) {
            thread::sleep(Duration::from_millis(5));
        }
    }
}

fn gather(course: &Course) -> Result<Arc<Compiler>> {
    let compiler = Compiler::new(&course.assignment, &course.checkout, &course.sandbox)?;
    Ok(Arc::new(compiler.naming_places()))
}

/// The work on one order.
struct OrderJudge {
    course: Arc<Course>,
    compiler: Arc<Mutex<Option<Arc<Compiler>>>>,
    events: Sender<Event>,
    stop: Stop,
    order: Order,
}

impl OrderJudge {
    fn work(&self) {
        let _alarm = Alarm(&self.events);
        let order = self.order.number;
        self.tell(match self.judge() {
            Ok(()) => Event::Finished { order },
            Err(error) => {
                if !self.stop.is_raised() {
                    *self.kept() = None;
                }
                Event::Failed { order, error }
            }
        });
    }

    fn judge(&self) -> Result<()> {
        let Course {
            assignment,
            sandbox,
            ..
        } = &*self.course;
        let submission = &*self.order.submission;
        let mut items = self.order.items.clone();
        let mut told = |replaced: &Replacements| {
            items.retain(|item| self.tell_if_replaced(item, replaced).is_continue());
            items.is_empty()
        };
        let attempt = self.compiler()?.compile_until(submission, &mut told)?;
        let Attempt::Program(mut program) = attempt else {
            return Ok(());
        };
        program.stop = self.stop.clone();
        let asking = Mutex::new(String::new());
        let examiner = Examiner {
            assignment,
            goldens: &self.course.goldens,
            program: &program,
            sandbox,
            wall: self.course.wall,
            interactive: true,
            second_judge: None,
            clock: None,
            withheld: &[],
            known: None,
            progress: &|what, _| {
                let mut asking = asking.lock().unwrap_or_else(PoisonError::into_inner);
                if *asking != what {
                    *asking = what.into();
                    self.tell(Event::Asking {
                        order: self.order.number,
                        what: what.into(),
                        at: Instant::now(),
                    });
                }
            },
        };
        for item in items {
            let mut selection = Selection::default();
            match item {
                Item::Task(name) => selection.tasks.push(name),
                Item::Scenes => {
                    let scenes = &self.course.goldens.scenes;
                    selection.scenes = scenes.iter().map(|scene| scene.name.clone()).collect();
                }
            }
            self.tell_judged(examiner.examine(submission, &selection)?);
        }
        Ok(())
    }

    /// Whether an item must still be asked. An answer that was replaced by its stub is judged
    /// without asking.
    fn tell_if_replaced(&self, item: &Item, replaced: &Replacements) -> ControlFlow<()> {
        let Item::Task(name) = item else {
            return ControlFlow::Continue(());
        };
        let assignment = &self.course.assignment;
        match (replaced.get(name), assignment.task(name)) {
            (Some(why), Some(task)) => {
                let folder = self.order.submission.folder.display().to_string();
                let sandbox = self.course.sandbox.name();
                let mut outcome = Outcome::new(&assignment.title, folder, sandbox);
                outcome.tasks.push(TaskOutcome::replaced(task, why));
                outcome.flags = flags(&self.order.submission);
                outcome.add_up();
                self.tell_judged(Examination {
                    outcome,
                    films: Vec::new(),
                    pictures: Vec::new(),
                });
                ControlFlow::Break(())
            }
            _ => ControlFlow::Continue(()),
        }
    }

    fn tell_judged(&self, examination: Examination) {
        self.tell(Event::Judged {
            order: self.order.number,
            examination: Box::new(examination),
            at: Instant::now(),
        });
    }

    fn tell(&self, event: Event) {
        // Once the watch has ended, the event has no receiver.
        let _ = self.events.send(event);
    }

    fn compiler(&self) -> Result<Arc<Compiler>> {
        if let Some(compiler) = &*self.kept() {
            return Ok(Arc::clone(compiler));
        }
        let compiler = gather(&self.course)?;
        *self.kept() = Some(Arc::clone(&compiler));
        Ok(compiler)
    }

    fn kept(&self) -> std::sync::MutexGuard<'_, Option<Arc<Compiler>>> {
        self.compiler.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Ends the watch when the thread that holds it panics.
struct Alarm<'a>(&'a Sender<Event>);

impl Drop for Alarm<'_> {
    fn drop(&mut self) {
        if thread::panicking() {
            let _ = self.0.send(Event::Broken);
        }
    }
}
