//! Shows the progress of grading: a line on a terminal, otherwise a log.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::grade::record::RecordSummary;
use pinhole_course::progress::Progress;
use pinhole_report::escape::printable;

/// Progress through a class, shared by the threads that grade.
pub struct GradingProgress<'a> {
    line: &'a Progress,
    /// How many submissions there are in total.
    of: usize,
    done: AtomicUsize,
}

impl GradingProgress<'_> {
    /// Progress through `of` submissions, of which none is graded yet.
    pub fn new(line: &Progress, of: usize) -> GradingProgress<'_> {
        GradingProgress {
            line,
            of,
            done: AtomicUsize::new(0),
        }
    }

    /// Reports that a submission is graded again, alone, because an answer exceeded its time limit.
    pub fn again_alone(&self, id: &str) {
        self.line.say(&again_line(id));
    }

    /// Reports that a submission is done: it was graded in this run, or its result is still
    /// valid.
    pub fn graded(&self, record: &RecordSummary, is_new: bool) {
        let count = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let share = count as f64 / self.of.max(1) as f64;
        self.line.show(&printable(&record.id), share);
        if !std::io::stderr().is_terminal() && is_new {
            let points = record.points.map_or("no mark".into(), |points| {
                format!("{points} of {}", record.possible)
            });
            let said = format!("{points}, {}", record.status.word());
            anstream::eprintln!("[{count}/{}] {}", self.of, log_line(&record.id, &said));
        }
    }
}

fn again_line(id: &str) -> String {
    format!(
        "{} is graded again, alone, because an answer exceeded its time limit",
        printable(id)
    )
}

fn log_line(id: &str, said: &str) -> String {
    format!("{}: {said}", printable(id))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_names_are_escaped_in_terminals_and_logs() {
        let hostile = "x\u{1b}[2J\u{202e}\n[1/1] eve: 100 of 100";
        for line in [again_line(hostile), log_line(hostile, "no mark")] {
            assert!(!line.contains(char::is_control), "{line:?}");
            assert!(!line.contains('\u{202e}'), "{line:?}");
        }
    }
}
