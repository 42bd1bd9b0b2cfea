//! Compiles a submission's answer files to a program.
//!
//! Only the answers come from the student's folder. `main.rs`, `intersect_ray.rs` and the
//! compiler's flags are always ours.

mod blame;
mod build;
mod compiled_submission;
mod harness;
mod prune;

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use pinhole::ask::Stop;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::handout_record::Package;
use crate::sandbox::Sandbox;
use crate::shell;
use crate::stubs;
use crate::submission::allow_list::{self, Verdict};
use crate::submission::{Answer, AnswerFileProblem, Submission};
use crate::timings::timed;
use build::{BuildResult, Sources, build};
pub use compiled_submission::CompiledSubmission;
use harness::Harness;

/// Answers that were replaced by their stubs, by task, and why.
pub type Replacements = BTreeMap<String, Replacement>;

/// A submission that runs.
#[derive(Clone, Debug)]
pub struct Program {
    /// The executable.
    pub executable: PathBuf,
    /// Answers that were replaced by their stubs, and why.
    pub replaced: Replacements,
    /// The tasks whose answer is the stub, either because it was replaced or because it is still
    /// what was handed out.
    pub stubs: BTreeSet<String>,
    /// The same program with our answer to the task of an earlier assignment.
    pub with_ours: WithOurs,
    /// What the compiler warned about, by task.
    pub warnings: BTreeMap<String, String>,
    /// Raised when its answers are no longer needed.
    pub stop: Stop,
}

/// A program with our answer to the task of an earlier assignment instead of the student's.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WithOurs {
    /// No such program is needed, because the student's answer is not used.
    #[default]
    Same,
    /// This executable.
    Executable(PathBuf),
    /// The other answers need something of the student's answer that ours doesn't have.
    DoesNotCompile,
}

/// Why an answer was replaced by its stub.
#[derive(Clone, Debug, PartialEq)]
pub enum Replacement {
    /// There was no usable file.
    Unusable(AnswerFileProblem),
    /// It does not compile: the compiler's own words about that file.
    DoesNotCompile(String),
}

/// Compiles any number of submissions.
#[derive(Clone)]
pub struct Compiler {
    /// The folder of compiled programs.
    programs: PathBuf,
    sandbox: Sandbox,
    harness: Harness,
    /// The handout with untouched stubs. It is not read from the handout's folder, because
    /// students write there.
    pristine: Package,
    /// The task of an earlier assignment, if students may hand in its answer again.
    earlier: Option<String>,
    /// Whether answers may use any attribute and macro.
    allows_everything: bool,
    /// Whether messages name the student's files by paths that open from the current folder.
    names_places: bool,
    /// Whether to give up when the compiler is late, because other work may have held it up.
    stops_when_late: bool,
}

/// Compiles one submission for someone who can edit it: see [`Compiler::compile`] and
/// [`Compiler::naming_places`].
pub fn compile(
    submission: &Submission,
    assignment: &Assignment,
    checkout: &Checkout,
    sandbox: &Sandbox,
) -> Result<Program> {
    let compiler = Compiler::new(assignment, checkout, sandbox)?;
    compiler.naming_places().compile(submission)
}

impl Compiler {
    /// Makes a compiler, and builds the harness if needed.
    pub fn new(
        assignment: &Assignment,
        checkout: &Checkout,
        sandbox: &Sandbox,
    ) -> Result<Compiler> {
        let earlier = assignment.earlier.as_ref();
        Ok(Compiler {
            programs: sandbox.scratch(checkout).join("programs"),
            sandbox: sandbox.clone(),
            harness: timed("find the harness", || {
                Harness::find(checkout, &sandbox.scratch(checkout))
            })?,
            pristine: stubs::pristine(assignment, checkout)?,
            earlier: earlier.map(|earlier| earlier.task.name.clone()),
            allows_everything: false,
            names_places: false,
            stops_when_late: false,
        })
    }

    /// This compiler, but without the [`allow_list`] if `everything` is allowed. Tests of the
    /// sandbox use it.
    pub fn allowing(self, everything: bool) -> Compiler {
        Compiler {
            allows_everything: everything,
            ..self
        }
    }

