//! How a job reaches a submission's process, and how messages come back.
//!
//! On Unix, both go through one socket, which is the process's standard input, so nothing is left
//! on disk and no other process can reach it. Elsewhere, the job goes through a pipe and the
//! answers come back in a temporary file.

use std::io;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use super::{Clock, Limit, PULSE, Stop};
use crate::job::{self, Job, Message};
use crate::kind::TestResult;
use crate::serve::ANSWER;
#[cfg(unix)]
use crate::serve::{STILL_AT, TEST_RESULT};

/// When an exchange must end.
struct Deadline {
    start: Instant,
    wall: Duration,
    /// How long the submission's clock stood still.
    stood_still: Duration,
}

impl Deadline {
    fn after(wall: Duration) -> Deadline {
        Deadline {
            start: Instant::now(),
            wall,
            stood_still: Duration::ZERO,
        }
    }

    /// The time until then, as far as it is known.
    fn left(&self) -> Duration {
        (self.wall + self.stood_still).saturating_sub(self.start.elapsed())
    }

    /// Puts it off by the time in which the clock stood still.
    #[cfg(unix)]
    fn put_off(&mut self, clock: &mut Clock) {
        let stood_still = self.start.elapsed().saturating_sub(clock());
        self.stood_still = stood_still.min(self.wall * (super::BUSY - 1));
    }
}

/// A running submission and the connection to it.
pub(super) struct Exchange {
    pub(super) child: Child,
    link: Link,
    deadline: Deadline,
    /// Only for answers through a socket. A file is read when it is complete.
    #[cfg_attr(not(unix), expect(dead_code))]
    silence: Duration,
    stop: Stop,
}

/// Called with each message.
type OnMessage<'a> = &'a mut dyn FnMut(Message) -> Result<Next, String>;

/// How an exchange goes on after a message.
#[derive(Debug, PartialEq)]
pub(super) enum Next {
    /// More messages are needed.
    Receive,
    /// This result is sent, and more messages are needed.
    Send(TestResult),
    /// The reply is complete.
    End,
}

#[cfg(unix)]
type Link = std::os::unix::net::UnixStream;

#[cfg(not(unix))]
type Link = std::path::PathBuf;

impl Exchange {
    /// Whether its time is up.
    pub(super) fn is_late(&self) -> bool {
        self.deadline.left().is_zero()
    }

    /// Returns a function that sends one byte to the submission. Call it only after the job is
    /// sent.
    #[cfg(unix)]
    pub(super) fn tell(&self, word: u8) -> impl FnOnce() + Send + 'static {
        let link = self.link.try_clone();
        move || {
            // If this fails, the submission goes on printing into the pipe.
            let _ = link.and_then(|mut link| io::Write::write_all(&mut link, &[word]));
        }
    }

    #[cfg(not(unix))]
    pub(super) fn tell(&self, _: u8) -> impl FnOnce() + Send + 'static {
        || {}
    }

    #[cfg(unix)]
    pub(super) fn start(mut command: Command, limit: Limit) -> io::Result<Exchange> {
        let (link, theirs) = Link::pair()?;
        command
            .arg(ANSWER)
            .stdin(std::os::fd::OwnedFd::from(theirs));
        let child = command.spawn()?;
        // Dropping `command` closes our copy of the submission's end, so that we see the stream
        // end when the submission closes it.
        Ok(Exchange {
            child,
            link,
            deadline: Deadline::after(limit.wall),
            silence: limit.silence,
            stop: limit.stop,
        })
    }

    #[cfg(unix)]
    pub(super) fn converse(
        &mut self,
        job: &Job,
        clock: Clock,
        most: usize,
        on_message: OnMessage<'_>,
    ) -> io::Result<()> {
        let mut timed = DeadlineStream {
            link: &self.link,
            deadline: &mut self.deadline,
            silence: self.silence,
            clock,
            stop: &self.stop,
        };
        job::send(job, &mut io::BufWriter::new(&mut timed))?;
        let mut input = io::BufReader::new(timed);
        receive_all(&mut input, most, &mut |message, input| {
            let next = on_message(message).map_err(io::Error::other)?;
            if let Next::Send(result) = &next {
                let mut bytes = vec![TEST_RESULT];
                job::send(result, &mut bytes)?;
                io::Write::write_all(input.get_mut(), &bytes)?;
            }
            Ok(!matches!(next, Next::End))
        })
    }

    /// Which question is still being answered, after a time-out. Waits a moment for the reply.
    #[cfg(unix)]
    pub(super) fn still_at(&mut self, most: usize) -> Option<usize> {
        let mut stream = DeadlineStream {
            link: &self.link,
            deadline: &mut Deadline::after(4 * PULSE),
            silence: self.silence,
            clock: super::wall_clock(),
            stop: &self.stop,
        };
        io::Write::write_all(&mut stream, &[STILL_AT]).ok()?;
        let mut at = None;
        // Answers that come now are too late. If the time-out interrupted a message, the rest of
        // it can't be read, and the question stays unknown.
        let received = receive_all(&mut stream, most, &mut |message, _| {
            if let Message::StillAt(index) = message {
                at = Some(index);
            }
            Ok(at.is_none())
        });
        received.ok().and(at)
    }

    #[cfg(not(unix))]
    pub(super) fn still_at(&mut self, _: usize) -> Option<usize> {
        None
    }

    #[cfg(not(unix))]
    pub(super) fn start(mut command: Command, limit: Limit) -> io::Result<Exchange> {
        use std::sync::atomic::{AtomicUsize, Ordering};

        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let name = format!(
            "pinhole-{}-{}",
            std::process::id(),
            NEXT.fetch_add(1, Ordering::Relaxed)
        );
        let link = std::env::temp_dir().join(name);
        command
            .arg(ANSWER)
            .arg(&link)
            .stdin(std::process::Stdio::piped());
        let child = command.spawn()?;
        Ok(Exchange {
            child,
            link,
            deadline: Deadline::after(limit.wall),
            silence: limit.silence,
            stop: limit.stop,
        })
    }

    #[cfg(not(unix))]
    pub(super) fn converse(
        &mut self,
        job: &Job,
        _: Clock,
        most: usize,
        on_message: OnMessage<'_>,
    ) -> io::Result<()> {
        if job.is_counted() {
            return Err(io::Error::other(
                "searches can't be judged on Windows, because each test of a box needs a reply \
                 at once; use WSL, Linux or macOS",
            ));
        }
        if let Some(mut pipe) = self.child.stdin.take() {
            job::send(job, &mut pipe)?;
        }
        let mut late = false;
        while self.child.try_wait()?.is_none() && !late {
            std::thread::sleep(PULSE / 10);
            late = self.is_late() || self.stop.is_raised();
        }
        if let Ok(file) = std::fs::File::open(&self.link) {
            let mut input = io::BufReader::new(file);
            let received = receive_all(&mut input, most, &mut |message, _| {
                let next = on_message(message).map_err(io::Error::other)?;
                Ok(!matches!(next, Next::End))
            });
            // A late writer may be in the middle of a message.
            if !late {
                return received;
            }
        }
        if late {
            Err(io::ErrorKind::TimedOut.into())
        } else {
            Ok(())
        }
    }
}

