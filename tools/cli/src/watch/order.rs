//! What the judge is to do next.

use std::sync::Arc;

use pinhole_course::submission::Submission;

/// What can be judged by itself.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Item {
    /// One answer.
    Task(String),
    /// All scenes, by all answers together.
    Scenes,
}

impl Item {
    /// As people say it.
    pub fn name(&self) -> &str {
        match self {
            Item::Task(name) => name,
            Item::Scenes => "scenes",
        }
    }
}

/// These items of these answers, in this sequence. A new order cancels the last.
#[derive(Clone, Debug)]
pub struct Order {
    /// Its number; results of an older one are stale.
    pub number: u64,
    pub items: Vec<Item>,
    pub submission: Arc<Submission>,
}
