//! A line that says what is going on, on a terminal only.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// A progress line on standard error; on a pipe it says nothing.
pub struct Progress(ProgressBar);

impl Default for Progress {
    fn default() -> Progress {
        Progress::new()
    }
}

impl Progress {
    /// Nothing to say yet.
    pub fn new() -> Progress {
        let bar = ProgressBar::new(1000);
        let style =
            ProgressStyle::with_template("{msg:20} {wide_bar:.dim} {percent:>3} % {elapsed}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress(bar)
    }

    /// Something of unknown length.
    pub fn say(&self, what: &str) {
        self.show(what, 0.0);
    }

    /// `share` of `what` is done, 0 to 1.
    pub fn show(&self, what: &str, share: f64) {
        if self.0.message() != what {
            self.0.set_message(what.to_owned());
        }
        self.0.set_position((share.clamp(0.0, 1.0) * 1000.0) as u64);
    }

    /// Done; the line disappears.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}
