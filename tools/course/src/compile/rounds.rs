//! Compiles one submission in several rounds, until the answers that are left compile.

#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::mem;
use std::path::{Path, PathBuf};

use pinhole::ask::Stop;

use super::blame::{self, Blamed, Diagnostic};
use super::build::{self, BuildResult, Sources, build};
use super::{Attempt, Compiler, Program, Replacement, Replacements, WithOurs};
use crate::error::{Error, Result};
use crate::handout_record::Package;
use crate::shell;
use crate::stubs;
use crate::submission::allow_list::{self, Verdict};
use crate::submission::tokens::{PATH, Token, tokens};
use crate::submission::{Answer, AnswerFileProblem, Submission};
use crate::timings::timed;

/// One submission, and what compiles it.
pub struct Rounds<'a> {
    compiler: &'a Compiler,
    submission: &'a Submission,
    /// The folder of the answers, as messages name it.
    shown_in: String,
}

/// Why a run of the compiler has no result.
pub enum Stopped {
    /// It was late.
    Late,
    /// It could not run.
    Failed(Error),
}

impl From<Error> for Stopped {
    fn from(error: Error) -> Stopped {
        Stopped::Failed(error)
    }
}

/// A program, and what the compiler warned about.
type Built = (PathBuf, Vec<Diagnostic>);