    /// This compiler, but messages name a student's files by paths that open from the current
    /// folder instead of by their names alone.
    pub fn naming_places(self) -> Compiler {
        Compiler {
            names_places: true,
            ..self
        }
    }

    /// This compiler, set to stop when it is late; see [`Attempt::Late`].
    pub fn stopping_when_late(self, stops: bool) -> Compiler {
        Compiler {
            stops_when_late: stops,
            ..self
        }
    }

    /// A compiler for one untrusted submission, with its own sandbox and folder.
    pub fn apart(&self, sandbox: &Sandbox, programs: PathBuf) -> Compiler {
        Compiler {
            programs,
            sandbox: sandbox.clone(),
            ..self.clone()
        }
    }

    /// Compiles a submission. Each answer that is missing or does not compile is replaced with its
    /// stub, so that one bad file costs only one task. An answer that compiles with the others is not
    /// replaced.
    ///
    /// # Errors
    /// If even the stubs do not compile, or the compiler cannot be run.
    pub fn compile(&self, submission: &Submission) -> Result<Program> {
        match self.compile_until(submission, &mut |_| false)? {
            Attempt::Program(program) => Ok(program),
            Attempt::Enough => unreachable!("compiling is never stopped early"),
            Attempt::Late => Err(Error::environment(
                "the compiler did not finish, perhaps because this machine was busy",
                "run this command again",
            )),
        }
    }

