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
    /// The submission has no function for this kind of question.
    Unregistered(Unregistered),
    /// Time was up before every question was answered.
    TimedOut(Duration),
    /// The process took more memory than it may: how many bytes it may.
    OutOfMemory(u64),
    /// The process ended early.
    Died(Death),
    /// It sent something that is not an answer; the text says what.
    Garbled(String),
}

impl Ending {
    /// How a process died, told by its exit status and what it printed.
    pub(super) fn died(status: Option<ExitStatus>, printed: &str) -> Ending {
        Ending::Died(Death::of(status, printed))
    }
}

/// How a process ended before it had answered.
#[derive(Clone, Debug, PartialEq)]
pub enum Death {
    /// Its stack overflowed.
    StackOverflow,
    /// The kernel ended it for the processor time it took.
    OutOfProcessorTime,
    /// This signal killed it.
    Signal(i32),
    /// It exited with this code.
    Exit(i32),
    /// It was killed; this is all that the system tells.
    Killed(String),
    /// The cause is unknown.
    Lost,
}

impl Death {
    /// A stack overflow is known by what Rust itself prints: the signal is that of any
    /// process that aborts.
    fn of(status: Option<ExitStatus>, printed: &str) -> Death {
        if printed.contains("has overflowed its stack") {
            return Death::StackOverflow;
        }
        let Some(status) = status else {
            return Death::Lost;
        };
        match status.code() {
            // As a shell, and bubblewrap, report a signal; 24 is SIGXCPU.
            Some(152) => Death::OutOfProcessorTime,
            Some(code @ 129..=159) => Death::Signal(code - 128),
            Some(code) => Death::Exit(code),
            None => Death::Killed(status.to_string()),
        }
    }
}
