//! The processes of a tree, read from `/proc`.

use std::collections::HashMap;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use pinhole::ask::Clock;
use rustix::process::{Pid, Signal, kill_process};

/// The time and memory that a tree of processes uses.
#[derive(Clone, Debug, Default)]
pub struct ResourceUsage {
    /// Processor time of all living processes and of the children they have waited for.
    pub cpu: Duration,
    /// Bytes in memory. Memory that several processes share is counted for each of them.
    pub memory: u64,
    /// Whether any thread runs, is ready to run, or waits for a disk.
    pub is_busy: bool,
    /// Whether any thread runs or is ready to run.
    pub is_ready: bool,
    /// The turns of each living thread, by its folder.
    turns: HashMap<PathBuf, Turns>,
}

/// How a thread got a processor so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Turns {
    /// How long it was ready to run but got no processor. The kernel adds to this whenever the thread
    /// gets its turn.
    waited: Duration,
    /// How often it got a processor.
    count: u64,
}

impl ResourceUsage {
    /// The longest time that a thread waited for a processor since then, as far as the kernel has
    /// counted it. Threads that sleep most of the time may be awake whenever we look, so looking at
    /// their states is not enough.
    fn waited_since(&self, then: &ResourceUsage) -> Duration {
        let before = |thread| then.turns.get(thread).copied().unwrap_or_default();
        let turns = self.turns.iter();
        let waited =
            turns.map(|(thread, turns)| turns.waited.saturating_sub(before(thread).waited));
        waited.max().unwrap_or_default()
    }
}

/// The time and memory that `pid` and its descendants use now. A process that ends meanwhile counts
/// as nothing.
pub fn used_by(pid: u32) -> ResourceUsage {
    let mut used = ResourceUsage::default();
    let mut ticks = 0;
    let mut found = vec![pid];
    while let Some(pid) = found.pop() {
        ticks += ticks_of(pid).unwrap_or(0);
        used.memory += memory_of(pid).unwrap_or(0);
        for state in threads(pid).filter_map(|thread| Some(stat(&thread)?.swap_remove(0))) {
            used.is_ready |= state == "R";
            used.is_busy |= state == "R" || state == "D";
        }
        let turns = |thread: PathBuf| Some((turns_of(&thread)?, thread));
        for (turns, thread) in threads(pid).filter_map(turns) {
            used.turns.insert(thread, turns);
        }
        found.extend(children(pid));
    }
    used.cpu = duration(ticks);
    used
}

/// A clock for `pid` and its descendants. It counts the time in which they sleep and the processor
/// time that they get, but runs no faster than the wall clock. It doesn't count the time in which the
/// calling thread gets no processor, because they may be waiting for its messages.
pub fn own_clock(pid: u32) -> Clock {
    let mut had = Duration::ZERO;
    let mut last = (Instant::now(), ResourceUsage::default(), our_turns());
    Box::new(move || {
        let (now, used, ours) = (Instant::now(), used_by(pid), our_turns());
        let passed = now - last.0;
        // If no thread had a turn, or the kernel doesn't count, we know only whether one is ready now.
        let ours_waited = ours.waited.saturating_sub(last.2.waited);
        let waited = match used.is_ready && used.turns == last.1.turns {
            true => passed,
            false => used.waited_since(&last.1).max(ours_waited).min(passed),
        };
        let ran = used.cpu.saturating_sub(last.1.cpu);
        had += (passed - waited).max(passed.min(ran));
        last = (now, used, ours);
        had
    })
}

/// The turns of the calling thread.
fn our_turns() -> Turns {
    turns_of(Path::new("/proc/thread-self")).unwrap_or_default()
}

/// Processor time of our own children that have ended, and of their children (fields 16 and
/// 17).
pub fn time_of_children() -> Option<Duration> {
    let fields = stat(&of_process(std::process::id()))?;
    let ticks = fields.get(13..15)?.iter().map(|field| field.parse::<u64>());
    ticks.sum::<Result<u64, _>>().ok().map(duration)
}

