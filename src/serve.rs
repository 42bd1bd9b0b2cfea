//! The submission's side: reads a job, answers it on all cores, and sends the answers.

use std::cell::RefCell;
use std::io::{self, Read, Write};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
#[cfg(unix)]
use std::sync::{Arc, mpsc};
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;

use crate::job::{self, CHUNK, Job, MOST_PANIC_TEXT, Message, Panic};
#[cfg(unix)]
use crate::kind::TestResult;
use crate::kind::{self, AnswerFn, WireAnswer};

/// The argument that makes a submission answer. If it is missing, a person has started the program.
pub const ANSWER: &str = "answer";

/// The exit code if the answers could not be sent.
const UNSENT: u8 = 3;

/// A submission's whole `main`: answers questions with these functions.
///
/// The job comes in on standard input. On Unix that is a socket, and the answers go
/// back through it; elsewhere they go to the file named after the word `answer`.
/// Standard output stays the student's own.
pub fn serve(functions: &[AnswerFn]) -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    if arguments.next().is_none_or(|word| word != ANSWER) {
        return hand_on();
    }
    let served = match arguments.next() {
        Some(file) => std::fs::File::create(file).and_then(|mut out| {
            answer_job(
                functions,
                &receive_job(&mut io::stdin().lock())?,
                &Mutex::new(&mut out),
                &Progress::default(),
            )
        }),
        None => serve_through_stdin(functions),
    };
    match served {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("pinhole: the answers could not be sent: {error}");
            ExitCode::from(UNSENT)
        }
    }
}

/// Runs `pinhole` instead, because a person has started the submission by hand. `cargo run` does
/// that in the submission's folder.
fn hand_on() -> ExitCode {
    let words: Vec<_> = std::env::args_os().skip(1).collect();
    let cargo = std::env::var_os("CARGO").filter(|_| !words.is_empty());
    let status = cargo.and_then(|cargo| {
        let mut command = std::process::Command::new(cargo);
        command.args(["run", "--release", "--package", "pinhole-cli", "--"]);
        command.args(words).status().ok()
    });
    if let Some(status) = status {
        let code = status.code().and_then(|code| u8::try_from(code).ok());
        return ExitCode::from(code.unwrap_or(3));
    }
    eprintln!(
        "This program answers questions from the `pinhole` command. To judge your answers, run:\n\n    \
         cargo pinhole check"
    );
    ExitCode::from(2)
}

#[cfg(unix)]
fn serve_through_stdin(functions: &[AnswerFn]) -> io::Result<()> {
    use std::os::fd::AsFd;
    use std::os::unix::net::UnixStream;

    let mut socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    let job = receive_job(&mut socket)?;
    let asker = socket.try_clone()?;
    let out = Arc::new(Mutex::new(io::BufWriter::new(socket)));
    let progress = Arc::new(Progress::new(&job));
    let (saying, at) = (out.clone(), progress.clone());
    let say_where = move || {
        if let Some(index) = at.first() {
            // If the asker is gone, nobody wants to know.
            let _ = job::send(&Message::StillAt(index), &mut *lock(&saying));
        }
    };
    let (waiting, all_waiting) = mpsc::channel();
    listen_to(asker, say_where, all_waiting);
    let asking = out.clone();
    kind::ask_tests_with(move |index, test| {
        let (for_result, result) = mpsc::channel();
        let mut asking = lock(&asking);
        // Results come in the order of the tests, so hold the lock until the test is sent.
        let waits = waiting.send(for_result).map_err(io::Error::other);
        let sent = waits.and_then(|()| job::send(&Message::Test(index, test), &mut *asking));
        drop(asking);
        match sent.ok().and_then(|()| result.recv().ok()) {
            Some(result) => result,
            None => std::process::exit(UNSENT.into()),
        }
    });
    answer_job(functions, &job, &out, &progress)
}

/// For each chunk of a job, the place of the question that is being answered.
#[derive(Default)]
struct Progress(Vec<AtomicUsize>);

impl Progress {
    /// No question has the last place that a number can hold.
    const IDLE: usize = usize::MAX;

    #[cfg(unix)]
    fn new(job: &Job) -> Progress {
        let chunks = 0..job.len().div_ceil(CHUNK);
        Progress(chunks.map(|_| AtomicUsize::new(Self::IDLE)).collect())
    }

    fn set(&self, chunk: usize, index: usize) {
        if let Some(place) = self.0.get(chunk) {
            place.store(index, Ordering::Relaxed);
        }
    }

