//! Signals that end the program: an interrupt, or the end of the terminal.

use std::sync::mpsc::Sender;

use super::Event;
use pinhole_course::error::Result;

/// Turns signals that end the program into a quit event.
#[cfg(unix)]
pub fn listen(events: &Sender<Event>) -> Result<()> {
    use pinhole_course::error::ResultExt;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};

    let signals = signal_hook::iterator::Signals::new([SIGHUP, SIGINT, SIGTERM]);
    let mut signals =
        signals.or_environment("cannot listen for signals", "run this command again")?;
    let events = events.clone();
    std::thread::spawn(move || {
        for _ in signals.forever() {
            if events.send(Event::Quit).is_err() {
                break;
            }
        }
    });
    Ok(())
}

/// This system has no such signals.
#[cfg(not(unix))]
pub fn listen(_: &Sender<Event>) -> Result<()> {
    Ok(())
}
