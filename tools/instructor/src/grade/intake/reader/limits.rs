//! Bounds what is read of one submission. Archives may contain far more than their length suggests:
//! `gzip` compresses well, and files in a ZIP file may share their bytes.

use std::cell::Cell;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::rc::Rc;
use std::time::{Duration, Instant};

use super::FoundFile;

/// How much of one submission is read, or of a whole archive. Everything that is read counts
/// for its submission and for the archive that contains it.
pub struct Limits {
    /// Bytes of what is kept: answers, and the paths of all that is listed.
    pub kept: Limit,
    /// Bytes of archives and answers that are unpacked one by one.
    pub unpacked: Limit,
    /// Bytes that are read of archives to look for answers.
    pub passed: Limit,
    /// How many files are looked at.
    pub files: Limit,
    /// What an archive's submissions may take without counting for the archive, in all.
    reserved: Limit,
    pub until: Option<Instant>,
    whole: Option<Rc<Limits>>,
}

/// What is left of an amount, and the amount in words.
pub struct Limit {
    left: Cell<u64>,
    /// How much of it does not count for the archive around the submission.
    own: Cell<u64>,
    said: &'static str,
}

impl Limit {
    fn new(most: u64, said: &'static str) -> Limit {
        Limit {
            left: Cell::new(most),
            own: Cell::new(0),
            said,
        }
    }

    /// Spends some of it, if that much is left; otherwise, all of it. Returns how much counts for
    /// the archive around the submission.
    fn spend(&self, amount: u64) -> Result<u64, &'static str> {
        let left = self.left.get().checked_sub(amount);
        self.left.set(left.unwrap_or(0));
        let own = self.own.get();
        self.own.set(own.saturating_sub(amount));
        left.map(|_| amount.saturating_sub(own)).ok_or(self.said)
    }
}

/// Even on a slow disk, no student's ordinary archive takes longer.
const MOST_TIME: Duration = Duration::from_secs(60);
pub const TOO_SLOW: &str = "reading it takes longer than a minute";

impl Limits {
    /// The limits of an archive of this length that may contain a whole class.
    pub fn of_archive(length: u64) -> Limits {
        let more = length.saturating_mul(20);
        Limits {
            kept: Limit::new(
                (64 << 20) + more,
                "it contains more answer files than a whole class needs",
            ),
            unpacked: Limit::new(
                (1 << 30) + more,
                "it unpacks to more than 20 times its size",
            ),
            passed: Limit::new(
                (4 << 30) + more,
                "it unpacks to more than 20 times its size",
            ),
            files: Limit::new(u64::MAX, ""),
            reserved: Limit::new(more, ""),
            until: None,
            whole: None,
        }
    }

    /// The limits of one submission, in an archive or not.
    pub fn of_one(whole: Option<Rc<Limits>>) -> Limits {
        let answers = "it contains more answer files than anybody needs";
        Limits {
            kept: Limit::new(16 << 20, answers),
            unpacked: Limit::new(1 << 30, "it unpacks to more than 1 GiB"),
            passed: Limit::new(4 << 30, "more than 4 GiB of it would have to be read"),
            files: Limit::new(100_000, "it contains more than 100000 files"),
            reserved: Limit::new(0, ""),
            until: Some(Instant::now() + MOST_TIME),
            whole,
        }
    }

    /// Reserves 20 times the length of a submission's file in an archive for this submission, so
    /// that others, however much they unpack to, leave enough for it. Files that share their bytes
    /// get no more than 20 times the length of the whole archive.
    pub fn reserve(&self, length: u64) {
        let Some(whole) = &self.whole else { return };
        let own = length.saturating_mul(20);
        if whole.reserved.spend(own).is_ok() {
            for limit in [&self.kept, &self.unpacked, &self.passed] {
                limit.own.set(limit.own.get() + own);
            }
        }
    }

    /// Spends a part of a limit, and of the same limit of the archive around it. An error says
    /// which limit is exceeded.
    pub fn spend(&self, of: fn(&Limits) -> &Limit, amount: u64) -> Result<(), &'static str> {
        if self.is_late() {
            return Err(TOO_SLOW);
        }
        let counts = of(self).spend(amount)?;
        match &self.whole {
            Some(whole) => whole.spend(of, counts),
            None => Ok(()),
        }
    }

    pub fn is_late(&self) -> bool {
        self.until.is_some_and(|until| Instant::now() > until)
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
