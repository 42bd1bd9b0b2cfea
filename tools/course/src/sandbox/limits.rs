//! How much of the machine foreign code may use.

use std::time::Duration;

/// Bounds on one process and all processes that it starts.
///
/// A mark must not depend on what else the machine does. So `cpu` counts seconds of processor time,
/// summed over all threads and processes, and `wall` is only for code that waits for something.
/// Even processor time depends a little on other jobs, because they share caches, memory and the
/// processor's clock speed. So choose `cpu` at least a hundred times what the reference takes, and
/// count a timeout only if it happens again when the submission runs alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Seconds of processor time, summed over the whole tree.
    pub cpu: Duration,
    /// Time on a clock that stands still while the tree gets no processor, but at most
    /// [`BUSY`](pinhole::ask::BUSY) times as long.
    pub wall: Duration,
    /// Time on the same clock between two answers, at most `wall`.
    pub silence: Duration,
    /// Time on the clock in which no thread of the tree runs or is ready to run, because it
    /// sleeps or waits. A tree is not idle just because the machine is busy.
    pub idle: Duration,
    /// Bytes in use by all processes together.
    pub memory: u64,
    /// Bytes of address space of each process. Beyond it, the kernel refuses more. For an answer,
    /// it is larger than `memory`, so that the watchdog sees too much memory in use before the
    /// kernel refuses more. A refusal would make the answer abort with a message from Rust, which
    /// any answer could print itself.
    pub address_space: u64,
    /// Processes and threads together.
    pub processes: u64,
    /// Bytes of the longest file that may be written.
    pub file_size: u64,
    /// Open files of one process.
    pub open_files: u64,
    /// The least that `cpu` is shortened to, however much time a submission has lost.
    pub shortest: Duration,
}

/// 1 GiB is enough for rustc, but half of that is not.
const ADDRESS_SPACE: u64 = 2 << 30;

/// A hundred times what the reference takes for the questions of any task.
const SHORTEST: Duration = Duration::from_secs(1);

/// Twenty times what right answers take to compile.
const SHORTEST_OF_COMPILER: Duration = Duration::from_secs(5);

/// Code that is limited in processor time has nothing to wait for, because it has no network and no
/// other process.
const IDLE: Duration = Duration::from_secs(1);

/// The compiler waits for files, and on some file systems that looks like sleeping.
const IDLE_COMPILER: Duration = Duration::from_secs(5);

/// The shortest silence after which we give up on an answer while its author waits.
const LEAST_SILENCE: Duration = Duration::from_secs(2);

/// How many threads the code may have in addition to those that answer on all cores.
const SPARE_PROCESSES: u64 = 32;

impl Limits {
    /// Limits for one run of the compiler. Right answers take a fifth of a second.
    pub fn of_compiler() -> Limits {
        Limits {
            cpu: Duration::from_secs(20),
            wall: Duration::from_secs(60),
            silence: Duration::from_secs(60),
            idle: IDLE_COMPILER,
            memory: ADDRESS_SPACE,
            address_space: ADDRESS_SPACE,
            processes: cores() + SPARE_PROCESSES,
            file_size: 64 << 20,
            open_files: 256,
            shortest: SHORTEST_OF_COMPILER,
        }
    }

    /// Limits for a built program that may take `time` to answer, on every core.
    pub fn of_answers(time: Duration) -> Limits {
        let cpu = time * cores() as u32 + Duration::from_secs(2);
        Limits {
            cpu,
            wall: cpu,
            silence: time,
            idle: time,
            memory: ADDRESS_SPACE / 2,
            file_size: 0,
            open_files: 64,
            shortest: SHORTEST,
            ..Limits::of_compiler()
        }
    }

    /// Like [`Limits::of_answers`], but for someone who waits for their own code. So an endless
    /// loop is noticed long before `wall`.
    pub fn of_own_answers(wall: Duration) -> Limits {
        Limits {
            wall,
            silence: (wall / SILENCE).max(LEAST_SILENCE).min(wall),
            ..Limits::of_answers(wall)
        }
    }

    /// Limits of `cpu` seconds of the processor, on any number of cores. Code that waits is ended by
    /// the limit on silence. They never get shorter than `shortest`, however much time a submission
    /// has lost.
    pub fn of_processor(cpu: Duration, shortest: Duration) -> Limits {
        Limits {
            cpu,
            wall: wall_of(cpu),
            silence: wall_of(cpu),
            idle: IDLE,
            shortest: shortest.max(SHORTEST),
            ..Limits::of_answers(cpu)
        }
    }

    /// These limits for a submission that has lost too much time.
    pub fn shortened(self) -> Limits {
        Limits {
            cpu: self.cpu.min(self.shortest),
            wall: self.wall.min(wall_of(self.shortest)),
            silence: self.silence.min(wall_of(self.shortest)),
            ..self
        }
    }
}

/// While its author waits, a process may be silent for this fraction of its time: 2 s of 30. A
/// message holds 256 answers. On the largest mesh, the reference needs 13 ms for them, and a
/// program that is sixty times slower needs less than half of the limit.
const SILENCE: u32 = 15;

/// Doubles the time, because a program may also wait.
fn wall_of(cpu: Duration) -> Duration {
    cpu * 2 + Duration::from_secs(2)
}

/// The number of threads that answer.
fn cores() -> u64 {
    std::thread::available_parallelism().map_or(1, usize::from) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: Duration = Duration::from_secs(1);

    #[test]
    fn an_answer_gets_every_core_until_it_is_silent_for_too_long_and_writes_no_file() {
        let time = 10 * SECOND;
        let limits = Limits::of_answers(time);
        assert_eq!((limits.silence, limits.idle), (time, time));
        let cores = std::thread::available_parallelism().unwrap().get() as u32;
        assert_eq!(limits.wall, limits.cpu);
        assert!(limits.cpu > time * cores && limits.cpu < (time + SECOND) * cores + 5 * SECOND);
        // The watchdog sees what is used before the kernel refuses more.
        assert!(limits.memory >= 1 << 30 && limits.memory < limits.address_space);
        assert!((8..=32).contains(&(limits.processes - u64::from(cores))));
        assert_eq!((limits.file_size, limits.open_files), (0, 64));
    }

    #[test]
    fn an_author_waits_a_fifteenth_of_the_time_for_a_silent_answer_but_at_least_two_seconds() {
        let silence = |wall: u32| {
            let limits = Limits::of_own_answers(wall * SECOND);
            assert_eq!(limits.wall, wall * SECOND);
            limits.silence
        };
        assert_eq!(
            [1, 15, 30, 60].map(silence),
            [1, 2, 2, 4].map(|it: u32| it * SECOND)
        );
    }

    #[test]
    fn limits_of_the_processor_allow_for_a_busy_machine_and_end_what_waits() {
        let (long, short) = (16 * SECOND, SECOND / 2);
        let limits = Limits::of_processor(long, short);
        let clock = 34 * SECOND;
        assert_eq!(
            (limits.cpu, limits.wall, limits.silence),
            (long, clock, clock)
        );
        assert_eq!(limits.idle, SECOND);
        // An answer may need this long for a task, whatever the submission has lost.
        assert_eq!(limits.shortest, SECOND);
        let shortened = limits.shortened();
        assert_eq!((shortened.cpu, shortened.silence), (SECOND, 4 * SECOND));
        assert_eq!(Limits::of_answers(long).shortened().cpu, SECOND);
    }
}
