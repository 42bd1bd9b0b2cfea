//! Finds the answers that keep a program from compiling.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde::Deserialize;

use super::build::BuildResult;
use super::rounds::Stopped;
use super::{Replacement, Replacements};
use crate::error::Error;
use crate::sandbox::CommandResult;
use crate::submission::{AnswerFileProblem, Submission};

/// The compiler's messages from its JSON output, one on each line.
pub fn diagnostics(stderr: &[u8]) -> Vec<Diagnostic> {
    let lines = stderr.split(|byte| *byte == b'\n');
    lines
        .filter_map(|line| serde_json::from_slice(line).ok())
        .collect()
}

/// Whether any of them is an error.
pub fn has_error(diagnostics: &[Diagnostic]) -> bool {
    diagnostics
        .iter()
        .any(|diagnostic| diagnostic.level == "error")
}

/// Whether any error points at code. If none does, the compiler was stopped or has crashed.
pub fn has_place(diagnostics: &[Diagnostic]) -> bool {
    let mut errors = diagnostics.iter().filter(|it| it.level == "error");
    errors.any(|error| !error.spans.is_empty())
}

/// Whether the compiler or the linker had no room for its files. The text of a submission appears only
/// in messages that point at it.
pub fn has_no_space(diagnostics: &[Diagnostic]) -> bool {
    // If there is no space for its output, the linker ends with a bus error.
    const SIGNS: [&str; 3] = ["No space left on device", "quota exceeded", "[Bus error]"];
    let points_at_nothing = diagnostics.iter().filter(|it| it.spans.is_empty());
    let mut all = points_at_nothing.map(|it| &it.rendered);
    all.any(|text| SIGNS.iter().any(|sign| text.contains(sign)))
}

/// One message of the compiler.
#[derive(Deserialize)]
pub struct Diagnostic {
    level: String,
    rendered: String,
    spans: Vec<Span>,
}

#[derive(Deserialize)]
struct Span {
    file_name: String,
}

impl Diagnostic {
    /// A message to show instead of the compiler's, if the compiler was killed or crashed.
    pub fn of_dead_compiler(finished: &CommandResult) -> Diagnostic {
        let said = String::from_utf8_lossy(&finished.stderr);
        let lines: Vec<&str> = said
            .lines()
            .filter(|line| !line.starts_with('{'))
            .take(5)
            .collect();
        let why = match finished.exceeded {
            Some(exceeded) => exceeded.to_string(),
            None if finished.late => "it took too long".into(),
            None => finished.status.to_string(),
        };
        let rendered = format!("the compiler gave up ({why})\n{}\n", lines.join("\n"));
        Diagnostic {
            level: "error".into(),
            rendered,
            spans: Vec::new(),
        }
    }
}

/// Answers that are to be replaced.
#[derive(Default)]
pub struct Blamed {
    pub replaced: Replacements,
    /// Those on which the compiler did not run out of time: it found an error in them, or they compile
    /// among stubs. So they can be tried again.
    pub again: BTreeSet<String>,
}

impl Blamed {
    pub fn extend(&mut self, other: Blamed) {
        self.replaced.extend(other.replaced);
        self.again.extend(other.again);
    }

    pub fn add(&mut self, task: &str, diagnostics: &[Diagnostic]) {
        let why = Replacement::DoesNotCompile(rendered(diagnostics));
        self.replaced.insert(task.to_owned(), why);
        if has_place(diagnostics) {
            self.again.insert(task.to_owned());
        }
    }
}

/// Errors by the answer that they point at. An error that points at several answers is attributed
/// to none; compiling the others without each of these shows which one is wrong.
pub fn by_place(
    diagnostics: &[Diagnostic],
    submission: &Submission,
    already: &Replacements,
) -> Blamed {
    let errors = of_level("error", diagnostics, submission, already);
    Blamed {
        again: errors.keys().cloned().collect(),
        replaced: errors
            .into_iter()
            .map(|(task, text)| (task, Replacement::DoesNotCompile(text)))
            .collect(),
    }
}

/// Warnings by the answer that they point at.
pub fn warnings(
    diagnostics: &[Diagnostic],
    submission: &Submission,
    already: &Replacements,
) -> BTreeMap<String, String> {
    of_level("warning", diagnostics, submission, already)
}

fn of_level(
    level: &str,
    diagnostics: &[Diagnostic],
    submission: &Submission,
    already: &Replacements,
) -> BTreeMap<String, String> {
    let mut told: BTreeMap<String, String> = BTreeMap::new();
    let of_level = |diagnostic: &&Diagnostic| diagnostic.level == level;
    for diagnostic in diagnostics.iter().filter(of_level) {
        let answers = diagnostic.spans.iter().filter_map(|span| {
            let stem = Path::new(&span.file_name).file_stem()?.to_str()?;
            submission.answer(stem).map(|answer| answer.task.clone())
        });
        let mut tasks: BTreeSet<String> = answers.collect();
        tasks.retain(|task| !already.contains_key(task));
        if tasks.len() == 1
            && let Some(task) = tasks.pop_first()
        {
            let text = told.entry(task).or_default();
            if text.len() < MOST_TEXT {
                text.push_str(cut(&diagnostic.rendered));
                text.truncate(cut(text).len());
            }
        }
    }
    told
}

/// The most compiler output that is shown for one file, in bytes.
const MOST_TEXT: usize = 32 * 1024;

