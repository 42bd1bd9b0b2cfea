//! Notices saves.
//!
//! The system's notices only wake us up. We then read the answer files and compare them with their
//! earlier text, so it does not matter whether an editor writes a file in place, renames it or
//! deletes it. If there are no notices, as on some network folders, polling finds the save a little
//! later.

use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use notify::event::{AccessKind, AccessMode};
use notify::{EventKind, RecommendedWatcher, RecursiveMode, Watcher};

use super::{Course, Event};
use pinhole_course::error::{Error, Result};
use pinhole_course::submission::{Answer, Submission};

/// How often we poll without a notice.
const PATROL: Duration = Duration::from_millis(500);

/// A save is over when nothing has happened for this long.
const QUIET: Duration = Duration::from_millis(20);

/// An empty or missing file may be in the middle of a save. Wait this long before believing it.
const GRACE: Duration = Duration::from_millis(250);

/// Reports every change of the answers. Runs on a separate thread.
pub fn listen(course: &Arc<Course>, events: Sender<Event>) {
    let course = Arc::clone(course);
    thread::spawn(move || watch(&course, &events));
}

fn watch(course: &Course, events: &Sender<Event>) {
    let mut seen = course.submission.clone();
    let mut lost = false;
    let (wake, woken) = mpsc::channel();
    let mut watcher = notices(&seen, &wake);
    loop {
        let notice = wait(&woken);
        let event = match look(course, &seen) {
            Ok(now) => {
                let tasks = changed(&seen, &now);
                let found = !tasks.is_empty() || lost;
                // A change came without a notice, so the folder may have been replaced.
                if found && (notice.is_none() || lost) || now.place != seen.place {
                    watcher = notices(&now, &wake);
                }
                seen = now;
                lost = false;
                found.then(|| Event::Saved {
                    submission: seen.clone(),
                    at: written(&seen, &tasks, notice.unwrap_or_else(Instant::now)),
                    tasks,
                })
            }
            Err(error) => (!std::mem::replace(&mut lost, true)).then_some(Event::Lost(error)),
        };
        if event.is_some_and(|event| events.send(event).is_err()) {
            break;
        }
    }
    drop(watcher);
}

/// Waits for a notice and for the pause after it. Returns the time of the notice, or `None` if it
/// is time to poll.
fn wait(woken: &Receiver<Instant>) -> Option<Instant> {
    match woken.recv_timeout(PATROL) {
        Ok(at) => {
            let most = Instant::now() + GRACE;
            while Instant::now() < most && woken.recv_timeout(QUIET).is_ok() {}
            Some(at)
        }
        Err(RecvTimeoutError::Timeout) => None,
        // Notices don't work here.
        Err(RecvTimeoutError::Disconnected) => {
            thread::sleep(PATROL);
            None
        }
    }
}

/// Asks the system for notices of the folder; `None` if it has none.
fn notices(submission: &Submission, wake: &Sender<Instant>) -> Option<RecommendedWatcher> {
    let wake = wake.clone();
    let wake = move |event: notify::Result<notify::Event>| {
        let is_reading = |kind: &EventKind| {
            matches!(kind, EventKind::Access(access)
                if *access != AccessKind::Close(AccessMode::Write))
        };
        // Our own reading must not wake us up.
        if event.is_ok_and(|event| !is_reading(&event.kind)) {
            let _ = wake.send(Instant::now());
        }
    };
    let mut watcher = notify::recommended_watcher(wake).ok()?;
    // Watch the folder and not the files. A file that is renamed over another is a new file.
    watcher
        .watch(&submission.place, RecursiveMode::NonRecursive)
        .ok()?;
    Some(watcher)
}

/// The current answers. Reads them again if a save seems to be under way.
fn look(course: &Course, seen: &Submission) -> Result<Submission> {
    let end = Instant::now() + GRACE;
    loop {
        let found = Submission::find(&seen.folder, &course.assignment);
        // The sandbox was chosen for the place where the answers were.
        let found = found.and_then(|now| match now.read_from == seen.read_from {
            true => Ok(now),
            false => Err(Error::input(
                format!("{} leads to another place now", seen.folder.display()),
                "start the command again",
            )),
        });
        let is_whole = |now: &Submission| !now.answers.iter().any(|now| is_half_saved(now, seen));
        if found.as_ref().is_ok_and(is_whole) || Instant::now() > end {
            return found;
        }
        thread::sleep(QUIET);
    }
}

/// Whether a file is now empty or gone, and was not before.
fn is_half_saved(answer: &Answer, seen: &Submission) -> bool {
    let is_blank = |answer: &Answer| answer.text.as_ref().map_or(true, |text| text.is_empty());
    is_blank(answer) && !seen.answer(&answer.task).is_some_and(is_blank)
}

/// The tasks whose answers differ.
fn changed(seen: &Submission, now: &Submission) -> Vec<String> {
    let differs = |answer: &&Answer| seen.answer(&answer.task) != Some(answer);
    let answers = now.answers.iter().filter(differs);
    answers.map(|answer| answer.task.clone()).collect()
}

/// When the files were written, by their own dates if these can be trusted. A copied file may
/// keep an old date, and a network folder has a clock of its own.
fn written(submission: &Submission, tasks: &[String], noticed: Instant) -> Instant {
    let age = |task: &String| {
        let file = submission.place.join(task).with_extension("rs");
        let modified = file.symlink_metadata().ok()?.modified().ok()?;
        SystemTime::now().duration_since(modified).ok()
    };
    let age = tasks.iter().filter_map(age).min();
    let believed = age.filter(|age| *age < 2 * (PATROL + GRACE));
    believed
        .and_then(|age| Instant::now().checked_sub(age))
        .unwrap_or(noticed)
}
