use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use pinhole::ask::BUSY;

use super::{ResourceUsage, Turns, end_all_of, is_used, own_clock, used_by};
use crate::sandbox::watch::{ExceededLimit, Watch};
use crate::sandbox::{Limits, finish};

fn shell(line: &str) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-c", line]).stdin(Stdio::null());
    shell
}

fn limits() -> Limits {
    Limits::of_answers(Duration::from_secs(20))
}

/// Waits until a tree of processes meets a condition.
#[track_caller]
fn eventually(child: &mut Child, condition: impl Fn(u32) -> bool) {
    let start = Instant::now();
    while !condition(child.id()) {
        assert!(start.elapsed() < Duration::from_secs(10), "it never came");
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().expect("it can be ended");
    child.wait().expect("it can be waited for");
}

#[test]
fn memory_of_a_grandchild_counts() {
    // `tail` keeps all that it has read, because no line ends.
    let line = "sh -c '(head -c 60000000 /dev/zero; sleep 9) | tail >/dev/null; true'; true";
    let mut child = shell(line).spawn().expect("there is a shell");
    eventually(&mut child, |pid| used_by(pid).memory > 50_000_000);
}

#[test]
fn a_process_whose_first_thread_has_ended_counts_and_is_ended() {
    let uid = 54_321;
    let lines = format!(
        "import ctypes, threading, time
memory = b'x' * 60_000_000
threading.Thread(target=lambda: time.sleep(60)).start()
ctypes.CDLL(None).syscall({}, 0)",
        libc::SYS_exit
    );
    let mut python = Command::new("/usr/bin/python3");
    python.args(["-c", &lines]).stdin(Stdio::null());
    let is_root = rustix::process::geteuid().is_root();
    if is_root {
        std::os::unix::process::CommandExt::uid(&mut python, uid);
    }
    let mut child = python.spawn().expect("there is Python");
    let seems_dead = |pid| {
        let state = super::stat(&super::of_process(pid)).map(|fields| fields[0] == "Z");
        state == Some(true) && used_by(pid).memory > 50_000_000
    };
    if is_root {
        let start = Instant::now();
        while !seems_dead(child.id()) && start.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(5));
        }
        let was_used = is_used(uid);
        end_all_of(uid);
        assert!(was_used && !is_used(uid));
        child.wait().expect("it has been ended");
    } else {
        eventually(&mut child, seems_dead);
    }
}

#[test]
fn time_of_children_that_have_ended_counts() {
    let line = "i=0; while [ $i -lt 40 ]; do head -c 20000000 /dev/zero | tail -c 1 >/dev/null; \
                i=$((i+1)); done; sleep 9";
    let mut child = shell(line).spawn().expect("there is a shell");
    eventually(&mut child, |pid| {
        used_by(pid).cpu > Duration::from_millis(200)
    });
}

#[test]
fn a_name_that_is_not_utf_8_hides_no_time() {
    let line = "ulimit -t 5; printf '\\377\\376' > /proc/$$/comm; while :; do :; done";
    let mut child = shell(line).spawn().expect("there is a shell");
    eventually(&mut child, |pid| {
        let used = used_by(pid);
        used.is_busy && used.cpu > Duration::from_millis(200)
    });
}

#[test]
fn a_tree_that_takes_too_much_memory_is_ended_though_each_process_takes_little() {
    let one = "(head -c 40000000 /dev/zero; sleep 15) | tail >/dev/null & ";
    let limits = Limits {
        memory: 100_000_000,
        ..limits()
    };
    let line = one.repeat(6) + "wait";
    let finished = finish(shell(&line), &limits, |pid| Watch::tree(pid, limits));
    assert_eq!(
        finished.expect("there is a shell").exceeded,
        Some(ExceededLimit::Memory(limits.memory))
    );
}

#[test]
fn a_tree_that_takes_too_long_on_the_processor_is_ended() {
    let limits = Limits {
        // The kernel counts in hundredths of a second.
        cpu: Duration::from_millis(305),
        ..limits()
    };
    // Without a sandbox, this process must end by itself.
    let line = "ulimit -t 2; (while :; do :; done) & wait";
    let finished = finish(shell(line), &limits, |pid| Watch::tree(pid, limits));
    assert_eq!(
        finished.expect("there is a shell").exceeded,
        Some(ExceededLimit::Cpu(limits.cpu))
    );
}

#[test]
fn a_tree_that_sleeps_is_ended_and_one_that_works_is_not() {
    let limits = Limits {
        idle: Duration::from_millis(300),
        wall: Duration::from_secs(3),
        ..limits()
    };
    let exceeded = |line| {
        let finished = finish(shell(line), &limits, |pid| Watch::tree(pid, limits));
        finished.expect("there is a shell").exceeded
    };
    assert_eq!(
        exceeded("sleep 15 & wait"),
        Some(ExceededLimit::Idle(limits.idle))
    );
    let naps = "ulimit -t 9; while :; do sleep 0.2; i=0; while [ $i -lt 100000 ]; do i=$((i+1)); \
                done; done";
    assert_eq!(exceeded(naps), None, "each nap is short");
    // It is ready to run, although the processor may have no time for it.
    assert_eq!(
        exceeded("ulimit -t 9; exec nice -n 19 sh -c 'while :; do :; done'"),
        None
    );
}

