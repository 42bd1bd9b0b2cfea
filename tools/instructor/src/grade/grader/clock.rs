//! How long an answer may take: a limit in processor seconds, at least a hundred times what the
//! reference took for the same questions in the same run.
//!
//! Jobs run at the same time, and a busy machine must not cost students points. So if an answer or
//! the compiler exceeds its limit while other submissions are graded, the whole submission is put
//! off. When all others are done, it is graded again with nothing else running. Only what
//! exceeds its limit then, too, has timed out. The same goes for a program that dies, because the
//! system may have killed it for lack of memory, and for a failure of the grader or the sandbox.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use pinhole::ask::{Ending, Reply};
use pinhole::job::Job;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::compile;
use pinhole_course::error::{Error, Result};
use pinhole_course::examine::{self, Clock, Examiner, Selection};
use pinhole_course::goldens::Goldens;
use pinhole_course::overlay;
use pinhole_course::sandbox::{Limits, Sandbox, time_of_children};

/// An answer may take this many times the reference's own time.
const TIMES: u32 = 100;

/// A measured time may be too short by this much, because the counts of user time and of system
/// time may each lag by a tick.
const TICKS: Duration = Duration::from_millis(20);

/// The reference's own limit.
const WALL: Duration = Duration::from_secs(60);

/// How long the reference takes, by task and scene.
pub struct Pace {
    /// The shortest limit.
    least: Duration,
    took: BTreeMap<String, Duration>,
    /// How long the reference takes for everything.
    all: Duration,
}

/// The limit for everything is at least this many times the shortest limit, because an endless loop
/// in one answer must not cost the others their time.
const WHOLE: u32 = 12;

impl Pace {
    /// Asks the reference everything that submissions will be asked. It is our own code and runs
    /// without a sandbox, so that the system can measure it. Nothing else may run at the same
    /// time.
    ///
    /// # Errors
    /// If the reference fails anything, because then right answers would fail it, too.
    pub fn measure(
        assignment: &Assignment,
        goldens: &[&Goldens],
        checkout: &Checkout,
        least: Duration,
    ) -> Result<Pace> {
        let sandbox = Sandbox::Trusted;
        let reference = overlay::reference(assignment)?;
        let program = compile(&reference, assignment, checkout, &sandbox)?;
        let mut took: BTreeMap<String, Duration> = BTreeMap::new();
        let mut sum = Duration::ZERO;
        let mut measure = |what: &str, job: &Job| {
            let (start, before) = (Instant::now(), time_of_children());
            let reply = examine::run(
                &program,
                &sandbox,
                &Limits::of_answers(WALL),
                job,
                &mut |_| {},
            )?;
            if reply.ending != Ending::Complete {
                let problem = format!("the reference does not answer {what}: {:?}", reply.ending);
                return Err(Error::environment(problem, "run: cargo pinhole validate"));
            }
            // Take an upper bound, because the system counts in hundredths of a second. If it
            // does not count at all, assume that every core was busy.
            let counted = before.zip(time_of_children());
            let counted = counted.map(|(before, after)| after.saturating_sub(before) + TICKS);
            let all = start.elapsed() * cores();
            let most = counted.map_or(all, |counted| counted.min(all));
            let kept = took.entry(what.into()).or_default();
            *kept = most.max(*kept);
            sum += most;
            Ok(())
        };
        for goldens in goldens {
            for task in &assignment.tasks {
                for batch in &goldens.cached_questions(task)?.batches {
                    let job = batch.job.as_ref();
                    job.map_or(Ok(()), |job| measure(&task.name, job))?;
                }
            }
            for scene in &goldens.scenes {
                measure(&scene.name, &goldens.cached_scene(scene)?.job)?;
            }
            let examiner = Examiner {
                assignment,
                goldens,
                program: &program,
                sandbox: &sandbox,
                wall: WALL,
                interactive: false,
                second_judge: None,
                clock: None,
                withheld: &[],
                known: None,
                progress: &|_, _| {},
            };
            let outcome = examiner.examine(&reference, &Selection::default())?.outcome;
            if let Some((task, name, _)) = outcome.films().find(|(_, _, film)| !film.passes()) {
                let task = task.map_or(String::new(), |task| format!("{task}, "));
                let folder = goldens.folder.display();
                return Err(Error::environment(
                    format!("the reference does not match the golden of {task}{name} in {folder}"),
                    "render or draw these goldens again; if that does not help, report it",
                ));
            }
        }
        Ok(Pace {
            least,
            took,
            all: sum,
        })
    }

