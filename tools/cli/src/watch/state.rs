//! The state of the watch, and how events change it.
//!
//! Nothing here reads a file, a clock or a terminal. [`verdicts`] handles saves and verdicts,
//! and [`walk`] handles keys.

mod verdicts;
mod walk;

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::order::{Item, Order};
use super::{Course, Event};
use pinhole_course::assignment::{Assignment, Task};
use pinhole_course::error::Error;
use pinhole_course::outcome::{Examination, Outcome, TaskOutcome};
use pinhole_course::submission::Submission;
use pinhole_report::finish::Finish;
use pinhole_report::html::RepeatCommands;

/// The whole watch.
pub struct State {
    /// The items to judge: the task to begin with, the others in the assignment's order, and the
    /// scenes last.
    pub items: Vec<Item>,
    /// The item that is shown; `None` for the table of all.
    pub shown: Option<usize>,
    /// The newest verdict on every item that has one.
    pub known: Examination,
    stamps: BTreeMap<Item, Stamp>,
    /// When the saved answers began to wait for their verdict.
    saved: BTreeMap<Item, Instant>,
    pub submission: Arc<Submission>,
    /// How many times the answers have changed.
    generation: u64,
    /// What the judge is working on.
    order: Option<Order>,
    orders: u64,
    /// What the judge is asking now, and since when.
    pub asking: Option<(String, Instant)>,
    /// Whether the student has a task to work on. Until then, we look for the first task that lacks
    /// points.
    settled: bool,
    /// Why nothing can be judged.
    pub problem: Option<Error>,
    /// A short message about what has happened.
    pub notice: Option<String>,
    /// How many hints are shown.
    pub hints: usize,
    /// How many lines of the verdict are above the screen.
    pub scroll: usize,
    pub help: bool,
    /// Whether to show the report once everything is judged.
    report_wanted: bool,
    closing: bool,
    /// How many scenes there are.
    pub scenes: usize,
    /// All points that can be earned.
    possible: u32,
    assignment: Assignment,
    again: RepeatCommands,
}

/// What is known about a verdict.
struct Stamp {
    /// The answers it judges.
    generation: u64,
    /// The time from the save of these answers to the verdict.
    after_save: Option<Duration>,
    /// What the student's code printed.
    printed: String,
}

/// What the caller has to do next.
#[derive(Debug)]
pub enum Action {
    /// Judge these items, and cancel the current order.
    Ask(Order),
    /// Show the report.
    Report,
    /// End the watch.
    Quit,
}

impl State {
    pub fn new(course: &Course) -> State {
        let tasks = course.assignment.tasks.iter().map(|task| &task.name);
        let wanted = |name: &&String| course.tasks.is_empty() || course.tasks.contains(name);
        let mut items: Vec<Item> = tasks.filter(wanted).cloned().map(Item::Task).collect();
        items.sort_by_key(|item| item.name() != course.assignment.start);
        if course.tasks.is_empty() {
            items.push(Item::Scenes);
        }
        let folder = course.submission.folder.display().to_string();
        State {
            items,
            shown: Some(0),
            known: Examination {
                outcome: Outcome {
                    withheld: course.assignment.withheld,
                    ..Outcome::new(&course.assignment.title, folder, course.sandbox.name())
                },
                films: Vec::new(),
                pictures: Vec::new(),
            },
            stamps: BTreeMap::new(),
            saved: BTreeMap::new(),
            submission: Arc::new(course.submission.clone()),
            generation: 0,
            order: None,
            orders: 0,
            asking: None,
            settled: false,
            problem: None,
            notice: None,
            hints: 0,
            scroll: 0,
            help: false,
            report_wanted: false,
            closing: false,
            scenes: course.goldens.scenes.len(),
            possible: possible(course),
            assignment: course.assignment.clone(),
            again: course.again.clone(),
        }
    }

    /// The first order: every task.
    pub fn begin(&mut self) -> Vec<Action> {
        self.ask(Vec::new())
    }

    /// Handles an event, and returns what to do next.
    pub fn step(&mut self, event: Event) -> Vec<Action> {
        match event {
            Event::Saved {
                submission,
                tasks,
                at,
            } => self.saved(submission, &tasks, at),
            Event::Lost(error) => {
                self.problem = Some(error);
                Vec::new()
            }
            Event::Asking { order, what, at } => {
                if self.awaits(order) {
                    self.asking = Some((what, at));
                }
                Vec::new()
            }
            Event::Judged {
                order,
                examination,
                at,
            } => {
                if self.awaits(order) {
                    self.judged(*examination, at);
                }
                Vec::new()
            }
            Event::Finished { order } if self.awaits(order) => self.finished(),
            Event::Failed { order, error } if self.awaits(order) => {
                self.rest();
                self.problem = Some(error);
                self.quit_if_closing()
            }
            Event::Finished { .. } | Event::Failed { .. } | Event::Resized => Vec::new(),
            Event::Key(key) => self.pressed(key),
            Event::Closed => {
                self.closing = true;
                self.quit_if_closing()
            }
            Event::Quit | Event::Broken => vec![Action::Quit],
        }
    }

