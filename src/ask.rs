//! The asker's side: starts a submission, sends it a job, and reads its answers without
//! trusting them.
//!
//! What comes back is bounded in time and size, must be well formed, must answer
//! every question once, and is only ever data to be judged.

mod ending;
mod transport;

use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use crate::camera::Resolution;
use crate::film::{Film, TESTS};
use crate::job::{CHUNK, Job, MOST_PANIC_TEXT, Message};
use crate::kind::Answer;
use crate::ray::{Hit, Ray};
use crate::serve::{ENOUGH_ERRORS, ENOUGH_OUTPUT};
pub use ending::{Death, Ending};
use transport::{Exchange, Next};

/// The reply to one job.
#[derive(Clone, Debug)]
pub struct Reply {
    /// The answers, in the job's order; `None` where none came.
    pub answers: Vec<Option<Answer>>,
    missing: usize,
    /// How many tests each answer took, if they are counted; otherwise empty.
    pub tests: Vec<u32>,
    /// How it ended.
    pub ending: Ending,
    /// How long it took to start: until the first answers came.
    pub start: Duration,
    /// What the student's code printed, standard output and error, cut at
    /// [`MOST_PRINTED`] bytes each.
    pub printed: String,
}

/// How long to wait for answers.
#[derive(Clone, Debug)]
pub struct Limit {
    /// The limit for all answers together.
    pub wall: Duration,
    /// The limit for the time since the submission last sent anything. It ends an endless loop
    /// long before `wall` is over.
    pub silence: Duration,
    /// Raised when the answer is no longer wanted.
    pub stop: Stop,
}

