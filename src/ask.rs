//! The asker's side: starts a submission, sends it a job, and reads its answers without
//! trusting them.
//!
//! What comes back is limited in time and size, must be well formed, and must answer every question
//! once. It is only data to be judged, and is never executed.

mod ending;
mod reply;
mod transport;

use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use crate::job::{CHUNK, Job, MOST_PANIC_TEXT, Message};
use crate::serve::{ENOUGH_ERRORS, ENOUGH_OUTPUT};
pub use ending::{Death, Ending};
pub use reply::Reply;
use transport::Exchange;
use transport::Next;

/// How long to wait for answers.
#[derive(Clone, Debug)]
pub struct Limit {
    /// The limit for all answers together, by the submission's [`Clock`]. On the wall clock, it is
    /// [`BUSY`] times as long.
    pub wall: Duration,
    /// The limit for the time since the submission last sent anything, by its clock. It ends an
    /// endless loop long before `wall` is over.
    pub silence: Duration,
    /// Raised when the answer is no longer needed.
    pub stop: Stop,
}

/// How much time a process has had so far. The clock may stand still while the machine is busy with
/// other work, because a process that gets no processor time can't answer.
pub type Clock = Box<dyn FnMut() -> Duration>;

/// A clock that never stands still.
pub fn wall_clock() -> Clock {
    let start = Instant::now();
    Box::new(move || start.elapsed())
}

/// A flag that ends an exchange from another thread. Its clones are the same flag.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends every exchange that watches this flag, within 50 ms.
    pub fn raise(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it has been raised.
    pub fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl From<Duration> for Limit {
    fn from(wall: Duration) -> Limit {
        Limit {
            wall,
            silence: wall,
            stop: Stop::default(),
        }
    }
}

/// A busy machine may give a program as little as a twentieth of its time.
pub const BUSY: u32 = 20;

/// How often a waiting exchange looks at its [`Stop`].
const PULSE: Duration = Duration::from_millis(50);

/// The most output that is kept. The rest is read and thrown away.
pub const MOST_PRINTED: usize = 64 * 1024;

/// The longest message that is accepted. In a chunk, a hit takes about 45 bytes and a tree up to 4
/// KiB, so no message of ours is longer.
const MOST_MESSAGE: usize = CHUNK * 4096 + 4 * MOST_PANIC_TEXT;

/// Runs `command`, a built submission, on `job`, for a limited time.
///
/// Passes the number of answers so far to `progress`. The process has ended when this returns.
///
/// # Errors
/// If the program cannot be started, or its answer is no longer needed. The reply reports
/// anything that goes wrong later.
pub fn ask(
    command: Command,
    job: &Job,
    limit: impl Into<Limit>,
    progress: &mut dyn FnMut(usize),
) -> io::Result<Reply> {
    ask_watched(command, job, limit.into(), progress, &mut |_| wall_clock())
}

/// Like [`ask`], but first passes the process id to `started`, so that the caller can
/// watch the process and kill it. It returns the clock for its limits.
///
/// # Errors Like [`ask`].
pub fn ask_watched(
    mut command: Command,
    job: &Job,
    limit: Limit,
    progress: &mut dyn FnMut(usize),
    started: &mut dyn FnMut(u32) -> Clock,
) -> io::Result<Reply> {
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let spawned = Instant::now();
    let patience = limit.wall.min(limit.silence);
    let mut exchange = Exchange::start(command, limit.clone())?;
    let clock = started(exchange.child.id());
    let out = drain(exchange.child.stdout.take(), exchange.tell(ENOUGH_OUTPUT));
    let err = drain(exchange.child.stderr.take(), exchange.tell(ENOUGH_ERRORS));

    let mut reply = Reply::before(job);
    let ended = exchange.converse(job, clock, MOST_MESSAGE, &mut |message| {
        if message == Message::Started && reply.start.is_none() {
            reply.start = Some(spawned.elapsed());
            return Ok(Next::Receive);
        }
        let next = reply.take(job, message)?;
        if !matches!(next, Next::Send(_)) {
            progress(job.len() - reply.missing);
        }
        Ok(next)
    });
    let is_late = exchange.is_late();
    if ended.as_ref().is_err_and(is_timeout) && !limit.stop.is_raised() {
        let at = exchange.still_at(MOST_MESSAGE);
        reply.still_at = at.filter(|index| reply.answers.get(*index) == Some(&None));
    }
    let status = end(&mut exchange.child);
    if limit.stop.is_raised() {
        return Err(io::Error::other("its answer is no longer needed"));
    }
    reply.printed = printed(out) + &printed(err);
    if reply.ending == Ending::Complete && reply.missing > 0 {
        reply.ending = match ended {
            Err(error) if is_timeout(&error) && is_late => Ending::TimedOut(limit.wall),
            Err(error) if is_timeout(&error) => Ending::TimedOut(patience),
            Err(error) if is_broken(&error) => Ending::Died(Death::of(status)),
            Err(error) => Ending::Garbled(error.to_string()),
            Ok(()) => Ending::Died(Death::of(status)),
        };
    }
    Ok(reply)
}

/// Ends a process that may have ended already.
fn end(child: &mut Child) -> Option<ExitStatus> {
    // A process that closed its stream is about to exit, and its status tells why.
    for _ in 0..20 {
        if let Ok(Some(status)) = child.try_wait() {
            return Some(status);
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    let _already_gone = child.kill();
    child.wait().ok()
}

fn is_timeout(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut
    )
}

fn is_broken(error: &io::Error) -> bool {
    use io::ErrorKind::{BrokenPipe, ConnectionReset, UnexpectedEof};
    matches!(error.kind(), BrokenPipe | ConnectionReset | UnexpectedEof)
}

/// Reads a pipe to its end on a separate thread, but keeps only the beginning. Calls `enough` once
/// it has as much as is kept.
fn drain(
    pipe: Option<impl Read + Send + 'static>,
    enough: impl FnOnce() + Send + 'static,
) -> Receiver<Vec<u8>> {
    let (sender, receiver) = mpsc::channel();
    if let Some(mut pipe) = pipe {
        std::thread::spawn(move || {
            let mut kept = Vec::new();
            let beginning = (&mut pipe).take(MOST_PRINTED as u64).read_to_end(&mut kept);
            if kept.len() == MOST_PRINTED {
                enough();
            }
            let rest = beginning.and_then(|_| io::copy(&mut pipe, &mut io::sink()));
            // A broken pipe ends the text. If nobody waits for the text any more, sending it fails,
            // which does no harm.
            let _ = (rest, sender.send(kept));
        });
    }
    receiver
}

/// What was printed; nothing if a process left behind still holds the pipe.
fn printed(pipe: Receiver<Vec<u8>>) -> String {
    // On a busy machine, this may take a while. Wait for the text, because nothing else says why a
    // process aborted.
    let bytes = pipe
        .recv_timeout(Duration::from_secs(2))
        .unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests;