#[cfg(not(unix))]
impl Drop for Exchange {
    fn drop(&mut self) {
        let _never_made = std::fs::remove_file(&self.link);
    }
}

/// Receives messages until `on_message` returns [`Next::End`].
fn receive_all<R: io::Read>(
    input: &mut R,
    most: usize,
    on_message: &mut dyn FnMut(Message, &mut R) -> io::Result<bool>,
) -> io::Result<()> {
    while let Some(message) = job::receive(input, most)? {
        if !on_message(message, input)? {
            break;
        }
    }
    Ok(())
}

/// A socket whose reads and writes all fail after the same deadline, so that a slow drip of bytes
/// gains no time. They also fail after too long a silence, or once nobody wants the answer any
/// more.
#[cfg(unix)]
struct DeadlineStream<'a> {
    link: &'a Link,
    deadline: &'a mut Deadline,
    silence: Duration,
    clock: Clock,
    stop: &'a Stop,
}

#[cfg(unix)]
impl DeadlineStream<'_> {
    /// Reads or writes, and checks every [`PULSE`] whether to give up.
    fn in_time(
        &mut self,
        arm: impl Fn(&Link, Duration) -> io::Result<()>,
        mut work: impl FnMut() -> io::Result<usize>,
    ) -> io::Result<usize> {
        // Most messages come before the first look at the clock, which takes a while.
        let mut since = None;
        let mut silent = Duration::ZERO;
        loop {
            if self.deadline.left().is_zero() {
                self.deadline.put_off(&mut self.clock);
            }
            let left = self.deadline.left();
            if left.is_zero() || self.stop.is_raised() {
                return Err(io::ErrorKind::TimedOut.into());
            }
            // While the clock stands still, there is always little time left.
            let pulse = left.clamp(PULSE / 10, PULSE).min(self.silence);
            armed(arm(self.link, pulse))?;
            match work() {
                // Looking at the clock takes a while on a busy machine, and the message may have come
                // meanwhile. So this has tried once more since it found the silence too long.
                Err(error) if super::is_timeout(&error) && silent < self.silence => {}
                done => return done,
            }
            let now = (self.clock)();
            silent = pulse + now.saturating_sub(*since.get_or_insert(now));
        }
    }
}

/// Once the peer has closed a socket, macOS refuses to set a timeout on it. This ignores that
/// error, because nothing can block any more.
#[cfg(unix)]
fn armed(set: io::Result<()>) -> io::Result<()> {
    match set {
        Err(error) if error.kind() == io::ErrorKind::InvalidInput => Ok(()),
        set => set,
    }
}

#[cfg(unix)]
impl io::Read for DeadlineStream<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut link = self.link;
        self.in_time(
            |link, left| link.set_read_timeout(Some(left)),
            || link.read(buffer),
        )
    }
}

#[cfg(unix)]
impl io::Write for DeadlineStream<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut link = self.link;
        self.in_time(
            |link, left| link.set_write_timeout(Some(left)),
            || link.write(bytes),
        )
    }

    fn flush(&mut self) -> io::Result<()> {
        self.link.flush()
    }
}