    /// How long a whole submission may take by the clock: also a hundred times what the
    /// reference takes. This limit ends code that stays just below every other limit.
    pub fn whole(&self) -> Duration {
        (self.least * WHOLE).max(rounded(self.all * TIMES))
    }

    /// The limits of a submission for a task or a scene.
    fn limits(&self, what: &str) -> Limits {
        let fair = rounded(self.took.get(what).copied().unwrap_or_default() * TIMES);
        Limits::of_processor(self.least.max(fair), fair)
    }
}

/// The next power of two, in seconds. It is the same in most runs, even if measured times vary a
/// little.
fn rounded(time: Duration) -> Duration {
    let seconds = time.as_secs_f64().ceil() as u64;
    Duration::from_secs(seconds.next_power_of_two())
}

fn cores() -> u32 {
    std::thread::available_parallelism().map_or(1, |cores| cores.get() as u32)
}

/// The clock of one submission.
pub struct SubmissionClock<'a> {
    pace: &'a Pace,
    /// Whether nothing else is graded at the same time.
    alone: bool,
}

impl<'a> SubmissionClock<'a> {
    /// A clock for a submission that is graded alone, or beside others.
    pub fn new(pace: &'a Pace, alone: bool) -> SubmissionClock<'a> {
        SubmissionClock { pace, alone }
    }

    /// Whether nothing else is graded at the same time.
    pub fn is_alone(&self) -> bool {
        self.alone
    }

    /// The error that ends the examination, because something exceeded its limit while other
    /// submissions were graded.
    pub fn late() -> Error {
        Error::environment(
            "it exceeded its time limit, or died, while other submissions were graded",
            "grade the submission again, alone",
        )
    }
}

impl Clock for SubmissionClock<'_> {
    fn limits(&self, what: &str) -> Limits {
        self.pace.limits(what)
    }

    /// Ends the examination if an answer exceeded its limit while other submissions were graded, or
    /// its process died, because their use of the machine may have been the reason.
    fn check(&self, reply: &Reply) -> Result<()> {
        match reply.ending {
            Ending::TimedOut(_) | Ending::OutOfTime(_) | Ending::Died(_) if !self.alone => {
                Err(Self::late())
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use pinhole::ask::Death;

    use super::*;

    #[test]
    fn no_limit_is_below_a_hundred_times_the_references_time() {
        let took = [("quick", 12), ("bunny", 560)];
        let took = took.map(|(what, millis)| (what.to_owned(), Duration::from_millis(millis)));
        let pace = Pace {
            least: Duration::from_secs(5),
            took: took.into(),
            all: Duration::from_millis(572),
        };
        assert_eq!(pace.whole(), Duration::from_secs(64));
        assert_eq!(pace.limits("quick").cpu, Duration::from_secs(5));
        assert_eq!(pace.limits("bunny").cpu, Duration::from_secs(64));
        assert_eq!(pace.limits("quick").shortest, Duration::from_secs(2));
        assert_eq!(pace.limits("bunny").shortest, Duration::from_secs(64));
    }

    #[test]
    fn only_a_death_beside_other_submissions_may_be_their_fault() {
        let pace = Pace {
            least: Duration::from_secs(5),
            took: BTreeMap::new(),
            all: Duration::ZERO,
        };
        let reply = |ending| Reply::unasked(&Job::Films(Vec::new()), ending);
        for killed in [Death::Signal(9), Death::Exit(1)] {
            let beside = SubmissionClock::new(&pace, false);
            assert!(beside.check(&reply(Ending::Died(killed.clone()))).is_err());
            let alone = SubmissionClock::new(&pace, true);
            assert!(alone.check(&reply(Ending::Died(killed))).is_ok());
        }
        let garbled = SubmissionClock::new(&pace, false);
        assert!(
            garbled
                .check(&reply(Ending::Garbled(String::new())))
                .is_ok()
        );
    }
}