    /// Compiles a submission, but stops as soon as the replaced answers are `enough` for the
    /// caller. The compiler reports errors long before it has built the rest.
    pub fn compile_until(
        &self,
        submission: &Submission,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt> {
        self.compile_within(&|| self.sandbox.is_done_compiling(), submission, enough)
    }

    /// As [`compile_until`](Compiler::compile_until); `is_done` says whether the time is up.
    fn compile_within(
        &self,
        is_done: &dyn Fn() -> bool,
        submission: &Submission,
        enough: &mut dyn FnMut(&Replacements) -> bool,
    ) -> Result<Attempt> {
        let mut replaced = Replacements::new();
        let mut unclear = Vec::new();
        let shown_in = match self.names_places {
            true => place_from_here(submission),
            false => None,
        };
        let shown_in = shown_in.unwrap_or(build::SRC.into());
        for Answer { task, text } in &submission.answers {
            let why = match text {
                Err(unusable) => Replacement::Unusable(unusable.clone()),
                Ok(_) if self.allows_everything => continue,
                Ok(text) => match allow_list::verdict(&format!("{shown_in}/{task}.rs"), text) {
                    Verdict::Allowed => continue,
                    Verdict::Refused(why) => Replacement::DoesNotCompile(why),
                    Verdict::NotTokens => {
                        unclear.push(task);
                        continue;
                    }
                },
            };
            replaced.insert(task.clone(), why);
        }
        let mut is_last = false;
        let mut all_blamed = Vec::new();
        let late = Cell::new(false);
        // Each round replaces at least one answer, except the last one, and one after a compiler that
        // failed for no answer's fault. So there are at most this many rounds.
        for _ in 0..submission.answers.len() + 2 {
            if enough(&replaced) {
                return Ok(Attempt::Enough);
            }
            // Each round may take nearly as long as the limit for one run of the compiler, so
            // only two begin after the time is up: one to find all answers that don't compile,
            // and one without them.
            let was_last = is_last;
            is_last = is_done();
            if is_last && self.stops_when_late {
                return Ok(Attempt::Late);
            }
            let compile = |replaced: &Replacements| {
                let assembled = || sources(submission, &self.pristine, replaced);
                let sources = timed("assemble", assembled);
                let Compiler {
                    programs, harness, ..
                } = self;
                match build(&sources, &shown_in, programs, harness, &self.sandbox)? {
                    BuildResult::Refused {
                        disturbed_by: Some(why),
                        ..
                    } if !self.stops_when_late => Err(Error::environment(
                        why,
                        "run this command again when the machine is less busy and has free space",
                    )),
                    built => {
                        let is_late = matches!(built, BuildResult::Refused { is_late: true, .. });
                        late.set(late.get() || is_late && self.stops_when_late);
                        Ok(built)
                    }
                }
            };
            match compile(&replaced)? {
                BuildResult::Program {
                    mut executable,
                    mut warnings,
                } => {
                    // An answer may be blamed only because it uses, or clashes with, another one
                    // that has been replaced since.
                    let doubtful = match all_blamed.len() {
                        0 | 1 => Vec::new(),
                        _ => std::mem::take(&mut all_blamed),
                    };
                    for task in doubtful.into_iter().take_while(|_| !is_done()) {
                        let mut fewer = replaced.clone();
                        fewer.remove(&task);
                        if let BuildResult::Program {
                            executable: better,
                            warnings: told,
                        } = compile(&fewer)?
                        {
                            (executable, warnings, replaced) = (better, told, fewer);
                        }
                        if late.get() {
                            return Ok(Attempt::Late);
                        }
                    }
                    unclear.retain(|task| !replaced.contains_key(*task));
                    if !unclear.is_empty() {
                        let tasks = unclear.drain(..);
                        replaced.extend(tasks.map(|task| (task.clone(), unclear_tokens(task))));
                        continue;
                    }
                    let is_theirs = |task: &&String| {
                        submission.answer(task).is_some() && !replaced.contains_key(*task)
                    };
                    let with_ours = match self.earlier.as_ref().filter(is_theirs) {
                        None => WithOurs::Same,
                        Some(task) => {
                            let missing = Replacement::Unusable(AnswerFileProblem::Missing);
                            let mut ours = replaced.clone();
                            ours.insert(task.clone(), missing);
                            match compile(&ours)? {
                                BuildResult::Program { executable, .. } => {
                                    WithOurs::Executable(executable)
                                }
                                BuildResult::Refused { .. } if late.get() => {
                                    return Ok(Attempt::Late);
                                }
                                BuildResult::Refused { .. } => WithOurs::DoesNotCompile,
                            }
                        }
                    };
                    let warnings = blame::warnings(&warnings, submission, &replaced);
                    let stubs = submission.answers.iter();
                    let stubs = stubs.filter(|it| self.is_stub(it, &replaced));
                    return Ok(Attempt::Program(Program {
                        executable,
                        stubs: stubs.map(|answer| answer.task.clone()).collect(),
                        with_ours,
                        warnings,
                        replaced,
                        stop: Stop::default(),
                    }));
                }
                BuildResult::Refused { .. } if late.get() => {
                    return Ok(Attempt::Late);
                }
                BuildResult::Refused { .. } if was_last => {
                    replaced.extend(blame::all(submission, &replaced));
                }
                BuildResult::Refused { diagnostics, .. } => {
                    let mut blamed = blame::by_place(&diagnostics, submission, &replaced);
                    if blamed.is_empty() || is_last {
                        blamed = match blame::apart(submission, &replaced, compile)? {
                            _ if late.get() => return Ok(Attempt::Late),
                            Some(blamed) => blamed,
                            None => return Err(blame::not_theirs(&diagnostics)),
                        };
                    }
                    if blame::has_place(&diagnostics) {
                        all_blamed.extend(blamed.keys().cloned());
                    }
                    replaced.extend(blamed);
                }
            }
        }
        Err(Error::environment(
            "the stubs do not compile",
            "restore the assignment's `reference` folder, which they are made from",
        ))
    }

    /// Whether an answer was replaced by its stub, or is the stub apart from comments and spaces.
    fn is_stub(&self, answer: &Answer, replaced: &Replacements) -> bool {
        let file = Path::new("src").join(format!("{}.rs", answer.task));
        let is_given = |text: &String| {
            let given = self.pristine.get(&file);
            given.is_some_and(|given| stubs::is_unchanged(given, text))
        };
        replaced.contains_key(&answer.task) || answer.text.as_ref().is_ok_and(is_given)
    }
}

/// Refuses an answer that the compiler can split into tokens, but we can't.
fn unclear_tokens(task: &str) -> Replacement {
    Replacement::DoesNotCompile(format!(
        "error: src/{task}.rs holds characters that Pinhole can't read as Rust\n  = help: write \
         plain Rust 2024\n"
    ))
}

/// The result of [`Compiler::compile_until`].
pub enum Attempt {
    /// A program.
    Program(Program),
    /// No program, because the caller already knows enough.
    Enough,
    /// The compiler was late. Try again when nothing else runs.
    Late,
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Which of the reference's answers are replaced when the first ones are edited like this, by their
    /// positions.
    fn replaced(edits: &[fn(&str) -> String], is_done: bool) -> Vec<usize> {
        let checkout = Checkout::find().unwrap();
        let name = checkout.default_assignment().unwrap();
        let assignment = Assignment::read(&checkout, &name).unwrap();
        let mut submission = Submission::find(&assignment.reference(), &assignment).unwrap();
        for (answer, edit) in submission.answers.iter_mut().zip(edits) {
            let text = answer.text.as_ref();
            answer.text = text.map(|text| edit(text)).map_err(Clone::clone);
        }
        let compiler = Compiler::new(&assignment, &checkout, &Sandbox::Trusted).unwrap();
        let attempt = compiler.compile_within(&|| is_done, &submission, &mut |_| false);
        let Ok(Attempt::Program(program)) = attempt else {
            panic!("a program without the bad answers")
        };
        let answers = submission.answers.iter().enumerate();
        let replaced = answers.filter(|(_, it)| program.replaced.contains_key(&it.task));
        replaced.map(|(position, _)| position).collect()
    }