    /// The first question that is being answered.
    #[cfg(unix)]
    fn first(&self) -> Option<usize> {
        let places = self.0.iter().map(|place| place.load(Ordering::Relaxed));
        places.filter(|index| *index != Self::IDLE).min()
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the asker sends when it has read as much of standard output as it wants.
pub(crate) const ENOUGH_OUTPUT: u8 = 1;

/// What the asker sends when it has read as much of standard error as it wants.
pub(crate) const ENOUGH_ERRORS: u8 = 2;

/// What the asker sends before the result of a test.
#[cfg(unix)]
pub(crate) const TEST_RESULT: u8 = 3;

/// What the asker sends to learn which question is still being answered.
#[cfg(unix)]
pub(crate) const STILL_AT: u8 = 4;

/// Ends this process when the asker is gone, even if the student's code loops forever. Once
/// the asker has read enough, discards what the code prints, because writing to a pipe
/// takes ten times as long. Passes each result of a test on to the first that is `waiting`. When the
/// asker wants to know which question is still being answered, calls `say_where`.
#[cfg(unix)]
fn listen_to(
    asker: std::os::unix::net::UnixStream,
    say_where: impl Fn() + Send + 'static,
    waiting: mpsc::Receiver<mpsc::Sender<TestResult>>,
) {
    std::thread::spawn(move || {
        let mut asker = io::BufReader::new(asker);
        loop {
            let mut word = [0];
            match asker.read(&mut word).map(|_| word[0]) {
                Ok(stream @ (ENOUGH_OUTPUT | ENOUGH_ERRORS)) => print_nothing_to(stream),
                Ok(STILL_AT) => say_where(),
                Ok(TEST_RESULT) => match job::receive(&mut asker, MOST_RESULT) {
                    Ok(Some(result)) => {
                        // If no search waits for the result, it is not needed.
                        let _ = waiting.try_recv().map(|search| search.send(result));
                    }
                    _ => std::process::exit(UNSENT.into()),
                },
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                _ => std::process::exit(UNSENT.into()),
            }
        }
    });
}

/// The result of a test takes at most this many bytes.
#[cfg(unix)]
const MOST_RESULT: usize = 64;

#[cfg(unix)]
fn print_nothing_to(stream: u8) {
    // If it cannot be opened, printing still works, only more slowly.
    if let Ok(nowhere) = std::fs::OpenOptions::new().write(true).open("/dev/null") {
        let _ = match stream {
            ENOUGH_OUTPUT => rustix::stdio::dup2_stdout(&nowhere),
            _ => rustix::stdio::dup2_stderr(&nowhere),
        };
    }
}

#[cfg(not(unix))]
fn serve_through_stdin(_: &[AnswerFn]) -> io::Result<()> {
    Err(io::Error::other("name a file for the answers"))
}

fn receive_job(input: &mut impl Read) -> io::Result<Job> {
    job::receive(input, u32::MAX as usize)?
        .ok_or_else(|| io::Error::other("there was no job on standard input"))
}

/// Answers a job, writing messages to `out`.
fn answer_job(
    functions: &[AnswerFn],
    job: &Job,
    out: &Mutex<impl Write + Send>,
    progress: &Progress,
) -> io::Result<()> {
    kind::become_submission();
    job::send(&Message::Started, &mut *lock(out))?;
    panic::set_hook(Box::new(remember));

    let stop = AtomicBool::new(false);
    let chunks = job.len().div_ceil(CHUNK);
    (0..chunks).into_par_iter().try_for_each(|chunk| {
        if stop.load(Ordering::Relaxed) {
            return Ok(());
        }
        let first = chunk * CHUNK;
        let indices = first..job.len().min(first + CHUNK);
        let answered = answer_all(functions, job, indices, |index| progress.set(chunk, index));
        progress.set(chunk, Progress::IDLE);
        let message = match answered {
            Ok(answers) => Message::Answers { first, answers },
            // Several cores may fail at the same time, but one report is enough.
            Err(_) if stop.swap(true, Ordering::Relaxed) => return Ok(()),
            Err(failure) => failure,
        };
        job::send(&message, &mut *lock(out))
    })
}

/// The answers to these questions, or why one of them has none. Calls `begin` before each.
fn answer_all(
    functions: &[AnswerFn],
    job: &Job,
    indices: std::ops::Range<usize>,
    begin: impl Fn(usize),
) -> Result<Vec<WireAnswer>, Message> {
    let mut given = Vec::with_capacity(indices.len());
    for index in indices {
        begin(index);
        match panic::catch_unwind(AssertUnwindSafe(|| job.answer(index, functions))) {
            Ok(Ok(answer)) => given.push(answer),
            Ok(Err(unregistered)) => return Err(Message::Unregistered(unregistered)),
            Err(_) => {
                return Err(Message::Panicked(Panic {
                    index,
                    ..LAST_PANIC.take().unwrap_or_else(unknown_panic)
                }));
            }
        }
    }
    Ok(given)
}

thread_local! {
    static LAST_PANIC: RefCell<Option<Panic>> = const { RefCell::new(None) };
}

/// Keeps a panic for the report instead of printing it once per pixel.
fn remember(info: &PanicHookInfo<'_>) {
    let mut message = info.payload_as_str().unwrap_or("(no message)").to_owned();
    message.truncate(message.floor_char_boundary(MOST_PANIC_TEXT));
    let (file, line) = info
        .location()
        .map_or((String::new(), 0), |at| (at.file().into(), at.line()));
    LAST_PANIC.set(Some(Panic {
        message,
        file,
        line,
        index: 0,
    }));
}

/// A panic that the hook did not see, because it happened on another thread.
fn unknown_panic() -> Panic {
    Panic {
        message: "(no message)".into(),
        file: String::new(),
        line: 0,
        index: 0,
    }
}

#[cfg(test)]
mod tests;