/// A command that any other process on the same core comes before.
const LAST: &str = "ulimit -t 9; exec nice -n 19 taskset -c 0 sh -c 'while :; do :; done'";

/// A command that is ended when this is dropped.
struct Started(Child);

impl Started {
    fn new(line: &str) -> Started {
        Started(shell(line).spawn().expect("there is a shell"))
    }

    /// Keeps a core busy.
    fn busy() -> [Started; 4] {
        ["ulimit -t 19; exec taskset -c 0 sh -c 'while :; do :; done'"; 4].map(Started::new)
    }
}

impl Drop for Started {
    fn drop(&mut self) {
        self.0.kill().expect("it can be ended");
        self.0.wait().expect("it can be waited for");
    }
}

#[test]
fn the_own_clock_of_a_tree_that_gets_no_processor_stands_still() {
    let all = [
        LAST,
        "exec sleep 9",
        "kill -STOP $$",
        // It waits for its child in the state of a process that waits for a disk.
        "exec python3 -c 'import ctypes as c; l = c.CDLL(None); l.vfork() or l.sleep(9)'",
    ]
    .map(Started::new);
    while super::children(all[3].0.id()).is_empty() {
        std::thread::sleep(Duration::from_millis(10));
    }
    let busy = Started::busy();
    let mut clocks = all.each_ref().map(|child| own_clock(child.0.id()));
    let enough = Duration::from_millis(1500);
    let begin = Instant::now();
    // All clocks stand still while this thread gets no processor either.
    let [last, asleep, stopped, waiting] = loop {
        std::thread::sleep(Duration::from_millis(50));
        let times = clocks.each_mut().map(|clock| clock());
        // Nobody keeps the others from running.
        let are_over = times[1..].iter().all(|time| *time > enough);
        if are_over || begin.elapsed() > Duration::from_secs(8) {
            break times;
        }
    };
    drop((all, busy));
    assert!(last < enough / 3, "{last:?}");
    assert!(asleep > enough, "{asleep:?}");
    assert!(stopped > enough, "{stopped:?}");
    assert!(waiting > enough, "{waiting:?}");
}

#[test]
fn a_thread_that_waits_counts_though_another_has_waited_longer_before() {
    let used = |waits: &[(&str, u64)]| ResourceUsage {
        turns: waits
            .iter()
            .map(|(thread, milliseconds)| {
                let waited = Duration::from_millis(*milliseconds);
                (thread.into(), Turns { waited, count: 1 })
            })
            .collect(),
        ..ResourceUsage::default()
    };
    let then = used(&[("asleep", 5000), ("works", 100), ("has ended", 9000)]);
    let now = used(&[("asleep", 5000), ("works", 140), ("is new", 30)]);
    assert_eq!(now.waited_since(&then), Duration::from_millis(40));
    assert_eq!(now.waited_since(&now), Duration::ZERO);
}

#[test]
fn output_is_cut_and_waiting_is_ended_by_the_clock() {
    let limits = Limits {
        wall: Duration::from_secs(1),
        ..limits()
    };
    let start = Instant::now();
    let finished = finish(shell("yes >&2"), &limits, |_| Watch::nothing()).expect("a shell");
    assert!(
        finished.stderr.len() <= super::super::finish::MOST_SAID,
        "too much was kept"
    );
    assert!(!finished.status.success());
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn the_own_clock_of_a_tree_that_sleeps_most_of_the_time_runs() {
    // They wake up many times between two looks.
    let naps = "i=0; while [ $i -lt 3000 ]; do i=$((i+1)); sleep 0.002; done";
    let mut child = shell(&format!("({naps}) & ({naps}) & {naps}"))
        .spawn()
        .expect("there is a shell");
    let mut clock = own_clock(child.id());
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(2) {
        std::thread::sleep(Duration::from_millis(50));
        clock();
    }
    // On a busy machine, they may also have to wait.
    let had = clock();
    let turns = used_by(child.id()).turns;
    let waited: Duration = turns.values().map(|turns| turns.waited).sum();
    child.kill().expect("it can be ended");
    child.wait().expect("it can be waited for");
    assert!(
        had + waited > Duration::from_millis(1800),
        "{had:?} {waited:?}"
    );
}

#[test]
fn a_command_is_late_by_its_own_clock_and_starved_only_if_others_had_most_of_the_time() {
    let limits = Limits {
        wall: Duration::from_millis(300),
        ..limits()
    };
    let _busy = Started::busy();
    for (line, starved) in [("exec sleep 9", false), (LAST, true)] {
        let begin = Instant::now();
        let finished = finish(shell(line), &limits, |_| Watch::nothing()).expect("a shell");
        assert_eq!((finished.late, finished.starved), (true, starved), "{line}");
        assert_eq!(
            finished.waited > limits.wall,
            starved,
            "{line}: {:?}",
            finished.waited
        );
        assert_eq!(begin.elapsed() >= limits.wall * BUSY, starved, "{line}");
    }
}
