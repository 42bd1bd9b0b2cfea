//! Commands and their output. The output is captured once, shown in the book, and compared in
//! every check.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::shell::PINHOLE;
use regex::Regex;
use serde::Deserialize;

use crate::course::{assignment, scratch};
use crate::error::{Error, Problem, Result};
use crate::listing::fence;

/// A command of `book/commands.toml`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// As a reader types it; `pinhole` stands for this program.
    pub command: String,
    /// Whose answers to put into the handout's folder: `handout`, `reference`, or
    /// `mistakes/SLUG`, which is the reference with some files replaced by that mistake's.
    #[serde(default = "handout")]
    pub answers: String,
    /// The first and the last line to show, from 1.
    pub lines: Option<[usize; 2]>,
    /// Regular expressions and replacements, for text that differs in every run.
    #[serde(default)]
    pub replace: Vec<[String; 2]>,
}

fn handout() -> String {
    "handout".into()
}

/// All commands by name.
pub type Runs = BTreeMap<String, Run>;

/// The file that lists the commands.
const LIST: &str = "book/commands.toml";

/// Reads the list; without one, there are no commands.
pub fn read(checkout: &Checkout) -> Result<Runs> {
    if !checkout.root().join(LIST).is_file() {
        return Ok(Runs::new());
    }
    toml::from_str(&checkout.read(LIST)?).map_err(|error| {
        let remedy = "each command is a table: [ID] command = \"pinhole …\"";
        Problem::of(LIST, error.message(), remedy).into()
    })
}

/// The path of a command's captured output.
pub fn captured(id: &str, checkout: &Checkout) -> PathBuf {
    checkout.book().join("captured").join(format!("{id}.txt"))
}

impl Run {
    /// The command line a reader copies.
    pub fn typed(&self) -> String {
        match self.command.strip_prefix("pinhole ") {
            Some(rest) => format!("{PINHOLE} {rest}"),
            None => self.command.clone(),
        }
    }

    /// Markdown of the command and its output.
    pub fn shown(&self, output: &str) -> String {
        let lines: Vec<&str> = output.lines().collect();
        let [first, last] = self.lines.unwrap_or([1, lines.len()]);
        let (first, last) = (first.clamp(1, lines.len().max(1)), last.min(lines.len()));
        let mut part: Vec<&str> = lines.get(first - 1..last).unwrap_or_default().to_vec();
        if first > 1 {
            part.insert(0, "…");
        }
        if last < lines.len() {
            part.push("…");
        }
        let text = part.join("\n");
        let fence = fence(&text);
        let typed = self.typed();
        format!("{fence}sh\n{typed}\n{fence}\n\n{fence}text\n{text}\n{fence}\n")
    }
}

/// Runs commands in a folder of its own.
pub struct Runner<'a> {
    checkout: &'a Checkout,
    pinhole: PathBuf,
}

