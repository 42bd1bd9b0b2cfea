//! Asks a submission about each task and each scene, each in a process of its own.

use std::panic::resume_unwind;
use std::thread;
use std::time::Duration;

use pinhole::ask::{Ending, Reply};
use pinhole::job::Job;

use super::Examiner;
use crate::assignment::Task;
use crate::compile::Program;
use crate::error::{Result, ResultExt};
use crate::goldens::questions::{Group, QuestionFilm, Questions};
use crate::sandbox::{Limits, Sandbox};
use crate::timings::{self, timed};

/// Limits that differ from one task or scene to another.
pub trait Clock: Sync {
    /// The limits of the process that is asked about `what`, a task or a scene.
    fn limits(&self, what: &str) -> Limits;

    /// Called with every reply; an error ends the examination.
    fn check(&self, reply: &Reply) -> Result<()>;
}

/// Complete replies of other submissions. They are used again for tasks and scenes whose answer
/// files are the same.
pub trait KnownReplies: Sync {
    /// The reply to this many questions of a task, or to a scene.
    fn get(&self, what: &str, questions: usize) -> Option<Reply>;

    /// Called with every such reply that was asked for.
    fn keep(&self, what: &str, reply: &Reply);
}

/// The shortest limit for a process. Starting it takes time, which must not count against the
/// student.
const LEAST_WALL: Duration = Duration::from_secs(2);

/// When a class is graded, a task may have this many late films. After that, its other films count
/// as late too, because a loop that shows nearly everywhere would hold up the class for minutes.
const MOST_LATE: usize = 3;

