//! What an explanation says about a question, line by line.

use serde::{Deserialize, Serialize};

/// One line of an explanation: a label such as "expected", and what belongs to it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fact {
    /// What it is about, in a word.
    pub label: String,
    /// What is said about it. There may be several lines.
    pub text: String,
}

impl Fact {
    /// A fact with this label and text.
    pub fn new(label: impl Into<String>, text: impl Into<String>) -> Fact {
        Fact {
            label: label.into(),
            text: text.into(),
        }
    }
}