impl<'a> Runner<'a> {
    /// Builds the program.
    pub fn new(checkout: &'a Checkout) -> Result<Runner<'a>> {
        Ok(Runner::of(build(checkout)?, checkout))
    }

    /// Uses this program as `pinhole`.
    pub fn of(pinhole: PathBuf, checkout: &'a Checkout) -> Runner<'a> {
        Runner { checkout, pinhole }
    }

    /// Commands whose output is not what the book shows any more.
    pub fn changed(&self) -> Result<Vec<Problem>> {
        let mut problems = Vec::new();
        for (id, run) in &read(self.checkout)? {
            let path = captured(id, self.checkout);
            let kept = fs::read_to_string(&path).ok();
            match self.run(id, run) {
                Ok(output) => {
                    let file = self.checkout.inside(&path);
                    problems.extend(changed(&file, kept.as_deref(), &output));
                }
                Err(Error::Sources(wrong)) => problems.extend(wrong),
                Err(other) => return Err(other),
            }
        }
        Ok(problems)
    }

    /// The standard output of a command.
    pub fn run(&self, id: &str, run: &Run) -> Result<String> {
        let wrong =
            |problem: String, remedy: &str| Problem::of(LIST, format!("[{id}]: {problem}"), remedy);
        let mut words = run.command.split_whitespace();
        if words.next() != Some("pinhole") {
            let remedy = "let the command begin with `pinhole`";
            return Err(wrong(
                format!("`{}` is not a `pinhole` command", run.command),
                remedy,
            )
            .into());
        }
        let assignment = self.assignment(run)?;
        let answers = self.answers(&assignment, &run.answers)?;
        let named = answers.display().to_string();
        let handout = self.checkout.inside(&assignment.handout());
        let handout = handout.display().to_string();
        let mut arguments: Vec<String> = words.map(|word| word.replace(&handout, &named)).collect();
        // Without a folder, these commands use the handout's, which must not be touched.
        match arguments.first().map(String::as_str) {
            Some("check") => arguments.push(named.clone()),
            Some("explain" | "render") => arguments.extend(["--submission".into(), named.clone()]),
            _ => {}
        }
        let here = scratch(self.checkout).join("run");
        fs::create_dir_all(&here).map_err(|error| Error::file(&here, &error))?;
        let output = Command::new(&self.pinhole)
            .args(&arguments)
            .current_dir(&here)
            .output()
            .map_err(|error| Error::file(&self.pinhole, &error))?;
        // Exit code 1 is a verdict and not an error.
        if !matches!(output.status.code(), Some(0 | 1)) {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(wrong(format!("it fails: {said}"), "correct the command").into());
        }
        let mut text = String::from_utf8_lossy(&output.stdout).into_owned();
        let root = format!("{}/", self.checkout.root().display());
        let inside = named.replace(&root, "");
        for (from, to) in [(&named, handout.as_str()), (&inside, &handout), (&root, "")] {
            text = text.replace(from, to);
        }
        for [pattern, with] in &run.replace {
            let pattern = Regex::new(&format!("(?m){pattern}"))
                .map_err(|error| wrong(error.to_string(), "correct the regular expression"))?;
            text = pattern.replace_all(&text, with.as_str()).into_owned();
        }
        let text: String = text
            .lines()
            .map(|line| format!("{}\n", line.trim_end()))
            .collect();
        Ok(text.trim_start_matches('\n').to_owned())
    }

    /// The assignment that a command names, or the first.
    fn assignment(&self, run: &Run) -> Result<Assignment> {
        let mut words = run.command.split_whitespace();
        match words.find(|word| *word == "--assignment").and(words.next()) {
            Some(name) => Ok(Assignment::read(self.checkout, name)?),
            None => assignment(self.checkout),
        }
    }

    /// A folder of answers, in the checkout's scratch space, where code is trusted.
    fn answers(&self, assignment: &Assignment, whose: &str) -> Result<PathBuf> {
        let answers = scratch(self.checkout)
            .join("answers")
            .join(&assignment.name);
        let folder = answers.join(whose.replace('/', "-"));
        let _absent = fs::remove_dir_all(&folder);
        let mut sources = vec![assignment.reference().join("src")];
        match whose {
            "reference" => {}
            "handout" => sources = vec![assignment.handout().join("src")],
            other => sources.push(assignment.folder.join(other)),
        }
        for source in sources {
            copy_rust(&source, &folder.join("src"))?;
        }
        Ok(folder)
    }
}

/// What cargo prints about a file that it has built.
#[derive(Deserialize)]
struct Artifact {
    executable: Option<PathBuf>,
}

/// Builds the `pinhole` command and returns its path.
fn build(checkout: &Checkout) -> Result<PathBuf> {
    let remedy = "run `cargo build --release -p pinhole-cli` and fix the errors it reports";
    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let output = Command::new(cargo)
        .current_dir(checkout.root())
        .args(["build", "--release", "--quiet", "-p", "pinhole-cli"])
        .arg("--message-format=json-render-diagnostics")
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| Error::environment(format!("cannot start cargo: {error}"), remedy))?;
    let said = String::from_utf8_lossy(&output.stdout);
    let mut executables = said
        .lines()
        .filter_map(|line| serde_json::from_str::<Artifact>(line).ok())
        .filter_map(|artifact| artifact.executable);
    let executable = executables.next_back();
    let executable = executable.filter(|_| output.status.success());
    executable.ok_or_else(|| Error::environment("pinhole does not build", remedy))
}

/// Copies the answer files, and nothing else, from one folder to another.
fn copy_rust(from: &Path, to: &Path) -> Result<()> {
    let failed = |error: std::io::Error| Error::file(from, &error);
    fs::create_dir_all(to).map_err(failed)?;
    for entry in fs::read_dir(from).map_err(failed)?.flatten() {
        if entry.path().extension().is_some_and(|end| end == "rs") {
            fs::copy(entry.path(), to.join(entry.file_name())).map_err(failed)?;
        }
    }
    Ok(())
}

/// Runs the named commands, or all, and stores their output.
pub fn capture(ids: &[String], checkout: &Checkout) -> Result<()> {
    let runs = read(checkout)?;
    let runner = Runner::new(checkout)?;
    if let Some(unknown) = ids.iter().find(|id| !runs.contains_key(*id)) {
        let remedy = "add it, or name one that is listed";
        return Err(Problem::of(LIST, format!("there is no command [{unknown}]"), remedy).into());
    }
    let mut problems = Vec::new();
    for (id, run) in runs {
        if ids.is_empty() || ids.contains(&id) {
            match runner.run(&id, &run) {
                Ok(output) => checkout.write(captured(&id, checkout), output)?,
                Err(Error::Sources(wrong)) => problems.extend(wrong),
                Err(other) => return Err(other),
            }
        }
    }
    match problems.is_empty() {
        true => Ok(()),
        false => Err(Error::Sources(problems)),
    }
}

/// Commands whose output is not what the book shows any more.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    Runner::new(checkout)?.changed()
}

