//! Why a submission sent nothing more.

use std::process::ExitStatus;
use std::time::Duration;

use crate::job::Panic;
use crate::kind::Unregistered;

/// Why a submission sent nothing more.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// Every question is answered.
    Complete,
    /// The student's code panicked.
    Panicked(Panic),
    /// It has no function for what was asked.
    Unregistered(Unregistered),
    /// Time was up before every question was answered.
    TimedOut(Duration),
    /// The process took more memory than it may: how many bytes it may.
    OutOfMemory(u64),
    /// The process ended early: how, in words.
    Died(String),
    /// It sent something that is no answer: what, in words.
    Garbled(String),
}

impl Ending {
    /// The end of a process that left early, by its status and what it printed.
    pub(super) fn died(status: Option<ExitStatus>, printed: &str) -> Ending {
        Ending::Died(in_words(status, printed))
    }
}

/// What is said of a process that the kernel ended for the processor time it took.
pub const TIME_WAS_UP: &str = "its processor time was up";

fn in_words(status: Option<ExitStatus>, printed: &str) -> String {
    if printed.contains("has overflowed its stack") {
        return "its stack overflowed: does a function call itself without end?".into();
    }
    let Some(status) = status else {
        return "its process was lost".into();
    };
    match status.code() {
        // As a shell, and bubblewrap, report a signal.
        Some(code @ 129..=159) => {
            let signal = match code - 128 {
                4 => "an illegal instruction",
                6 => "it aborted itself",
                7 | 11 => "it touched memory that is not its own",
                9 => "SIGKILL",
                24 => TIME_WAS_UP,
                25 => "it wrote a file that is too long",
                31 => "a forbidden system call",
                _ => {
                    return format!(
                        "it was killed (signal {}) before it had answered",
                        code - 128
                    );
                }
            };
            format!("it was killed ({signal}) before it had answered")
        }
        Some(code) => format!("it exited with code {code} before it had answered"),
        None => format!("it was killed ({status}) before it had answered"),
    }
}