impl<'a> Rounds<'a> {
    pub fn new(compiler: &'a Compiler, submission: &'a Submission) -> Rounds<'a> {
        let shown_in = match compiler.names_places {
            true => place_from_here(submission),
            false => None,
        };
        Rounds {
            compiler,
            submission,
            shown_in: shown_in.unwrap_or(build::SRC.into()),
        }
    }

    /// See [`Compiler::compile_until`]; `is_done` says whether the time is up.
    pub fn attempt(
        &self,
        is_done: &dyn Fn() -> bool,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt> {
        match self.run(is_done, enough) {
            Ok(attempt) => Ok(attempt),
            Err(Stopped::Late) => Ok(Attempt::Late),
            Err(Stopped::Failed(error)) => Err(error),
        }
    }

    fn run(
        &self,
        is_done: &dyn Fn() -> bool,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt, Stopped> {
        let (mut replaced, mut unclear) = self.refused_unread();
        let mut is_last = false;
        let mut blamed_so_far = Blamed::default();
        // Each round replaces at least one answer, except the last one, and one after a compiler that
        // failed for no answer's fault. So there are at most this many rounds.
        for _ in 0..self.submission.answers.len() + 2 {
            if enough(&replaced) {
                return Ok(Attempt::Enough);
            }
            // Each round may take nearly as long as the limit for one run of the compiler, so
            // only two begin after the time is up: one to find all answers that don't compile,
            // and one without them.
            let was_last = is_last;
            is_last = is_done();
            if is_last && self.compiler.stops_when_late {
                return Err(Stopped::Late);
            }
            match self.compile(&replaced)? {
                BuildResult::Program {
                    executable,
                    warnings,
                } => {
                    let blamed = mem::take(&mut blamed_so_far);
                    let mut built = (executable, warnings);
                    self.restore(&blamed, &mut replaced, &mut built, is_done)?;
                    unclear.retain(|task| !replaced.contains_key(*task));
                    if unclear.is_empty() {
                        return Ok(Attempt::Program(self.program(built, replaced)?));
                    }
                    let tasks = unclear.drain(..);
                    replaced.extend(tasks.map(|task| (task.clone(), unclear_tokens(task))));
                }
                BuildResult::Refused { .. } if was_last => {
                    replaced.extend(blame::all(self.submission, &replaced));
                }
                BuildResult::Refused { diagnostics, .. } => {
                    let blamed = self.blamed(&diagnostics, &replaced, is_last)?;
                    replaced.extend(blamed.replaced.clone());
                    blamed_so_far.extend(blamed);
                }
            }
        }
        let wrong = "the stubs do not compile";
        let remedy = "restore the assignment's `reference` folder, which they are made from";
        Err(Error::environment(wrong, remedy).into())
    }

    /// The answers to replace after these errors.
    fn blamed(
        &self,
        diagnostics: &[Diagnostic],
        replaced: &Replacements,
        is_last: bool,
    ) -> Result<Blamed, Stopped> {
        // Leaving this one out costs no points.
        if let Some((task, BuildResult::Program { .. })) = self.without_earlier(replaced)? {
            let mut blamed = Blamed::default();
            blamed.add(task, diagnostics);
            return Ok(blamed);
        }
        let blamed = blame::by_place(diagnostics, self.submission, replaced);
        if !blamed.replaced.is_empty() && !is_last {
            return Ok(blamed);
        }
        let compile = |replaced: &Replacements| self.compile(replaced);
        let blamed = blame::apart(self.submission, replaced, compile)?;
        Ok(blamed.ok_or_else(|| blame::not_theirs(diagnostics))?)
    }

    /// The answers that are refused before the compiler reads them, and the tasks of those that are
    /// refused only if the compiler can read them.
    fn refused_unread(&self) -> (Replacements, Vec<&'a String>) {
        let mut replaced = Replacements::new();
        let mut unclear = Vec::new();
        for Answer { task, text } in &self.submission.answers {
            let why = match text {
                Err(unusable) => Replacement::Unusable(unusable.clone()),
                Ok(_) if self.compiler.allows_everything => continue,
                Ok(text) => {
                    match allow_list::verdict(&format!("{}/{task}.rs", self.shown_in), text) {
                        Verdict::Allowed => continue,
                        Verdict::Refused(why) => Replacement::DoesNotCompile(why),
                        Verdict::NotTokens => {
                            unclear.push(task);
                            continue;
                        }
                    }
                }
            };
            replaced.insert(task.clone(), why);
        }
        (replaced, unclear)
    }

    /// Runs the compiler once, unless it has compiled the same files before.
    fn compile(&self, replaced: &Replacements) -> Result<BuildResult, Stopped> {
        let Compiler {
            programs,
            harness,
            sandbox,
            pristine,
            stops_when_late,
            ..
        } = self.compiler;
        let sources = timed("assemble", || sources(self.submission, pristine, replaced));
        match build(&sources, &self.shown_in, programs, harness, sandbox)? {
            BuildResult::Refused { is_late: true, .. } if *stops_when_late => Err(Stopped::Late),
            BuildResult::Refused {
                disturbed_by: Some(why),
                ..
            } if !stops_when_late => Err(Error::environment(
                why,
                "run this command again when the machine is less busy and has free space",
            )
            .into()),
            built => Ok(built),
        }
    }

    /// Tries blamed answers again: all together, and then each alone and with those that it uses, until
    /// none can return. An answer may have been blamed only because it uses, or clashes with, another
    /// one that was replaced later. After the time is up, each is tried once more. None of them ran
    /// out of time when it was blamed.
    fn restore(
        &self,
        blamed: &Blamed,
        replaced: &mut Replacements,
        built: &mut Built,
        is_done: &dyn Fn() -> bool,
    ) -> Result<(), Stopped> {
        let Blamed {
            replaced: all,
            again,
        } = blamed;
        if again.len() < all.len() && self.without(again, replaced, built)? {
            return Ok(());
        }
        if again.len() < 2 {
            return Ok(());
        }
        loop {
            let (before, was_done) = (replaced.len(), is_done());
            for task in again {
                let alone = BTreeSet::from([task.clone()]);
                let with_used = self.with_used(task, again);
                if !self.without(&with_used, replaced, built)? && alone != with_used {
                    self.without(&alone, replaced, built)?;
                }
            }
            if replaced.len() == before || was_done {
                return Ok(());
            }
        }
    }

    /// Stops replacing the answers to `tasks` if the rest compiles with them, perhaps without the answer
    /// that gives no points. Returns whether it did.
    fn without(
        &self,
        tasks: &BTreeSet<String>,
        replaced: &mut Replacements,
        built: &mut Built,
    ) -> Result<bool, Stopped> {
        let mut fewer = replaced.clone();
        fewer.retain(|task, _| !tasks.contains(task));
        if fewer.len() == replaced.len() {
            return Ok(false);
        }
        let mut result = self.compile(&fewer)?;
        if let BuildResult::Refused { diagnostics, .. } = &result
            && let Some((task, without)) = self.without_earlier(&fewer)?
        {
            let why = Replacement::DoesNotCompile(blame::rendered(diagnostics));
            fewer.insert(task.clone(), why);
            result = without;
        }
        let BuildResult::Program {
            executable,
            warnings,
        } = result
        else {
            return Ok(false);
        };
        *built = (executable, warnings);
        *replaced = fewer;
        Ok(true)
    }

    /// A task, and those among `tasks` whose answers its answer seems to use, directly or not.
    fn with_used(&self, task: &str, tasks: &BTreeSet<String>) -> BTreeSet<String> {
        let mut all = BTreeSet::from([task.to_owned()]);
        let mut new = vec![task.to_owned()];
        while let Some(task) = new.pop() {
            let answer = self.submission.answer(&task);
            let text = answer.and_then(|it| it.text.as_deref().ok());
            for used in modules_named(text.unwrap_or_default()).intersection(tasks) {
                if all.insert(used.clone()) {
                    new.push(used.clone());
                }
            }
        }
        all
    }

    fn program(&self, built: Built, replaced: Replacements) -> Result<Program, Stopped> {
        let (executable, warnings) = built;
        let stubs = self.submission.answers.iter();
        let stubs = stubs.filter(|answer| self.is_stub(answer, &replaced));
        Ok(Program {
            executable,
            stubs: stubs.map(|answer| answer.task.clone()).collect(),
            with_ours: self.with_ours(&replaced)?,
            warnings: blame::warnings(&warnings, self.submission, &replaced),
            replaced,
            stop: Stop::default(),
        })
    }

    /// The program with our answer to the task of an earlier assignment.
    fn with_ours(&self, replaced: &Replacements) -> Result<WithOurs, Stopped> {
        Ok(match self.without_earlier(replaced)? {
            None => WithOurs::Same,
            Some((_, BuildResult::Program { executable, .. })) => WithOurs::Executable(executable),
            Some((_, BuildResult::Refused { .. })) => WithOurs::DoesNotCompile,
        })
    }

    /// Compiles without the student's answer to the task of an earlier assignment, if there is one.
    fn without_earlier(
        &self,
        replaced: &Replacements,
    ) -> Result<Option<(&String, BuildResult)>, Stopped> {
        let is_theirs = |task: &&String| {
            self.submission.answer(task).is_some() && !replaced.contains_key(*task)
        };
        let Some(task) = self.compiler.earlier.as_ref().filter(is_theirs) else {
            return Ok(None);
        };
        let mut without = replaced.clone();
        let missing = Replacement::Unusable(AnswerFileProblem::Missing);
        without.insert(task.clone(), missing);
        Ok(Some((task, self.compile(&without)?)))
    }

    /// Whether an answer was replaced by its stub, or is the stub apart from comments and spaces.
    fn is_stub(&self, answer: &Answer, replaced: &Replacements) -> bool {
        let file = Path::new("src").join(format!("{}.rs", answer.task));
        let is_given = |text: &String| {
            let given = self.compiler.pristine.get(&file);
            given.is_some_and(|given| stubs::is_unchanged(given, text))
        };
        replaced.contains_key(&answer.task) || answer.text.as_ref().is_ok_and(is_given)
    }
}

/// The words of an answer that may name modules: those before `::` or in a `use`.
fn modules_named(text: &str) -> BTreeSet<String> {
    let tokens = tokens(text).unwrap_or_default();
    let mut is_in_use = false;
    let mut named = BTreeSet::new();
    for (at, (token, _)) in tokens.iter().enumerate() {
        match token {
            Token::Word(word) if word == "use" => is_in_use = true,
            Token::Mark(';') => is_in_use = false,
            Token::Word(word) => {
                let is_path = tokens
                    .get(at + 1)
                    .is_some_and(|it| it.0 == Token::Mark(PATH));
                if is_in_use || is_path {
                    named.insert(word.clone());
                }
            }
            _ => {}
        }
    }
    named
}

/// Refuses an answer that the compiler can split into tokens, but we can't.
fn unclear_tokens(task: &str) -> Replacement {
    Replacement::DoesNotCompile(format!(
        "error: src/{task}.rs holds characters that Pinhole can't read as Rust\n  = help: write \
         plain Rust 2024\n"
    ))
}

/// The folder of the answer files, as a path that opens from the current folder. `None` for an
/// archive, or if the compiler's option or the terminal cannot hold the path.
fn place_from_here(submission: &Submission) -> Option<String> {
    let place = shell::from_here(&submission.place);
    // The compiler's colours reach the terminal, so nothing else may look like them.
    let is_plain = |name: &&str| !name.contains(|it: char| it == '=' || it.is_control());
    let name = place.to_str().filter(is_plain)?;
    submission.place.is_dir().then(|| name.to_owned())
}

/// The fixed files, and each answer or its stub.
fn sources(submission: &Submission, pristine: &Package, replaced: &Replacements) -> Sources {
    let ours = pristine.iter().filter_map(|(path, text)| {
        let name = path.strip_prefix("src").ok()?.to_str()?;
        Some((name.to_owned(), text.clone()))
    });
    let mut sources: Sources = ours.collect();
    for answer in submission
        .answers
        .iter()
        .filter(|answer| !replaced.contains_key(&answer.task))
    {
        if let Ok(text) = &answer.text {
            sources.insert(format!("{}.rs", answer.task), text.clone());
        }
    }
    sources
}
