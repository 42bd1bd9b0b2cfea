//! Bounds what is read of one submission. Archives may contain far more than their length suggests:
//! `gzip` compresses well, and files in a ZIP file may share their bytes.

use std::cell::Cell;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::rc::Rc;
use std::time::{Duration, Instant};

use super::FoundFile;

/// How much of one submission is read, or of a whole folder or archive. Everything that is read
/// counts for its submission and for the folder or archive that contains it, which may contain so
/// much more than a submission that a few people can't exceed its limits.
pub struct Limits {
    /// Bytes of what is kept: answers, and the paths of all that is listed.
    pub kept: Limit,
    /// Bytes of archives and answers that are unpacked one by one.
    pub unpacked: Limit,
    /// Bytes that are read of archives to look for answers.
    pub passed: Limit,
    /// How many files are looked at.
    pub files: Limit,
    /// For how long it may still be read, and until when while it is read.
    time: Cell<Duration>,
    until: Cell<Option<Instant>>,
    whole: Option<Rc<Limits>>,
    /// Which limit is exceeded.
    exceeded: Cell<Option<&'static str>>,
}

/// What is left of an amount, and what to say when it is exceeded.
pub struct Limit(Cell<u64>, &'static str);

impl Limit {
    fn new(most: u64, exceeded: &'static str) -> Limit {
        Limit(Cell::new(most), exceeded)
    }

    /// Spends some of it, if that much is left; otherwise, all of it.
    fn spend(&self, amount: u64) -> Result<(), &'static str> {
        let left = self.0.get().checked_sub(amount);
        self.0.set(left.unwrap_or(0));
        left.map(drop).ok_or(self.1)
    }
}

/// How many bytes are kept, unpacked and passed of one submission.
const MOST_KEPT: u64 = 4 << 20;
const MOST_UNPACKED: u64 = 1 << 30;
const MOST_PASSED: u64 = 4 << 30;

/// Even on a slow disk, no student's ordinary archive takes longer.
const MOST_TIME: Duration = Duration::from_secs(60);
pub const TOO_SLOW: &str = "reading it takes longer than a minute";

/// So many submissions may reach their limits in a class.
const SEVERAL: u64 = 32;

/// The clock of an archive that may contain a whole class runs for this long, and for a second more for
/// each MiB.
const MOST_TIME_OF_CLASS: Duration = Duration::from_secs(15 * 60);

impl Limits {
    /// The limits of an archive of this length that may contain a whole class.
    pub fn of_archive(length: u64) -> Limits {
        let more = length.saturating_mul(20);
        let time = MOST_TIME_OF_CLASS.saturating_add(Duration::from_secs(length >> 20));
        Limits::of_class([more; 3], time)
    }

    /// The limits of a folder with so many files and folders at the top.
    pub fn of_folder(tops: u64) -> Limits {
        let more = tops.saturating_mul(256 << 10);
        Limits::of_class([more, u64::MAX, u64::MAX], Duration::MAX)
    }

    /// The limits of [`SEVERAL`] submissions, and so much more.
    fn of_class([kept, unpacked, passed]: [u64; 3], time: Duration) -> Limits {
        let limit = |of_one: u64, more: u64, exceeded| {
            Limit::new(more.saturating_add(SEVERAL * of_one), exceeded)
        };
        let unpacks = "it unpacks to more than a whole class needs";
        Limits {
            kept: limit(
                MOST_KEPT,
                kept,
                "it contains more answer files than a whole class needs",
            ),
            unpacked: limit(MOST_UNPACKED, unpacked, unpacks),
            passed: limit(MOST_PASSED, passed, unpacks),
            files: Limit::new(u64::MAX, ""),
            time: Cell::new(time),
            until: Cell::new(None),
            whole: None,
            exceeded: Cell::new(None),
        }
    }

    /// The limits of one submission, in an archive or not.
    pub fn of_one(whole: Option<Rc<Limits>>) -> Limits {
        let answers = "it contains more answer files than anybody needs";
        Limits {
            kept: Limit::new(MOST_KEPT, answers),
            unpacked: Limit::new(MOST_UNPACKED, "it unpacks to more than 1 GiB"),
            passed: Limit::new(MOST_PASSED, "more than 4 GiB of it would have to be read"),
            files: Limit::new(100_000, "it contains more than 100000 files"),
            time: Cell::new(MOST_TIME),
            until: Cell::new(None),
            whole,
            exceeded: Cell::new(None),
        }
    }

    #[cfg(test)]
    pub fn with_time(self, time: Duration) -> Limits {
        self.time.set(time);
        self
    }

    /// Spends a part of a limit, and of the same limit of the archive around it. An error says
    /// which limit is exceeded.
    pub fn spend(&self, of: fn(&Limits) -> &Limit, amount: u64) -> Result<(), &'static str> {
        let spent = match self.is_late() {
            true => Err(TOO_SLOW),
            false => of(self).spend(amount),
        };
        if let Err(why) = spent {
            self.exceeded.set(Some(why));
            return spent;
        }
        match &self.whole {
            Some(whole) => whole.spend(of, amount),
            None => Ok(()),
        }
    }

    /// Which limit is exceeded, if one is.
    pub fn exceeded(&self) -> Option<&'static str> {
        self.exceeded.get()
    }

    /// Starts the clock. Until it stops, everything that is read is this submission's.
    pub fn start_clock(&self) {
        self.until.set(Instant::now().checked_add(self.time.get()));
    }

    pub fn stop_clock(&self) {
        if let Some(until) = self.until.take() {
            self.time
                .set(until.saturating_duration_since(Instant::now()));
        }
    }

    pub fn is_late(&self) -> bool {
        self.until.get().is_some_and(|until| Instant::now() > until)
    }
}

/// What a found file costs: its path and its text.
pub fn cost(found: &FoundFile) -> u64 {
    let path = found.path.iter().map(|part| part.len() + 64).sum::<usize>();
    let text = match &found.content {
        super::Content::Answer { text: Ok(text), .. } => text.len(),
        _ => 0,
    };
    (path + text) as u64
}

/// A reader or writer that counts what goes through it, and stops at a limit.
pub struct LimitedStream<T> {
    pub inner: T,
    pub limits: Rc<Limits>,
    pub of: fn(&Limits) -> &Limit,
}

impl<T> LimitedStream<T> {
    fn spend(&self, amount: usize) -> io::Result<()> {
        let spent = self.limits.spend(self.of, amount as u64);
        spent.map_err(io::Error::other)
    }
}

impl<T: Read> Read for LimitedStream<T> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.inner.read(buffer)?;
        self.spend(read).map(|()| read)
    }
}

impl<T: Seek> Seek for LimitedStream<T> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.inner.seek(to)
    }
}

impl<T: Write> Write for LimitedStream<T> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.spend(bytes.len())?;
        self.inner.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}
