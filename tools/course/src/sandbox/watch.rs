//! Watchdog: kills a process tree that exceeds its limits. It is needed because the kernel limits
//! each process separately.

use std::fmt;
use std::sync::mpsc::Sender;
use std::thread::JoinHandle;
use std::time::Duration;

/// The limit that was exceeded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ExceededLimit {
    /// Seconds of processor time.
    Cpu(Duration),
    /// Bytes in use.
    Memory(u64),
    /// Time in which nothing ran.
    Idle(Duration),
}

impl fmt::Display for ExceededLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ExceededLimit::Cpu(most) => {
                write!(f, "more than {} s of processor time", most.as_secs_f64())
            }
            ExceededLimit::Memory(most) => write!(f, "more than {} MiB of memory", most >> 20),
            ExceededLimit::Idle(most) => {
                write!(f, "it was idle for {} s", most.as_secs_f64())
            }
        }
    }
}

/// A watchdog that runs until it is stopped.
pub struct Watch {
    looking: Option<(Sender<()>, JoinHandle<Option<ExceededLimit>>)>,
}

impl Watch {
    /// A watchdog without limits.
    pub fn nothing() -> Watch {
        Watch { looking: None }
    }

    /// Stops watching, and returns the limit that was exceeded, if any.
    pub fn stop(self) -> Option<ExceededLimit> {
        let (enough, thread) = self.looking?;
        drop(enough);
        thread.join().ok().flatten()
    }
}

#[cfg(target_os = "linux")]
mod looking {
    use std::sync::mpsc::{self, RecvTimeoutError};
    use std::time::Instant;

    use rustix::process::{Pid, PidfdFlags, Signal, pidfd_open, pidfd_send_signal};

    use super::*;
    use crate::sandbox::{Limits, tree};

    /// The time between two checks. Filling a gigabyte takes longer.
    const PAUSE: Duration = Duration::from_millis(20);

    /// How long a tree has been idle.
    struct Idleness {
        since: Instant,
        /// How many times we looked in that time. If we look too seldom, the time alone proves
        /// nothing.
        looks: u32,
        cpu: Duration,
    }

    impl Idleness {
        fn new(cpu: Duration) -> Idleness {
            Idleness {
                since: Instant::now(),
                looks: 0,
                cpu,
            }
        }

        /// Whether the tree has been idle for too long. At least half of the usual number of looks
        /// in that time must have found it idle.
        fn exceeds(&mut self, most: Duration, used: &tree::ResourceUsage) -> bool {
            match used.is_busy || used.cpu != self.cpu {
                true => *self = Idleness::new(used.cpu),
                false => self.looks += 1,
            }
            PAUSE * 2 * self.looks >= most && self.since.elapsed() >= most
        }
    }

    impl Watch {
        /// Kills `pid` when it and its descendants exceed the limits.
        pub fn tree(pid: u32, limits: Limits) -> Watch {
            let (enough, told) = mpsc::channel::<()>();
            let thread = std::thread::spawn(move || {
                let first = Pid::from_raw(i32::try_from(pid).ok()?)?;
                // Opened at the start, so that it can't refer to a later process with the same id.
                let handle = pidfd_open(first, PidfdFlags::empty()).ok()?;
                let mut idleness = Idleness::new(Duration::ZERO);
                loop {
                    if told.recv_timeout(PAUSE) != Err(RecvTimeoutError::Timeout) {
                        return None;
                    }
                    let used = tree::used_by(pid);
                    let exceeded = if used.memory > limits.memory {
                        ExceededLimit::Memory(limits.memory)
                    } else if used.cpu > limits.cpu {
                        ExceededLimit::Cpu(limits.cpu)
                    } else if idleness.exceeds(limits.idle, &used) {
                        ExceededLimit::Idle(limits.idle)
                    } else {
                        continue;
                    };
                    // The process may have ended by now, but it did exceed the limit.
                    let _ended = pidfd_send_signal(&handle, Signal::KILL);
                    return Some(exceeded);
                }
            });
            Watch {
                looking: Some((enough, thread)),
            }
        }
    }
}
