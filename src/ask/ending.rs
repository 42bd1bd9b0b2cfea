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
    /// The submission's overall time was up before this was asked, or before all of it was
    /// answered.
    OutOfTime(Duration),
    /// The process took more memory than its limit, which is given in bytes.
    OutOfMemory(u64),
    /// The process ended early.
    Died(Death),
    /// It sent something that is not an answer; the text says what.
    Garbled(String),
}

/// How a process ended before it had answered.
#[derive(Clone, Debug, PartialEq)]
pub enum Death {
    /// This signal killed it.
    Signal(i32),
    /// It exited with this code.
    Exit(i32),
    /// The cause is unknown.
    Lost,
}

impl Death {
    /// How a process ended, or [`Death::Lost`] if nobody knows.
    pub fn of(status: Option<ExitStatus>) -> Death {
        let Some(status) = status else {
            return Death::Lost;
        };
        #[cfg(unix)]
        let signal = std::os::unix::process::ExitStatusExt::signal(&status);
        #[cfg(not(unix))]
        let signal = None;
        match (signal, status.code()) {
            (Some(signal), _) => Death::Signal(signal),
            (None, Some(code)) => Death::Exit(code),
            (None, None) => Death::Lost,
        }
    }

    /// The signal that killed it, or may have: bubblewrap, like a shell, turns signal n into the
    /// code 128 + n, but a program may also choose that code itself.
    pub fn possible_signal(&self) -> Option<i32> {
        match *self {
            Death::Signal(signal) => Some(signal),
            Death::Exit(code @ 129..=159) => Some(code - 128),
            Death::Exit(_) | Death::Lost => None,
        }
    }

    /// Whether SIGKILL ended it, or may have. The system sends this signal when memory runs out,
    /// even to a process that has hardly any.
    pub fn may_be_kill(&self) -> bool {
        const SIGKILL: i32 = 9;
        self.possible_signal() == Some(SIGKILL)
    }
}