/// Shows where the first difference is.
fn changed(file: &Path, kept: Option<&str>, output: &str) -> Option<Problem> {
    let remedy = "check that the change is right, then run: cargo pinhole book capture";
    let Some(kept) = kept else {
        return Some(Problem::of(file, "the command was never captured", remedy));
    };
    if kept == output {
        return None;
    }
    let (mut old, mut new) = (kept.lines(), output.lines());
    for line in 1.. {
        let (old, new) = (old.next(), new.next());
        if old != new || old.is_none() {
            let quoted =
                |text: Option<&str>| text.map_or("nothing".into(), |text| format!("`{text}`"));
            let problem = format!(
                "the command now prints {}, not {}",
                quoted(new),
                quoted(old)
            );
            return Some(Problem::at(file, line, problem, remedy));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(lines: Option<[usize; 2]>) -> Run {
        Run {
            command: "pinhole check".into(),
            answers: handout(),
            lines,
            replace: Vec::new(),
        }
    }

    #[test]
    fn lines_that_are_left_out_leave_dots() {
        let shown = run(Some([2, 3])).shown("a\nb\nc\nd\n");
        assert!(shown.contains("```text\n…\nb\nc\n…\n```"), "{shown}");
        assert!(shown.contains("cargo pinhole check"), "{shown}");
        assert!(!run(None).shown("a\nb\n").contains('…'));
    }

    #[test]
    fn an_output_that_changed_is_a_problem_at_its_line() {
        let file = Path::new("captured/x.txt");
        assert_eq!(changed(file, Some("a\nb\n"), "a\nb\n"), None);
        let problem = changed(file, Some("a\nb\n"), "a\nc\n").unwrap();
        assert_eq!(problem.line, Some(2));
        assert!(problem.problem.contains("`c`, not `b`"), "{problem}");
        assert!(
            changed(file, None, "a\n")
                .unwrap()
                .problem
                .contains("never captured")
        );
        assert!(
            changed(file, Some("a\n"), "")
                .unwrap()
                .problem
                .contains("nothing, not `a`")
        );
    }
}
