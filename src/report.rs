//! Verdicts, and how processes died, in words.

use std::fmt;

use crate::ask::Death;
use crate::judge::{ChannelVerdict, Mismatch, Verdict};
use crate::words::number;

impl fmt::Display for Verdict {
    /// One line for the film and one for each channel that fails, without the last
    /// line break.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.failing.len(), self.resolution.pixels()) {
            (0, all) => write!(f, "passes: all {all} pixels agree")?,
            (1, all) => write!(f, "fails: 1 of {all} pixels is wrong")?,
            (wrong, all) => write!(f, "fails: {wrong} of {all} pixels are wrong")?,
        }
        for channel in self.channels.iter().filter(|channel| channel.failing > 0) {
            write!(f, "\n  {channel}")?;
        }
        Ok(())
    }
}

impl fmt::Display for ChannelVerdict {
    /// `t    12 pixels, (3, 4) to (9, 9); worst at (5, 5): got 1.5, expected 1.25 ± 1e−6`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Some(worst), Some(bounds)) = (self.worst, self.bounds) else {
            return write!(f, "{:<4} agrees everywhere", self.name);
        };
        let pixels = match self.failing {
            1 => "1 pixel".into(),
            some => format!("{some} pixels"),
        };
        if self.own == 0 {
            return write!(
                f,
                "{:<4} {pixels}, only where the object is wrong",
                self.name
            );
        }
        let digits = digits_to_tell(&worst);
        let shown = |value: f32| match (self.name.as_str(), value) {
            ("id", -1.0) => "no hit".into(),
            ("id", id) => format!("object {id}"),
            (_, value) => number(f64::from(value), digits),
        };
        write!(f, "{:<4} {pixels}", self.name)?;
        if self.failing > 1 {
            write!(f, ", {} to {}", bounds.min, bounds.max)?;
        }
        let (got, expected) = (shown(worst.got), shown(worst.expected));
        write!(
            f,
            "; worst at {}: got {got}, expected {expected}",
            worst.pixel
        )?;
        match self.name.as_str() {
            "id" => Ok(()),
            _ => write!(f, " ± {}", number(f64::from(worst.allowed), 2)),
        }
    }
}

impl fmt::Display for Death {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let signal = self.possible_signal().map(|signal| match signal {
            4 => "an illegal instruction".into(),
            6 => {
                "it aborted, which happens when a function calls itself without end, or when memory \
                 runs out"
                    .into()
            }
            7 | 11 => "it touched memory that is not its own".into(),
            9 => "SIGKILL".into(),
            25 => "it wrote a file that is too long".into(),
            31 => "a forbidden system call".into(),
            other => format!("signal {other}"),
        });
        let words = match (self, signal) {
            (Death::Exit(code), Some(signal)) => format!(
                "it exited with code {code} before it had answered; that usually means that it was \
                 killed ({signal})"
            ),
            (Death::Exit(code), None) => {
                format!("it exited with code {code} before it had answered")
            }
            (_, Some(signal)) => format!("it was killed before it had answered ({signal})"),
            (_, None) => "it ended for an unknown reason".into(),
        };
        f.write_str(&words)
    }
}

/// Six digits, or as many as it takes to see that two numbers differ.
pub fn digits_to_tell(mismatch: &Mismatch) -> usize {
    let (got, expected) = (f64::from(mismatch.got), f64::from(mismatch.expected));
    (6..9)
        .find(|digits| number(got, *digits) != number(expected, *digits))
        .unwrap_or(9)
}

#[cfg(test)]
mod tests;
