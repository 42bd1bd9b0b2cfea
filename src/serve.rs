//! The submission's side: read a job, answer it on all cores, send what comes.

use std::cell::RefCell;
use std::io::{self, Read, Write};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::answers::Answers;
use crate::job::{self, Answer, CHUNK, Job, MOST_PANIC_TEXT, Message, Panic};
use crate::ray::{Hit, Intersection};

/// The word that makes a submission answer; without it a person has started it.
pub const ANSWER: &str = "answer";

/// The exit code if the answers could not be sent.
const UNSENT: u8 = 3;

/// A submission's whole `main`.
///
/// The job comes in on standard input. On Unix that is a socket, and the answers go
/// back through it; elsewhere they go to the file named after the word `answer`.
/// Standard output stays the student's own.
pub fn serve(answers: &Answers) -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    if arguments.next().is_none_or(|word| word != ANSWER) {
        return hand_on();
    }
    let served = match arguments.next() {
        Some(file) => std::fs::File::create(file).and_then(|mut out| {
            answer_job(answers, &receive_job(&mut io::stdin().lock())?, &mut out)
        }),
        None => serve_through_stdin(answers),
    };
    match served {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("pinhole: the answers could not be sent: {error}");
            ExitCode::from(UNSENT)
        }
    }
}

/// Somebody has started the submission by hand. In its folder `cargo run` means this
/// program, though `pinhole` was meant: that is asked in its place.
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
        "This program answers questions of the `pinhole` command. To see what your answers\n\
         make of a scene, run:\n\n    cargo run --release -- check"
    );
    ExitCode::from(2)
}

#[cfg(unix)]
fn serve_through_stdin(answers: &Answers) -> io::Result<()> {
    use std::os::fd::AsFd;
    use std::os::unix::net::UnixStream;

    let mut socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    let job = receive_job(&mut socket)?;
    end_with(socket.try_clone()?);
    answer_job(answers, &job, &mut io::BufWriter::new(socket))
}

/// Ends this process when nobody is there any more to read its answers, even if the
/// student's code never comes to an end.
#[cfg(unix)]
fn end_with(mut asker: std::os::unix::net::UnixStream) {
    std::thread::spawn(move || {
        // Nothing follows a job: whatever comes but an interruption is the end.
        while asker
            .read(&mut [0])
            .is_err_and(|error| error.kind() == io::ErrorKind::Interrupted)
        {}
        std::process::exit(UNSENT.into())
    });
}

#[cfg(not(unix))]
fn serve_through_stdin(_: &Answers) -> io::Result<()> {
    Err(io::Error::other("name a file for the answers"))
}

fn receive_job(input: &mut impl Read) -> io::Result<Job> {
    job::receive(input, u32::MAX as usize)?
        .ok_or_else(|| io::Error::other("there was no job on standard input"))
}

/// Answers a job, writing messages to `out`.
fn answer_job(answers: &Answers, job: &Job, out: &mut (impl Write + Send)) -> io::Result<()> {
    panic::set_hook(Box::new(remember));

    let out = Mutex::new(out);
    let stop = AtomicBool::new(false);
    let chunks = job.len().div_ceil(CHUNK);
    (0..chunks).into_par_iter().try_for_each(|chunk| {
        if stop.load(Ordering::Relaxed) {
            return Ok(());
        }
        let first = chunk * CHUNK;
        let indices = first..job.len().min(first + CHUNK);
        let message = match answer_all(answers, job, indices) {
            Ok(answers) => Message::Answers { first, answers },
            Err(panic) if stop.swap(true, Ordering::Relaxed) => return drop_second(panic),
            Err(panic) => Message::Panicked(panic),
        };
        let mut out = out.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        job::send(&message, &mut **out)
    })
}

/// Two cores may panic at once; one report is enough.
fn drop_second(_: Panic) -> io::Result<()> {
    Ok(())
}

fn answer_all(
    answers: &Answers,
    job: &Job,
    indices: std::ops::Range<usize>,
) -> Result<Vec<Answer>, Panic> {
    let mut given = Vec::with_capacity(indices.len());
    for index in indices {
        match panic::catch_unwind(AssertUnwindSafe(|| answer(answers, job, index))) {
            Ok(answer) => given.push(answer),
            Err(_) => {
                return Err(Panic {
                    index,
                    ..LAST_PANIC.take().unwrap_or_else(unknown_panic)
                });
            }
        }
    }
    Ok(given)
}

fn answer(answers: &Answers, job: &Job, index: usize) -> Answer {
    match job {
        Job::Film(scene) => {
            let pixel = scene.resolution.pixel(index);
            let ray = (answers.viewing_ray)(&scene.camera, pixel, scene.resolution);
            Answer::Hit((answers.first_hit)(&ray, scene.min_t, &scene.objects))
        }
        Job::ViewingRay(questions) => {
            let asked = &questions[index];
            Answer::Ray((answers.viewing_ray)(
                &asked.camera,
                asked.pixel,
                asked.resolution,
            ))
        }
        Job::Intersect(questions) => {
            let asked = &questions[index];
            alone(answers.intersect(&asked.shape, &asked.ray, asked.min_t))
        }
        Job::FirstHit(questions) => {
            let asked = &questions[index];
            Answer::Hit((answers.first_hit_canned)(
                &asked.ray,
                asked.min_t,
                &asked.objects.triangles,
            ))
        }
        Job::TriangleSoup(questions) => {
            let asked = &questions[index];
            alone((answers.triangle_soup_canned)(
                &asked.objects,
                &asked.ray,
                asked.min_t,
            ))
        }
        Job::Cast(ray, min_t, objects) => Answer::Hit((answers.first_hit)(ray, *min_t, objects)),
    }
}

fn alone(intersection: Option<Intersection>) -> Answer {
    Answer::Hit(intersection.map(|intersection| Hit {
        object: 0,
        intersection,
    }))
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

/// A panic of which the hook saw nothing, because it happened on another thread.
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