fn cut(text: &str) -> &str {
    &text[..text.floor_char_boundary(MOST_TEXT)]
}

/// The compiler's messages, without the count of errors at the end.
pub fn rendered(diagnostics: &[Diagnostic]) -> String {
    let errors = diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.level == "error");
    let (placed, other): (Vec<_>, Vec<_>) = errors.partition(|error| !error.spans.is_empty());
    let told = if placed.is_empty() { other } else { placed };
    let text: String = told
        .into_iter()
        .map(|error| error.rendered.as_str())
        .collect();
    cut(&text).to_owned()
}

/// An error that no answer caused.
pub fn not_theirs(diagnostics: &[Diagnostic]) -> Error {
    Error::environment(
        format!(
            "the program around the answers does not compile:\n{}",
            rendered(diagnostics)
        ),
        "run this again; if the problem persists, restore the assignment's `handout` folder and \
         remove target/pinhole",
    )
}

/// The answers that keep the others from compiling. This finds the cause of an error that shows in
/// one of our files, such as a deleted function or `impl`, or that points at several answers.
///
/// If the stubs alone don't compile either, no answer is to blame, but the machine or we are. Then
/// the result is `None`. All answers are tried together once more, because the compiler may have been
/// killed the first time. Then each is left out alone, unless the compiler was stopped, which may take
/// long each time. If that never helps, several are to blame: those that don't compile among stubs, or,
/// if each of them does, all.
pub fn apart(
    submission: &Submission,
    already: &Replacements,
    compile: impl Fn(&Replacements) -> Result<BuildResult, Stopped>,
) -> Result<Option<Blamed>, Stopped> {
    let mut blamed = Blamed::default();
    let tasks = submission.answers.iter().map(|answer| answer.task.clone());
    let missing = || Replacement::Unusable(AnswerFileProblem::Missing);
    let stubs: Replacements = tasks.map(|task| (task, missing())).collect();
    if let BuildResult::Refused { .. } = compile(&stubs)? {
        return Ok(None);
    }
    let BuildResult::Refused { diagnostics, .. } = compile(already)? else {
        return Ok(Some(blamed));
    };
    let suspects = stubs.keys().filter(|task| !already.contains_key(*task));
    let suspects: Vec<&String> = suspects.collect();
    for suspect in suspects.iter().filter(|_| has_place(&diagnostics)) {
        let mut without = already.clone();
        without.insert((*suspect).clone(), missing());
        if let BuildResult::Program { .. } = compile(&without)? {
            blamed.add(suspect, &diagnostics);
            return Ok(Some(blamed));
        }
    }
    for &suspect in &suspects {
        let mut others = stubs.clone();
        others.remove(suspect);
        if let BuildResult::Refused { diagnostics, .. } = compile(&others)? {
            blamed.add(suspect, &diagnostics);
        }
    }
    if blamed.replaced.is_empty() {
        for suspect in suspects {
            blamed.add(suspect, &diagnostics);
            blamed.again.insert(suspect.clone());
        }
    }
    Ok(Some(blamed))
}

/// Blames every answer that is not replaced yet, because there is no time left to try each of them.
pub fn all(submission: &Submission, already: &Replacements) -> Replacements {
    let tasks = submission.answers.iter().map(|answer| &answer.task);
    let suspects = tasks.filter(|task| !already.contains_key(*task));
    suspects
        .map(|task| (task.clone(), Replacement::DoesNotCompile(TOO_LONG.into())))
        .collect()
}

/// The message for answers that together take too long.
const TOO_LONG: &str = "error: the answers together take too long to compile\n  = help: look for \
                        constants that take long to compute\n";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assignment::Assignment;
    use crate::checkout::Checkout;

    #[test]
    fn no_answer_is_to_blame_for_missing_space() {
        let is_full = |rendered: &str, file: Option<&str>| {
            let spans = file.map(|name| Span {
                file_name: name.into(),
            });
            has_no_space(&[Diagnostic {
                level: "error".into(),
                rendered: rendered.into(),
                spans: spans.into_iter().collect(),
            }])
        };
        let text = "LLVM ERROR: IO failure on output stream: No space left on device";
        assert!(is_full(text, None));
        assert!(is_full("ld terminated with signal 7 [Bus error]", None));
        assert!(!is_full(text, Some("src/sphere.rs")), "the answer says so");
        assert!(!is_full("final link failed: File too large", None));
    }

    #[test]
    fn answers_that_compile_together_the_second_time_are_not_blamed() {
        let checkout = Checkout::find().unwrap();
        let name = checkout.default_assignment().unwrap();
        let assignment = Assignment::read(&checkout, &name).unwrap();
        let submission = Submission::find(&assignment.reference(), &assignment).unwrap();
        let blamed = |compiles_together: bool| {
            let compile = |replaced: &Replacements| {
                Ok(match replaced.is_empty() && !compiles_together {
                    true => BuildResult::Refused {
                        diagnostics: Vec::new(),
                        is_late: false,
                        disturbed_by: None,
                    },
                    false => BuildResult::Program {
                        executable: "program".into(),
                        warnings: Vec::new(),
                    },
                })
            };
            let Ok(Some(blamed)) = apart(&submission, &Replacements::new(), compile) else {
                panic!("the stubs compile")
            };
            assert_eq!(blamed.replaced.len(), blamed.again.len());
            blamed.again.len()
        };
        assert_eq!(blamed(true), 0);
        assert_eq!(blamed(false), submission.answers.len());
    }
}
