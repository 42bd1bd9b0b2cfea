//! What a mark was made from. As long as none of it changes, grading again gives the same mark.

use std::fs;
use std::path::Path;

use hmac_sha256::Hash;
use serde::{Deserialize, Serialize};

use super::redact::Reveal;
use pinhole_course::assignment::{Assignment, EXAMPLES, examples_file};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::rust_tool::rust_tool;
use pinhole_course::seed::Seed;
use pinhole_course::stubs;
use pinhole_course::submission::{AnswerFileProblem, Submission};

/// The hashes and settings behind a mark. If all of them are equal, so are the marks.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Provenance {
    /// For each task and each file of examples, the hash of the file, or why there is none.
    pub answers: Vec<(String, String)>,
    #[serde(flatten)]
    pub made_with: GradingInputs,
}

/// A seed that doesn't fit into 63 bits is text.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[schemars(inline, untagged)]
#[expect(dead_code, reason = "only its schema is used")]
enum SeedInJson {
    Number(u64),
    Text(String),
}

/// The part that is the same for the whole class.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GradingInputs {
    /// What the answers were judged on, for example "public goldens and fresh questions".
    pub judged_on: String,
    /// The seed that the fresh questions were drawn from. Not for students.
    #[cfg_attr(test, schemars(with = "Option<SeedInJson>"))]
    pub seed: Option<Seed>,
    /// The hash of the goldens' manifest, which contains every film's hash.
    pub goldens: String,
    /// The hash of the fresh goldens' manifest.
    pub fresh: Option<String>,
    /// The hash of tasks, groups and scenes, without their points, of the handout's files, and, if
    /// an answer to an earlier assignment is judged, of that assignment's goldens. If only points
    /// change, marks are computed again from stored outcomes.
    pub assignment: String,
    pub tool: Tool,
    /// The sandbox that the student's code ran in.
    pub sandbox: String,
    /// How many seconds an answer may take.
    pub timeout: u64,
    /// How much is shown about withheld questions; null if there are none.
    pub reveal: Option<Reveal>,
}

impl GradingInputs {
    /// Whether marks made with either are for the same questions.
    pub fn asks_the_same(&self, other: &GradingInputs) -> bool {
        let asked = |it: &GradingInputs| {
            let GradingInputs {
                seed,
                goldens,
                fresh,
                assignment,
                ..
            } = it.clone();
            (seed, goldens, fresh, assignment)
        };
        asked(self) == asked(other)
    }
}

/// The program that graded.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Tool {
    pub version: String,
    /// The hash of the executable.
    pub sha256: String,
    pub rustc: String,
}

impl Tool {
    /// This program.
    pub fn this(checkout: &Checkout) -> Result<Tool> {
        let own = std::env::current_exe().and_then(fs::read).or_environment(
            "cannot read this program's own file",
            "build it again: cargo build --release",
        )?;
        let rustc = rust_tool("rustc", checkout.root())
            .arg("--version")
            .output();
        let rustc = rustc.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
        Ok(Tool {
            version: env!("CARGO_PKG_VERSION").into(),
            sha256: sha256(&own),
            rustc: rustc.unwrap_or_default(),
        })
    }
}

impl Provenance {
    /// The provenance of a submission's mark.
    pub fn of(submission: &Submission, made_with: &GradingInputs) -> Provenance {
        Provenance {
            answers: of_answers(submission),
            made_with: made_with.clone(),
        }
    }

    /// What has changed since a mark with the provenance `before` was made; `None` if nothing has.
    pub fn change_since(&self, before: &Provenance) -> Option<&'static str> {
        let (new, old) = (&self.made_with, &before.made_with);
        match () {
            () if self == before => None,
            () if self.answers != before.answers => Some("other answers"),
            () if new.tool != old.tool => Some("another version of the grader or of rustc"),
            () if !new.asks_the_same(old) => Some("other questions or goldens"),
            () => Some("other settings"),
        }
    }
}

/// See [`Provenance::answers`].
pub fn of_answers(submission: &Submission) -> Vec<(String, String)> {
    let answers = submission.answers.iter().map(|it| (it.task.clone(), it));
    let examples = submission.examples.iter();
    let examples = examples.map(|it| (examples_file(&it.task), it));
    let states = answers.chain(examples).map(|(name, answer)| {
        let state = match &answer.text {
            Ok(text) => sha256(text.as_bytes()),
            Err(AnswerFileProblem::Missing) => "missing".into(),
            Err(AnswerFileProblem::Refused(why)) => format!("refused: {why}"),
        };
        (name, state)
    });
    states.collect()
}

/// The hash of a file's content.
pub fn of_file(path: &Path) -> Result<String> {
    let bytes = fs::read(path).or_input(
        format_args!("cannot read {}", path.display()),
        "name a folder of goldens with its manifest",
    )?;
    Ok(sha256(&bytes))
}

/// The hash of what an assignment asks and of the code around the answers, without what the answers
/// are worth.
pub fn of_assignment(assignment: &Assignment, checkout: &Checkout) -> Result<String> {
    let path = assignment.folder.join("assignment.toml");
    let wrong = Error::input(path.display().to_string(), "correct the assignment file");
    let text = fs::read_to_string(&path).or_fail(&wrong)?;
    let mut asked = questions(&text).or_fail(&wrong)?.into_bytes();
    if let Some(earlier) = &assignment.earlier {
        let goldens = assignment.course().join("golden").join(&earlier.assignment);
        // A handed-out folder has some of these films, but no manifest.
        asked.extend(fs::read(goldens.join("manifest.toml")).unwrap_or_default());
    }
    for (path, text) in stubs::pristine(assignment, checkout)? {
        asked.extend(format!("{}\n{text}\n", path.display()).bytes());
    }
    Ok(sha256(&asked))
}

/// An assignment's file without points and dropped groups.
fn questions(text: &str) -> std::result::Result<String, toml::de::Error> {
    let mut table: toml::Table = toml::from_str(text)?;
    table.remove("dropped");
    let parts = table
        .iter_mut()
        .filter_map(|(_, value)| value.as_array_mut())
        .flatten()
        .filter_map(toml::Value::as_table_mut);
    for part in parts {
        if let Some(toml::Value::Table(examples)) = part.get_mut(EXAMPLES) {
            examples.remove("points");
        }
        match part.get_mut("points") {
            Some(toml::Value::Array(groups)) => groups
                .iter_mut()
                .filter_map(toml::Value::as_array_mut)
                .for_each(|group| group.retain(|item| !item.is_integer())),
            _ => drop(part.remove("points")),
        }
    }
    Ok(table.to_string())
}

/// SHA-256 in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    hex::encode(Hash::hash(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_points_keep_the_hash_and_changed_groups_or_scenes_do_not() {
        let file = "[[task]]\nname = \"plane\"\npoints = [[\"back\", 2, \"about\"]]\n\
                    examples = { points = 3, catch = 0.5 }\n\
                    [[scene]]\nname = \"lone\"\npoints = 1\n";
        let same = |was: &str, becomes: &str| {
            assert!(file.contains(was), "{was}");
            questions(file).unwrap() == questions(&file.replace(was, becomes)).unwrap()
        };
        assert!(same("2,", "7,"));
        assert!(same("points = 3", "points = 5"));
        assert!(!same("catch = 0.5", "catch = 0.8"));
        assert!(same("points = 1", "points = 9"));
        assert!(same(
            "[[scene]]",
            "[[dropped]]\ngroup = \"plane.back\"\npoints = \"given\"\n[[scene]]"
        ));
        assert!(!same("back", "front"));
        assert!(!same("lone", "other"));
    }
}