    /// Whether this order is about the current answers.
    pub fn awaits(&self, order: u64) -> bool {
        let awaited = self.order.as_ref().map(|order| order.number);
        awaited == Some(order)
    }

    /// What is shown, if it is not the table of everything.
    pub fn item(&self) -> Option<&Item> {
        self.shown.map(|at| &self.items[at])
    }

    /// Whether an item has a verdict.
    pub fn has_verdict(&self, item: &Item) -> bool {
        self.stamps.contains_key(item)
    }

    /// How long after its save an item was judged.
    pub fn after_save(&self, item: &Item) -> Option<Duration> {
        self.stamps.get(item)?.after_save
    }

    /// What the student's code printed when an item was judged.
    pub fn printed(&self, item: &Item) -> &str {
        let stamp = self.stamps.get(item);
        stamp.map_or("", |stamp| &stamp.printed)
    }

    /// An item's verdict, if it is a task that has one.
    pub fn task(&self, item: &Item) -> Option<&TaskOutcome> {
        let is_it = |task: &&TaskOutcome| matches!(item, Item::Task(name) if *name == task.name);
        self.known.outcome.tasks.iter().find(is_it)
    }

    /// Whether the judge is at work.
    pub fn is_judging(&self) -> bool {
        self.order.is_some()
    }

    /// Whether an item has all its points.
    pub fn is_full(&self, item: &Item) -> bool {
        match item {
            Item::Task(_) => self.task(item).is_some_and(TaskOutcome::passes),
            Item::Scenes => {
                let mut scenes = self.known.outcome.scenes.iter();
                self.has_verdict(item) && scenes.all(|scene| scene.outcome.passes())
            }
        }
    }

    /// Whether an item waits for an answer that is still missing: its own, or one that it needs.
    pub fn is_open(&self, item: &Item) -> bool {
        match item {
            Item::Task(_) => self.task(item).is_some_and(TaskOutcome::is_unanswered),
            Item::Scenes => false,
        }
    }

    /// How long the answer that is being judged has waited since it was saved.
    pub fn waiting(&self, examination: &Examination, at: Instant) -> Option<Duration> {
        let task = examination.outcome.tasks.first()?;
        let saved = self.saved.get(&Item::Task(task.name.clone()))?;
        Some(at.saturating_duration_since(*saved))
    }

    /// What to show if everything is right.
    pub fn finish(&self) -> Option<Finish> {
        Finish::of(&self.known, &self.assignment, &self.again.part)
    }

    /// Points earned, of all that can be earned.
    pub fn points(&self) -> (u32, u32) {
        (self.known.outcome.points.unwrap_or_default(), self.possible)
    }

    /// Sets the message about what has happened.
    pub fn say(&mut self, what: String) {
        self.notice = Some(what);
    }

    /// Scrolls to the beginning of the verdict and hides the hints.
    fn top(&mut self) {
        self.hints = 0;
        self.scroll = 0;
        self.help = false;
    }

    /// Whether an item's verdict is about the current answers, all of them.
    fn is_current(&self, item: &Item) -> bool {
        let stamp = self.stamps.get(item);
        stamp.is_some_and(|stamp| stamp.generation == self.generation)
    }

    fn not_current(&self) -> Vec<Item> {
        let items = self.items.iter();
        let stale = items.filter(|item| !self.is_current(item));
        stale.cloned().collect()
    }

    fn forget(&mut self, item: &Item) {
        self.stamps.remove(item);
        match item {
            Item::Task(name) => {
                let tasks = &mut self.known.outcome.tasks;
                tasks.retain(|task| task.name != *name);
            }
            Item::Scenes => {
                self.known.outcome.scenes.clear();
                self.known.films.clear();
            }
        }
        self.known.outcome.add_up();
    }

    fn ask_again(&mut self, items: Vec<Item>) -> Vec<Action> {
        items.iter().for_each(|item| self.forget(item));
        self.problem = None;
        self.ask(items)
    }

    /// Orders these items first, and then every task that has no verdict.
    fn ask(&mut self, first: Vec<Item>) -> Vec<Action> {
        let mut items = first;
        for item in &self.items {
            let is_open = *item != Item::Scenes && !self.has_verdict(item);
            if is_open && !items.contains(item) {
                items.push(item.clone());
            }
        }
        if items.is_empty() {
            return Vec::new();
        }
        self.orders += 1;
        let order = Order {
            number: self.orders,
            items,
            submission: Arc::clone(&self.submission),
        };
        self.order = Some(order.clone());
        self.asking = None;
        vec![Action::Ask(order)]
    }
}

/// The points of the watched tasks, and of the scenes if they are watched.
fn possible(course: &Course) -> u32 {
    let is_watched = |task: &&Task| course.tasks.is_empty() || course.tasks.contains(&task.name);
    let tasks = course.assignment.tasks.iter().filter(is_watched);
    let groups = tasks.flat_map(|task| &task.points);
    let scenes = course.goldens.scenes.iter().map(|scene| scene.worth);
    let scenes: u32 = if course.tasks.is_empty() {
        scenes.sum()
    } else {
        0
    };
    groups.map(|points| points.worth).sum::<u32>() + scenes
}

#[cfg(test)]
pub(in crate::watch) mod tests;
