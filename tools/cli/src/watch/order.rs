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
    /// The name for people.
    pub fn name(&self) -> &str {
        match self {
            Item::Task(name) => name,
            Item::Scenes => "scenes",
        }
    }
}

/// An order to judge some items of some answers, in this sequence. A new order cancels the one
/// before.
#[derive(Clone, Debug)]
pub struct Order {
    /// The order's number. Results of older orders are stale.
    pub number: u64,
    pub items: Vec<Item>,
    pub submission: Arc<Submission>,
}