/// A flag that ends an exchange from another thread. Its clones are the same flag.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends every exchange that watches this flag, within 50 ms.
    pub fn raise(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it was raised.
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

/// How often a waiting exchange looks at its [`Stop`].
const PULSE: Duration = Duration::from_millis(50);

/// The most output that is kept. The rest is read and thrown away.
pub const MOST_PRINTED: usize = 64 * 1024;

/// The longest message that is accepted. A chunk of hits takes about 45 bytes for each, one of
/// trees up to 4 KiB, so no message of ours is longer.
const MOST_MESSAGE: usize = CHUNK * 4096 + 4 * MOST_PANIC_TEXT;

/// Runs `command`, a built submission, on `job` for a limited time.
///
/// `progress` is told the number of answers so far. The process is gone when this
/// returns.
///
/// # Errors
/// If the program cannot be started, or its answer is no longer wanted. Whatever goes
/// wrong later is in the reply.
pub fn ask(
    command: Command,
    job: &Job,
    limit: impl Into<Limit>,
    progress: &mut dyn FnMut(usize),
) -> io::Result<Reply> {
    ask_watched(command, job, limit.into(), progress, &mut |_| {})
}

/// Like [`ask`], but first passes the process id to `started`, so that the caller can
/// watch the process and kill it.
///
/// # Errors
/// As [`ask`].
pub fn ask_watched(
    mut command: Command,
    job: &Job,
    limit: Limit,
    progress: &mut dyn FnMut(usize),
    started: &mut dyn FnMut(u32),
) -> io::Result<Reply> {
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let spawned = Instant::now();
    let patience = limit.wall.min(limit.silence);
    let mut exchange = Exchange::start(command, limit.clone())?;
    started(exchange.child.id());
    let out = drain(exchange.child.stdout.take(), exchange.tell(ENOUGH_OUTPUT));
    let err = drain(exchange.child.stderr.take(), exchange.tell(ENOUGH_ERRORS));

    let mut reply = Reply::before(job);
    let ended = exchange.converse(job, MOST_MESSAGE, &mut |message| {
        if reply.start.is_zero() {
            reply.start = spawned.elapsed();
        }
        let next = reply.take(job, message)?;
        if !matches!(next, Next::Send(_)) {
            progress(job.len() - reply.missing);
        }
        Ok(next)
    });
    let status = end(&mut exchange.child);
    if limit.stop.is_raised() {
        return Err(io::Error::other("its answer is no longer wanted"));
    }
    reply.printed = printed(out) + &printed(err);
    if reply.ending == Ending::Complete && reply.missing > 0 {
        reply.ending = match ended {
            Err(error) if is_timeout(&error) && exchange.is_late() => Ending::TimedOut(limit.wall),
            Err(error) if is_timeout(&error) => Ending::TimedOut(patience),
            Err(error) if is_broken(&error) => Ending::died(status, &reply.printed),
            Err(error) => Ending::Garbled(error.to_string()),
            Ok(()) => Ending::died(status, &reply.printed),
        };
    }
    Ok(reply)
}

impl Reply {
    /// The reply to a job before anything came.
    pub(crate) fn before(job: &Job) -> Reply {
        Reply {
            answers: vec![None; job.len()],
            missing: job.len(),
            tests: vec![0; if job.is_counted() { job.len() } else { 0 }],
            ending: Ending::Complete,
            start: Duration::ZERO,
            printed: String::new(),
        }
    }

    /// The reply to a job that is not asked any more, because of how others ended.
    pub fn unasked(job: &Job, ending: Ending) -> Reply {
        Reply {
            ending,
            ..Reply::before(job)
        }
    }

    /// The film of a job of hits, missing answers as misses; `None` if it has others.
    pub fn hits(&self) -> Option<Vec<Option<Hit>>> {
        let hit = |answer: &Option<Answer>| match answer {
            Some(Answer::Hit(hit)) => Some(*hit),
            Some(_) => None,
            None => Some(None),
        };
        self.answers.iter().map(hit).collect()
    }

    /// The rays of a job of rays, if every one came.
    pub fn rays(&self) -> Option<Vec<Ray>> {
        self.all(|answer| match answer {
            Answer::Ray(ray) => Some(*ray),
            _ => None,
        })
    }

    /// Whether every question is answered.
    pub fn is_whole(&self) -> bool {
        self.missing == 0
    }

    /// The answers as a film: of rays, boxes or trees if every one is such, of hits
    /// otherwise. Tests that were counted have a channel of their own.
    pub fn film(&self, resolution: Resolution) -> Film {
        let film = match self.answers.first() {
            Some(Some(Answer::Ray(_))) => self.rays().map(|rays| Film::of_rays(resolution, &rays)),
            Some(Some(Answer::Box(_))) => {
                let boxes = self.all(|answer| match answer {
                    Answer::Box(bounds) => Some(*bounds),
                    _ => None,
                });
                boxes.map(|boxes| Film::of_boxes(resolution, &boxes))
            }
            Some(Some(Answer::Tree(_))) => {
                let trees = self.all(|answer| match answer {
                    Answer::Tree(measures) => Some(*measures),
                    _ => None,
                });
                trees.map(|trees| Film::of_trees(resolution, &trees))
            }
            _ => None,
        };
        let film = film.unwrap_or_else(|| {
            let misses = || vec![None; self.answers.len()];
            Film::of_hits(resolution, &self.hits().unwrap_or_else(misses))
        });
        match self.tests.is_empty() {
            true => film,
            false => film.with(
                TESTS,
                self.tests.iter().map(|&count| count as f32).collect(),
            ),
        }
    }

    /// What `pick` picks of every answer, if all are there and have it.
    fn all<T>(&self, pick: impl Fn(&Answer) -> Option<T>) -> Option<Vec<T>> {
        let answers = self.answers.iter();
        answers.map(|answer| pick(answer.as_ref()?)).collect()
    }

    /// The replies to the jobs of these lengths that were asked as one.
    ///
    /// # Panics
    /// If the lengths do not add up to the number of answers.
    pub fn split(mut self, lengths: impl Iterator<Item = usize>) -> Vec<Reply> {
        let mut parts = Vec::new();
        for length in lengths {
            let rest = self.answers.split_off(length);
            let answers = std::mem::replace(&mut self.answers, rest);
            let missing = answers.iter().filter(|answer| answer.is_none()).count();
            let later = self.tests.split_off(length.min(self.tests.len()));
            let tests = std::mem::replace(&mut self.tests, later);
            parts.push(Reply {
                answers,
                missing,
                tests,
                ending: self.ending.clone(),
                start: self.start,
                printed: String::new(),
            });
        }
        assert!(self.answers.is_empty(), "the parts leave answers over");
        parts
    }

    /// Stores one message, and says what comes next.
    fn take(&mut self, job: &Job, message: Message) -> Result<Next, String> {
        match message {
            Message::Test(index, test) => {
                let questions = job.questions().filter(|_| index < self.tests.len());
                let questions = questions.ok_or("it asked for a test of no question")?;
                self.tests[index] += 1;
                if self.tests[index] as usize > questions.most_tests(index) {
                    return Err("it asked for ten times as many tests as there are".into());
                }
                let result = questions.test(index, test);
                Ok(Next::Send(
                    result.ok_or("it asked to test what is not in the tree")?,
                ))
            }
            Message::Panicked(mut panic) => {
                panic
                    .message
                    .truncate(panic.message.floor_char_boundary(MOST_PANIC_TEXT));
                panic.index = panic.index.min(self.answers.len().saturating_sub(1));
                self.ending = Ending::Panicked(panic);
                Ok(Next::End)
            }
            Message::Unregistered(kind) => {
                self.ending = Ending::Unregistered(kind);
                Ok(Next::End)
            }
            Message::Answers { answers, .. } if answers.is_empty() => {
                Err("it sent a message without an answer".into())
            }
            Message::Answers { first, answers } => {
                let end = first
                    .checked_add(answers.len())
                    .filter(|end| *end <= self.answers.len());
                let Some(end) = end else {
                    return Err("it answered a question that was not asked".into());
                };
                let places = &mut self.answers[first..end];
                // Check all answers before storing any, because a wrong message must not
                // complete the reply.
                if places.iter().any(Option::is_some) {
                    return Err("it answered a question twice".into());
                }
                let sent = (first..end).zip(answers);
                let answers: Option<Vec<Answer>> =
                    sent.map(|(index, sent)| job.receive(index, sent)).collect();
                let answers = answers.ok_or("it sent an answer to another kind of question")?;
                self.missing -= answers.len();
                for (place, answer) in places.iter_mut().zip(answers) {
                    *place = Some(answer);
                }
                Ok(match self.missing {
                    0 => Next::End,
                    _ => Next::Receive,
                })
            }
        }
    }
}

/// Ends a process that may have ended already.
fn end(child: &mut Child) -> Option<ExitStatus> {
    // One that closed its stream is about to exit by itself; its status tells why.
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

/// Reads a pipe to its end on a thread of its own, and keeps only the beginning. Calls a
/// function when it has that.
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
            // A broken pipe ends the text. It is no error if nobody waits for the text
            // any more.
            let _ = (rest, sender.send(kept));
        });
    }
    receiver
}

/// What was printed; nothing if a process left behind still holds the pipe.
fn printed(pipe: Receiver<Vec<u8>>) -> String {
    // A loaded machine may need a while. Wait for it, because a stack overflow is recognised
    // only by this text.
    let bytes = pipe
        .recv_timeout(Duration::from_secs(2))
        .unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests;
