//! The terminal. It is in raw mode while we watch, and restored on every way out.

use std::io::{self, Write, stdout};
use std::panic;
use std::sync::mpsc::Sender;

use anstream::{AutoStream, ColorChoice};
use anstyle::Reset;
use crossterm::cursor::MoveTo;
use crossterm::queue;
use crossterm::terminal::{self, Clear, ClearType};

use super::state::State;
use super::{Event, keys, screen};
use pinhole_course::error::{Error, Result, ResultExt};

/// A raw terminal, which is restored when this is dropped.
pub struct Terminal {
    shown: Vec<String>,
}

/// Whether this is a terminal that cannot move its cursor.
pub fn is_dumb() -> bool {
    std::env::var_os("TERM").is_some_and(|term| term == "dumb")
}

impl Terminal {
    /// Puts the terminal into raw mode.
    pub fn enter(events: Sender<Event>) -> Result<Terminal> {
        terminal::enable_raw_mode().or_fail(&broken())?;
        let terminal = Terminal { shown: Vec::new() };
        // A message printed in raw mode would be unreadable.
        let hook = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            give_back();
            eprintln!();
            hook(info);
        }));
        // Move the text on the screen up, so that the user can still scroll back to it.
        let (_, rows) = size();
        write!(stdout(), "{}", "\r\n".repeat(rows)).or_fail(&broken())?;
        keys::listen(events);
        Ok(terminal)
    }

    /// Shows the current state.
    pub fn show(&mut self, state: &mut State) -> Result<()> {
        let (columns, rows) = size();
        let frame = screen::frame(state, columns, rows);
        state.scroll = frame.scroll;
        if frame.lines != self.shown {
            self.shown = frame.lines;
            self.draw().or_fail(&broken())?;
        }
        Ok(())
    }

    /// Forgets what is on the screen, because a terminal may move it when its size changes.
    pub fn forget(&mut self) {
        self.shown.clear();
    }

    /// Leaves the last screen in place, with the shell's prompt below it.
    pub fn leave(mut self, state: &mut State) -> Result<()> {
        self.show(state)?;
        drop(self);
        writeln!(stdout()).or_fail(&broken())
    }

    /// Writes all lines at once, each over the old text in its place, so that nothing flickers.
    fn draw(&self) -> io::Result<()> {
        let mut bytes = Vec::new();
        let coloured = AutoStream::choice(&stdout()) != ColorChoice::Never;
        queue!(bytes, MoveTo(0, 0))?;
        for (row, line) in self.shown.iter().enumerate() {
            if row > 0 {
                write!(bytes, "\r\n")?;
            }
            match coloured {
                true => write!(bytes, "{line}")?,
                false => write!(bytes, "{}", anstream::adapter::strip_str(line))?,
            }
            // The end of a style may have been cut off with a line.
            write!(bytes, "{Reset}")?;
            queue!(bytes, Clear(ClearType::UntilNewLine))?;
        }
        queue!(bytes, Clear(ClearType::FromCursorDown))?;
        stdout().write_all(&bytes)?;
        stdout().flush()
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        give_back();
    }
}

fn give_back() {
    // This error cannot be reported, because it would have to be printed on this terminal.
    let _ = terminal::disable_raw_mode();
}

/// Columns and rows.
fn size() -> (usize, usize) {
    match terminal::size() {
        Ok((columns, rows)) if columns > 0 && rows > 0 => (columns.into(), rows.into()),
        _ => (80, 24),
    }
}

fn broken() -> Error {
    Error::environment(
        "cannot use the terminal",
        "run this in another terminal, or in a pipe: … check --watch | cat",
    )
}
