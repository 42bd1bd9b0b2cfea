//! Shows progress: a line on a terminal, and messages where something takes long.

use std::fs;
use std::path::Path;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// A progress line on standard error; nothing is printed into a pipe.
pub struct Progress(ProgressBar);

impl Default for Progress {
    fn default() -> Progress {
        Progress::new()
    }
}

impl Progress {
    /// An empty progress line.
    pub fn new() -> Progress {
        let bar = ProgressBar::new(1000);
        let style =
            ProgressStyle::with_template("{msg:20} {wide_bar:.dim} {percent:>3} % {elapsed}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress(bar)
    }

    /// A line that is never shown.
    pub fn hidden() -> Progress {
        Progress(ProgressBar::hidden())
    }

    /// Shows what is being done, if its duration is unknown.
    pub fn say(&self, what: &str) {
        self.show(what, 0.0);
    }

    /// Shows that a share of `what` is done, from 0 to 1.
    pub fn show(&self, what: &str, share: f64) {
        if self.0.message() != what {
            self.0.set_message(what.to_owned());
        }
        self.0.set_position((share.clamp(0.0, 1.0) * 1000.0) as u64);
    }

    /// Removes the line.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

/// The longest time between two messages.
const MOST_SILENCE: Duration = Duration::from_secs(4);

/// Does some work. Every few seconds, prints to standard error what is being done, for how long,
/// and how long it took last time. The file `record` keeps that time.
pub fn patiently<T>(what: &str, record: &Path, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let (working, done) = mpsc::channel::<()>();
    let before = fs::read_to_string(record).ok();
    let what = what.to_owned();
    let teller = thread::spawn(move || {
        while done.recv_timeout(MOST_SILENCE) == Err(RecvTimeoutError::Timeout) {
            let words = still_at(&what, start.elapsed(), before.as_deref());
            anstream::eprintln!("{words}");
        }
    });
    let made = work();
    drop(working);
    // The thread only prints, so it ends at once.
    let _ended = teller.join();
    let took = start.elapsed();
    if took > MOST_SILENCE {
        // Without a record, the next message can't say how long it took last time.
        let folder = record.parent().map_or(Ok(()), fs::create_dir_all);
        let _kept = folder.and_then(|()| fs::write(record, took.as_secs().to_string()));
    }
    made
}

fn still_at(what: &str, so_far: Duration, before: Option<&str>) -> String {
    let before: Option<u64> = before.and_then(|text| text.trim().parse().ok());
    let before = before.map_or(String::new(), |seconds| format!("; {seconds} s last time"));
    format!("{what}, {} s so far{before} …", so_far.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn message_says_what_is_running_and_how_long_it_took_last_time() {
        let told = |before| still_at("building the book", Duration::from_secs(8), before);
        assert_eq!(told(None), "building the book, 8 s so far …");
        assert_eq!(
            told(Some("83\n")),
            "building the book, 8 s so far; 83 s last time …"
        );
        assert_eq!(told(Some("nonsense")), told(None));
    }
}