fn duration(ticks: u64) -> Duration {
    let per_second = rustix::param::clock_ticks_per_second();
    Duration::from_millis(ticks * 1000 / per_second.max(1))
}

/// Ends every process of a user id. Only foreign code may have this id.
pub fn end_all_of(uid: u32) {
    // Stop them all first, because each may start another one before it is killed.
    for signal in [Signal::STOP, Signal::KILL] {
        for _ in 0..50 {
            let left = processes_of(uid, signal);
            for pid in &left {
                let _gone = kill_process(*pid, signal);
            }
            if left.is_empty() {
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

/// Whether a user has any process.
pub fn is_used(uid: u32) -> bool {
    !processes_of(uid, Signal::KILL).is_empty()
}

/// The processes of a user that a signal has not reached yet.
fn processes_of(uid: u32, signal: Signal) -> Vec<Pid> {
    let done = match signal {
        Signal::STOP => ["T", "Z"],
        _ => ["X", "Z"],
    };
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let theirs = entries.filter(|entry| entry.metadata().is_ok_and(|about| about.uid() == uid));
    let ids = theirs.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    // A process whose first thread has ended seems to be a zombie, even if others are alive.
    let reached = |pid: u32| {
        let mut states = threads(pid).filter_map(|thread| stat(&thread));
        states.all(|fields| done.contains(&fields[0].as_str()))
    };
    ids.filter(|pid| !reached(*pid))
        .filter_map(|pid| Pid::from_raw(pid as i32))
        .collect()
}

/// The folders of a process's threads.
fn threads(pid: u32) -> impl Iterator<Item = PathBuf> {
    let threads = fs::read_dir(format!("/proc/{pid}/task"));
    let threads = threads.into_iter().flatten().flatten();
    threads.map(|thread| thread.path())
}

fn children(pid: u32) -> Vec<u32> {
    let lists = threads(pid).filter_map(|thread| fs::read_to_string(thread.join("children")).ok());
    lists
        .flat_map(|list| {
            let ids = list.split_whitespace().filter_map(|id| id.parse().ok());
            ids.collect::<Vec<u32>>()
        })
        .collect()
}

/// The fields of a process's or thread's `stat`, beginning with the third, which is its state.
/// The second is a name that may contain anything, even bytes that are not UTF-8.
fn stat(folder: &Path) -> Option<Vec<String>> {
    let bytes = fs::read(folder.join("stat")).ok()?;
    let text = String::from_utf8_lossy(&bytes);
    let (_, fields) = text.rsplit_once(')')?;
    Some(fields.split_whitespace().map(str::to_owned).collect())
}

/// The clock ticks, user and system, of a process and of its children that have ended (fields
/// 14 to 17).
fn ticks_of(pid: u32) -> Option<u64> {
    let fields = stat(&of_process(pid))?;
    let ticks = fields.get(11..15)?.iter().map(|field| field.parse::<u64>());
    ticks.sum::<Result<u64, _>>().ok()
}

/// `None` if the kernel does not count them.
fn turns_of(thread: &Path) -> Option<Turns> {
    let text = fs::read_to_string(thread.join("schedstat")).ok()?;
    let mut numbers = text.split_whitespace().map(str::parse::<u64>);
    Some(Turns {
        waited: Duration::from_nanos(numbers.nth(1)?.ok()?),
        count: numbers.next()?.ok()?,
    })
}

fn of_process(pid: u32) -> PathBuf {
    format!("/proc/{pid}").into()
}

/// The memory of a process. All its threads share it, but those that have ended have none.
fn memory_of(pid: u32) -> Option<u64> {
    let pages = threads(pid).filter_map(|thread| {
        let text = fs::read_to_string(thread.join("statm")).ok()?;
        text.split_whitespace().nth(1)?.parse::<u64>().ok()
    });
    let mut pages = pages.filter(|pages| *pages > 0);
    Some(pages.next()? * rustix::param::page_size() as u64)
}

#[cfg(test)]
mod tests;