    #[test]
    fn answers_that_compile_stay_when_others_have_used_up_the_time() {
        let edits: [fn(&str) -> String; 3] = [
            |_| String::new(),
            |text| text.replacen("fn ", "fn fn ", 1),
            |text| format!("{text}\nfn f() {{ unknown() }}"),
        ];
        assert_eq!(replaced(&edits, true), [0, 1, 2]);
    }

    #[test]
    fn answer_that_uses_another_one_is_not_to_blame_for_it() {
        let edits: [fn(&str) -> String; 2] = [
            |text| text.replacen("pub fn viewing_ray", "pub fn unexpected", 1),
            |text| format!("{text}\n#[allow(unused)]\nuse crate::viewing_ray::viewing_ray;"),
        ];
        assert_eq!(replaced(&edits, false), [0]);
    }

    #[test]
    fn answers_that_need_each_other_are_not_to_blame_for_a_third() {
        let edits: [fn(&str) -> String; 3] = [
            |text| text.replacen("pub fn viewing_ray", "pub fn unexpected", 1),
            |text| format!("{text}\npub fn a() {{ crate::plane::b() }}"),
            |text| format!("{text}\npub fn b() {{ crate::sphere::a() }}"),
        ];
        assert_eq!(replaced(&edits, false), [0]);
    }

    #[test]
    fn only_one_of_two_answers_that_clash_is_replaced() {
        let clash = |text: &str| {
            format!(
                "{text}\nimpl crate::intersect_ray::IntersectRay for () {{
                    fn intersect_ray(&self, _: &pinhole::Ray, _: f64) -> Option<pinhole::Intersection> {{
                        None
                    }}
                }}"
            )
        };
        assert_eq!(replaced(&[clash, clash], false).len(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn no_folder_that_could_change_the_terminal_is_named() {
        let checkout = Checkout::find().unwrap();
        let name = checkout.default_assignment().unwrap();
        let assignment = Assignment::read(&checkout, &name).unwrap();
        let above = tempfile::tempdir().expect("there is room");
        let is_named = |name: &str| {
            let folder = above.path().join(name);
            std::fs::create_dir(&folder).expect("there is room");
            let answer = folder.join(assignment.tasks[0].file());
            std::fs::write(answer, "").expect("there is room");
            let submission = Submission::find(&folder, &assignment).unwrap();
            place_from_here(&submission).is_some()
        };
        assert!(is_named("ada"));
        assert!(!is_named("a=b"));
        assert!(!is_named("\u{1b}[8meve"));
    }
}