impl Examiner<'_> {
    /// A task's groups that are withheld, or the others, with a reply to each film.
    pub(super) fn ask_task<'q>(
        &self,
        task: &Task,
        questions: &'q Questions,
        withheld: bool,
    ) -> Result<Vec<(&'q Group, Vec<Reply>)>> {
        let mut asked = Vec::new();
        for (groups, job) in questions.batches() {
            if groups.iter().any(|group| self.withholds(task, &group.name)) != withheld {
                continue;
            }
            let films = groups.iter().flat_map(|group| &group.films);
            let mut replies = self.ask_batch(task, films.collect(), job)?.into_iter();
            let of_group = |group: &'q Group| {
                let replies = replies.by_ref().take(group.films.len());
                (group, replies.collect())
            };
            asked.extend(groups.iter().map(of_group));
        }
        Ok(asked)
    }

    fn ask_batch(
        &self,
        task: &Task,
        films: Vec<&QuestionFilm>,
        job: Option<&Job>,
    ) -> Result<Vec<Reply>> {
        let parts = match self.ask_together(task, job, &films)? {
            // Either all is well, or every film failed and would fail just as slowly when asked
            // alone.
            Some(parts) if parts.iter().all(Reply::is_whole) => return Ok(parts),
            Some(parts) if !parts.iter().any(Reply::is_whole) => return Ok(parts),
            Some(parts) => parts.into_iter().map(Some).collect(),
            None => vec![None; films.len()],
        };
        // An endless loop may take at most twice the limit, whichever group it is in.
        let share = (self.wall / films.len().max(1) as u32).max(LEAST_WALL);
        let ask = |film: &QuestionFilm, part: Option<Reply>| match part {
            Some(part) if part.is_whole() => Ok(part),
            _ => self.ask_alone(task, &film.job, share),
        };
        let films = films.into_iter().zip(parts);
        if !self.asks_several() {
            let mut late: Vec<Ending> = Vec::new();
            let ask = |(film, part): (&QuestionFilm, _)| {
                if late.len() == MOST_LATE && self.clock.is_some() {
                    return Ok(Reply::unasked(&film.job, late[0].clone()));
                }
                let reply: Reply = ask(film, part)?;
                if let Ending::TimedOut(_) = reply.ending {
                    late.push(reply.ending.clone());
                }
                Ok(reply)
            };
            return films.map(ask).collect();
        }
        let ask = &ask;
        // Ask about all films at once, so that late ones use up their time limits together.
        thread::scope(|scope| {
            let asked = films.map(|(film, part)| scope.spawn(move || ask(film, part)));
            let asked: Vec<_> = asked.collect();
            let joined = asked.into_iter().map(|asked| asked.join());
            joined
                .map(|reply| reply.unwrap_or_else(|panic| resume_unwind(panic)))
                .collect()
        })
    }

    /// Asks about one film of a task.
    fn ask_alone(&self, task: &Task, job: &Job, wall: Duration) -> Result<Reply> {
        let mut reply = self.ask(&task.name, job, wall)?;
        self.find_death(&task.name, job, wall, &mut reply)?;
        Ok(reply)
    }

    /// If someone waits for the result, and an answer ended its process, for instance because its
    /// stack overflowed, this finds the first question at which that happens. A dead process can't
    /// say where it was, so this asks about fewer and fewer of the questions.
    pub(super) fn find_death(
        &self,
        what: &str,
        job: &Job,
        wall: Duration,
        reply: &mut Reply,
    ) -> Result<()> {
        if !self.interactive || !matches!(reply.ending, Ending::Died(_)) {
            return Ok(());
        }
        let (mut first, mut end) = (0, job.len());
        while end - first > 1 {
            // Usually it is one of the first. So ask about 1 question, then the next 2, 4, 8
            // and so on. Once an answer has ended its process, halve.
            let middle = (2 * first + 1).min(usize::midpoint(first, end));
            let Some(part) = job.part(first..middle) else {
                return Ok(());
            };
            match self.ask(what, &part, wall)?.is_whole() {
                true => first = middle,
                false => end = middle,
            }
        }
        // It may also have died of many answers together.
        let alone = job.part(first..first + 1).filter(|_| first < job.len());
        let alone = alone.map(|part| self.ask(what, &part, wall)).transpose()?;
        reply.still_at = alone
            .is_some_and(|alone| !alone.is_whole())
            .then_some(first);
        Ok(())
    }

    /// Asks about all films of a task in one process. `None` if some answer fails in a way that
    /// could hide the others; then ask about each film alone, so that the failing answer costs only
    /// its own group. If someone waits for the result, films that were complete before an answer
    /// was late are kept.
    fn ask_together(
        &self,
        task: &Task,
        job: Option<&Job>,
        films: &[&QuestionFilm],
    ) -> Result<Option<Vec<Reply>>> {
        // If tests are counted, code could do all tests once, leave the answers behind, panic, and find
        // them when it is asked again. So nothing that gets a mark is asked twice.
        let Some(job) = job.filter(|job| self.clock.is_none() || !job.is_counted()) else {
            return Ok(None);
        };
        let mut reply = self.ask_whole(&task.name, job)?;
        match &reply.ending {
            Ending::Complete => {}
            Ending::TimedOut(_) if self.interactive => {}
            Ending::TimedOut(_) => {
                self.sandbox.forgive();
                return Ok(None);
            }
            _ => return Ok(None),
        }
        let printed = std::mem::take(&mut reply.printed);
        let mut parts = reply.split(films.iter().map(|film| film.job.len()));
        if let Some(first) = parts.first_mut() {
            first.printed = printed;
        }
        Ok(Some(parts))
    }

    /// The reply to all that is asked about a task or a scene.
    pub(super) fn ask_whole(&self, what: &str, job: &Job) -> Result<Reply> {
        if let Some(reply) = self.known.and_then(|known| known.get(what, job.len())) {
            return Ok(reply);
        }
        let reply = self.ask(what, job, self.wall)?;
        if let (Some(known), Ending::Complete) = (self.known, &reply.ending) {
            known.keep(what, &reply);
        }
        Ok(reply)
    }

    pub(super) fn ask(&self, what: &str, job: &Job, wall: Duration) -> Result<Reply> {
        let reply = self.ask_without_check(what, job, wall)?;
        if let Some(clock) = self.clock {
            clock.check(&reply)?;
        }
        Ok(reply)
    }

    /// Asks, even if [`Clock::check`] would refuse the reply.
    pub(super) fn ask_without_check(&self, what: &str, job: &Job, wall: Duration) -> Result<Reply> {
        let limits = match self.clock {
            Some(clock) => clock.limits(what),
            None if self.interactive => Limits::of_own_answers(wall),
            None => Limits::of_answers(wall),
        };
        let reply = timed(&format!("ask {what}"), || {
            run(self.program, self.sandbox, &limits, job, &mut |done| {
                (self.progress)(what, done as f64 / job.len().max(1) as f64);
            })
        })?;
        let start = reply.start.unwrap_or_default();
        timings::add("start programs (part of asking)", start);
        Ok(reply)
    }
}

/// Runs a program on one job.
pub fn run(
    program: &Program,
    sandbox: &Sandbox,
    limits: &Limits,
    job: &Job,
    progress: &mut dyn FnMut(usize),
) -> Result<Reply> {
    let stop = program.stop.clone();
    let asked = sandbox.ask(&program.executable, job, limits, stop, progress);
    asked.or_environment(
        format_args!("cannot ask {}", program.executable.display()),
        "run this command again; if the problem persists, remove target/pinhole",
    )
}
