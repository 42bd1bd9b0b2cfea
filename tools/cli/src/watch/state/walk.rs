//! Moves between items with keys.

use super::{Action, State};
use crate::watch::hints;
use crate::watch::keys::Key;
use crate::watch::order::{Item, Order};

impl State {
    pub(super) fn pressed(&mut self, key: Key) -> Vec<Action> {
        if !matches!(key, Key::Scroll(_)) {
            self.notice = None;
        }
        let back_from_help = std::mem::take(&mut self.help);
        match key {
            Key::Help => self.help = !back_from_help,
            Key::Hint => {
                self.hints = (self.hints + 1).min(hints::of(self).len());
                // Hints come after the verdict. The screen stops at the end of the text.
                self.scroll = usize::MAX;
            }
            Key::Scroll(lines) => self.scroll = self.scroll.saturating_add_signed(lines),
            Key::Report => {
                let missing = self.not_current();
                if missing.is_empty() {
                    return vec![Action::Report];
                }
                self.report_wanted = true;
                self.say("the report will be ready once everything is judged".into());
                return self.ask_again(missing);
            }
            Key::Quit => return vec![Action::Quit],
            Key::Next => return self.visit(self.next()),
            Key::Previous => {
                let count = self.items.len();
                return self.visit(self.shown.map_or(count - 1, |at| (at + count - 1) % count));
            }
            Key::Scenes => {
                if let Some(at) = self.items.iter().position(|item| *item == Item::Scenes) {
                    return self.visit(at);
                }
                self.say("scenes are not judged, because you chose tasks with --task".into());
            }
            Key::Everything => {
                self.settled = true;
                self.shown = None;
                self.top();
                return self.ask_again(self.items.clone());
            }
            Key::RepeatCommands => {
                let again = self
                    .item()
                    .map_or(self.items.clone(), |item| vec![item.clone()]);
                self.top();
                return self.ask_again(again);
            }
        }
        Vec::new()
    }

    /// If the shown task passes, the first one that lacks points. Otherwise, the next one.
    fn next(&self) -> usize {
        let missing = self.items.iter().position(|item| !self.is_full(item));
        match self.shown {
            Some(at) if !self.is_full(&self.items[at]) => (at + 1) % self.items.len(),
            Some(at) => missing.unwrap_or((at + 1) % self.items.len()),
            None => missing.unwrap_or(0),
        }
    }

    /// Shows an item, and judges it again if other answers have changed since.
    fn visit(&mut self, at: usize) -> Vec<Action> {
        self.settled = true;
        self.shown = Some(at);
        self.top();
        let item = self.items[at].clone();
        let ordered = |order: &Order| order.items.contains(&item);
        if self.is_current(&item) || self.order.as_ref().is_some_and(ordered) {
            return Vec::new();
        }
        self.ask_again(vec![item])
    }

    pub(super) fn go_to(&mut self, item: Item) {
        self.shown = self.items.iter().position(|known| *known == item);
    }
}
