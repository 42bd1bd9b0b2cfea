//! Results as JSON documents for scripts.
//!
//! [`Outcome`](pinhole_course::outcome::Outcome) is serialised as it is. The functions here
//! write documents of other commands, which use the same words.

use pinhole::judge::{Refusal, Verdict};
use pinhole_course::diagnosis::{Diagnosis, or_null};
use pinhole_course::outcome::FilmOutcome;
use serde::Serialize;
use serde_json::Value;

/// A value as a document.
pub fn document(what: &impl Serialize) -> Value {
    serde_json::to_value(what).expect("our documents have plain keys")
}

/// A diagnosis; `null` if no known belief explains the answers.
pub fn diagnosis(diagnosis: &Diagnosis) -> Value {
    or_null::serialize(diagnosis, serde_json::value::Serializer)
        .expect("our documents have plain keys")
}

/// A verdict or refusal, as `diff --json` prints it.
pub fn verdict(verdict: &Result<Verdict, Refusal>) -> Value {
    document(&FilmOutcome::from(verdict))
}
