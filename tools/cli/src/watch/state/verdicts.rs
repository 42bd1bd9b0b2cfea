//! Handles saves and verdicts. Only verdicts on the newest answers count.

use std::sync::Arc;
use std::time::Instant;

use super::{Action, Stamp, State};
use crate::watch::order::Item;
use pinhole_course::outcome::{Examination, GroupPicture, Outcome};
use pinhole_course::submission::Submission;

impl State {
    pub(super) fn saved(
        &mut self,
        submission: Submission,
        tasks: &[String],
        at: Instant,
    ) -> Vec<Action> {
        self.problem = None;
        self.submission = Arc::new(submission);
        let is_saved = |item: &Item| matches!(item, Item::Task(name) if tasks.contains(name));
        let saved: Vec<Item> = self
            .items
            .iter()
            .filter(|item| is_saved(item))
            .cloned()
            .collect();
        self.generation += u64::from(!tasks.is_empty());
        self.forget(&Item::Scenes);
        for item in &saved {
            self.forget(item);
            self.saved.insert(item.clone(), at);
        }
        // Follow the student to the file that they saved.
        if let Some(first) = saved.first()
            && !self.item().is_some_and(is_saved)
        {
            self.go_to(first.clone());
            self.say(format!("you saved {0}.rs; now showing {0}", first.name()));
        }
        if !saved.is_empty() {
            self.report_wanted = false;
            self.settled = true;
            self.top();
        }
        self.ask(saved)
    }

    pub(super) fn judged(&mut self, examination: Examination, at: Instant) {
        let Examination {
            outcome,
            films,
            pictures,
        } = examination;
        let Outcome {
            tasks,
            scenes,
            printed,
            ..
        } = outcome;
        for task in tasks {
            self.stamp(Item::Task(task.name.clone()), at, printed.clone());
            let is_other = |picture: &GroupPicture| picture.task != task.name;
            self.known.pictures.retain(is_other);
            self.known.outcome.tasks.push(task);
        }
        self.known.pictures.extend(pictures);
        let place = |name: &str| self.items.iter().position(|item| item.name() == name);
        let known = &mut self.known.outcome.tasks;
        known.sort_by_key(|task| place(&task.name));
        if !scenes.is_empty() {
            self.stamp(Item::Scenes, at, printed);
            self.known.outcome.scenes = scenes;
            self.known.films = films;
        }
        self.known.outcome.add_up();
        if !self.settled {
            let missing = self.items.iter().position(|item| !self.is_full(item));
            self.shown = Some(missing.unwrap_or(self.items.len() - 1));
            self.settled = missing.is_some_and(|at| self.has_verdict(&self.items[at]));
        }
    }

    fn stamp(&mut self, item: Item, at: Instant, printed: String) {
        self.forget(&item);
        let saved = self.saved.remove(&item);
        let stamp = Stamp {
            generation: self.generation,
            after_save: saved.map(|saved| at.saturating_duration_since(saved)),
            printed,
        };
        self.stamps.insert(item, stamp);
    }

    /// The judge has finished its order.
    pub(super) fn finished(&mut self) -> Vec<Action> {
        self.rest();
        if self.report_wanted {
            self.report_wanted = false;
            return vec![Action::Report];
        }
        let is_task = |item: &&Item| **item != Item::Scenes;
        let tasks: Vec<&Item> = self.items.iter().filter(is_task).collect();
        if tasks.iter().all(|task| self.is_full(task)) && self.items.contains(&Item::Scenes) {
            // Only the scenes are left. But an answer may call another one, so first renew verdicts
            // that were reached with older versions of the other answers.
            let stale = self.not_current();
            if !stale.is_empty() {
                self.go_to(Item::Scenes);
                self.say("every task passes; now the scenes".into());
                return self.ask(stale);
            }
        }
        if self.finish().is_some() {
            self.notice = None;
        }
        self.settled = true;
        self.quit_if_closing()
    }

    pub(super) fn rest(&mut self) {
        self.order = None;
        self.asking = None;
    }

    pub(super) fn quit_if_closing(&self) -> Vec<Action> {
        match self.closing && self.order.is_none() {
            true => vec![Action::Quit],
            false => Vec::new(),
        }
    }
}
