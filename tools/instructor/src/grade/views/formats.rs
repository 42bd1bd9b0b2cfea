//! Results in other graders' formats: Gradescope's `results.json`, JUnit's XML and
//! PrairieLearn's `results.json`. Each is a view of a record.

use clap::ValueEnum;
use jiff::Timestamp;
use minijinja::{context, value::Serde};
use serde::Serialize;
use serde_json::{Value, json};

use crate::grade::cache::pretty;
use crate::grade::record::Record;
use pinhole_course::error::Result;
use pinhole_course::outcome::{AnswerFile, GroupOutcome, Status, TaskOutcome};
use pinhole_report::escape::printable;
use pinhole_report::html::environment;
use pinhole_report::terminal;

/// A file to write beside each result.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub enum Format {
    /// gradescope.json: the result in Gradescope's format
    Gradescope,
    /// junit.xml: a test for each group of questions and each scene
    Junit,
    /// prairielearn.json: the result in PrairieLearn's format
    Prairielearn,
    /// classroom50.json: the result in Classroom 50's format; it names the classroom, the
    /// assignment and the submission if Classroom 50's runner has set its environment variables
    Classroom50,
    /// groups.csv in the --out folder: a line for each group of questions
    Csv,
    /// canvas.csv in the --out folder: final marks for Canvas's gradebook
    Canvas,
    /// moodle.csv in the --out folder: final marks for Moodle's grading worksheet
    Moodle,
    /// feedback*.zip in the --out folder: the reports, in three archives: one for Canvas,
    /// one for Moodle, and one with a folder for each id
    Feedback,
}

/// One part of an assignment that earns points.
struct Part {
    suite: String,
    name: String,
    about: String,
    points: u32,
    possible: u32,
    outcome: Status,
    said: String,
}

impl Format {
    /// The file's name beside each result; `None` for a file of the whole class.
    pub fn file_of_each(self) -> Option<&'static str> {
        match self {
            Format::Gradescope => Some("gradescope.json"),
            Format::Junit => Some("junit.xml"),
            Format::Prairielearn => Some("prairielearn.json"),
            Format::Classroom50 => Some("classroom50.json"),
            Format::Csv | Format::Canvas | Format::Moodle | Format::Feedback => None,
        }
    }

    /// The file's content for a submission, if there is such a file.
    pub fn of(self, record: &Record) -> Result<Option<String>> {
        Ok(match self {
            Format::Gradescope => gradescope(record).map(|it| pretty(&it)).transpose()?,
            Format::Junit => Some(junit(record)),
            Format::Prairielearn => Some(pretty(&prairielearn(record))?),
            Format::Classroom50 => {
                let runner = |name: &str| std::env::var(name).ok();
                let result = classroom50(record, &runner);
                result.map(|it| pretty(&it)).transpose()?
            }
            Format::Csv | Format::Canvas | Format::Moodle | Format::Feedback => None,
        })
    }
}

fn parts(record: &Record) -> Vec<Part> {
    let groups = record.got.tasks.iter().flat_map(|task| {
        // Say what concerns the whole task only once, at the first group that fails, because
        // PrairieLearn takes no results of more than 1 MB.
        let mut problem = task.file.problem();
        let mut help = Some(help(task));
        task.groups.iter().map(move |group| Part {
            suite: task.name.clone(),
            name: group.name.clone(),
            about: group.about.clone(),
            points: group.points,
            possible: group.possible,
            outcome: match task.file {
                _ if group.is_of_examples() => group.outcome.status(),
                AnswerFile::Compiled => group.outcome.status(),
                _ => task.status(),
            },
            said: match task.file {
                _ if group.is_of_examples() => shown(group).join("\n"),
                AnswerFile::Compiled if group.points == group.possible => "passes".into(),
                AnswerFile::Compiled => {
                    let help = help.take().unwrap_or_default();
                    [&help[..], &shown(group)].concat().join("\n")
                }
                _ => problem.take().unwrap_or(task.status().word().into()),
            },
        })
    });
    // Points that the fresh questions cost are taken from the scenes one by one, beginning with the
    // last, so that the parts add up to the mark.
    let mut left = record.scene_points().0;
    let scenes = record.got.scenes.iter().map(|scene| {
        let points = scene.points.min(left);
        left -= points;
        let said = match points < scene.points {
            true => "the picture passes, but the answers behind it fail fresh questions".into(),
            false => terminal::outcome(&scene.outcome),
        };
        Part {
            suite: "scenes".into(),
            name: scene.name.clone(),
            about: String::new(),
            points,
            possible: scene.possible,
            outcome: scene.outcome.status(),
            said,
        }
    });
    groups.chain(scenes).collect()
}

/// What the student may believe, and where to look. An outcome has no such help where it would
/// give something away about withheld questions.
fn help(task: &TaskOutcome) -> Vec<String> {
    let said = terminal::diagnosis(&task.diagnosis);
    let said = said.lines().map(str::to_owned);
    let beliefs = task.diagnosis.beliefs.iter();
    let hints = beliefs.map(|held| format!("Hint: {}", held.mistake.hint.look));
    said.chain(hints).collect()
}

/// A question that shows what is wrong. The number of wrong questions is given only if there is
/// no question to show.
fn shown(group: &GroupOutcome) -> Vec<String> {
    let said = terminal::group_in_words(group);
    let facts = terminal::facts(&group.worst);
    match facts.is_empty() {
        true => vec![said],
        false if group.is_of_examples() => vec![said, facts],
        false => vec![
            "One of the questions that were answered wrongly:".into(),
            facts,
        ],
    }
}

/// Gradescope's results, as <https://gradescope-autograders.readthedocs.io/en/latest/specs/>
/// describes them; `None` without a mark. Gradescope then says that grading failed, and
/// records no score.
fn gradescope(record: &Record) -> Option<Value> {
    let points = record.got.points?;
    let tests = parts(record).into_iter().enumerate().map(|(k, part)| {
        json!({
            "name": format!("{}: {}", part.suite, part.name),
            "number": (k + 1).to_string(),
            "score": part.points,
            "max_score": part.possible,
            "status": if part.points == part.possible { "passed" } else { "failed" },
            "output": text(&part),
            "visibility": "visible",
        })
    });
    // Leave out the execution time, because it would give something away about withheld
    // questions.
    Some(json!({
        "score": points,
        "output": format!("{} Judged on {}.", record.explanation, record.provenance.made_with.judged_on),
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": { "judged_on": record.provenance.made_with.judged_on, "outcome": record.status },
        "tests": tests.collect::<Vec<_>>(),
    }))
}

/// PrairieLearn's results, as <https://prairielearn.readthedocs.io/en/latest/externalGrading/>
/// describes them.
fn prairielearn(record: &Record) -> Value {
    let Some(points) = record.got.points else {
        return json!({ "gradable": false, "format_errors": printable_lines(&record.explanation) });
    };
    let tests = parts(record).into_iter().map(|part| {
        json!({
            "name": format!("{}: {}", part.suite, part.name),
            "description": part.about,
            "points": part.points,
            "max_points": part.possible,
            "output": text(&part),
        })
    });
    json!({
        "gradable": true,
        "score": f64::from(points) / f64::from(record.got.possible.max(1)),
        "message": format!("{} Judged on {}.", record.explanation, record.provenance.made_with.judged_on),
        "tests": tests.collect::<Vec<_>>(),
    })
}

/// Follows <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>, “The
/// `result.json` contract”, and `schemas/result-v1.schema.json` there. The runner's environment
/// names the classroom, the assignment and the submission; the runner itself adds the owner and the
/// kind of assignment. `None` without a mark, so that the runner reports an error of its own.
fn classroom50(record: &Record, runner: &dyn Fn(&str) -> Option<String>) -> Option<Value> {
    let points = record.got.points?;
    let tests = parts(record).into_iter().map(|part| {
        json!({
            "test-name": format!("{}: {}", part.suite, part.name),
            "passed": part.points == part.possible,
            "score": part.points,
            "max-score": part.possible,
            "output": text(&part),
        })
    });
    let mut result = json!({
        "schema": "classroom50/result/v1",
        "datetime": Timestamp::now().strftime("%Y-%m-%dT%H:%M:%SZ").to_string(),
        "score": points,
        "max-score": record.got.possible,
        "tests": tests.collect::<Vec<_>>(),
    });
    let review = runner("REVIEW_URL").filter(|url| !url.is_empty());
    for (field, value) in [
        ("classroom", runner("CLASSROOM")),
        ("assignment", runner("ASSIGNMENT")),
        ("submission", runner("SUBMISSION_TAG")),
        ("commit", runner("COMMIT_URL")),
        ("release", runner("RELEASE_URL")),
        ("review", review.or(runner("COMMIT_URL"))),
    ] {
        if let Some(value) = value {
            result[field] = value.into();
        }
    }
    Some(result)
}

/// A test suite for `templates/junit.xml`.
#[derive(Serialize)]
struct Suite {
    name: String,
    cases: Vec<Case>,
}

#[derive(Serialize)]
struct Case {
    name: String,
    /// The element inside, which says that it does not pass.
    element: Option<&'static str>,
    kind: &'static str,
    said: String,
}

fn junit(record: &Record) -> String {
    let mut suites: Vec<Suite> = Vec::new();
    for part in parts(record) {
        let case = Case {
            element: (part.points < part.possible).then_some("failure"),
            kind: part.outcome.word(),
            said: xml_text(&text(&part)),
            name: part.name,
        };
        match suites.last_mut().filter(|suite| suite.name == part.suite) {
            Some(suite) => suite.cases.push(case),
            None => suites.push(Suite {
                name: part.suite,
                cases: vec![case],
            }),
        }
    }
    if !record.is_graded() {
        let name = "grading".to_owned();
        let case = Case {
            name: name.clone(),
            element: Some("error"),
            kind: record.status.word(),
            said: xml_text(&printable_lines(&record.explanation)),
        };
        suites = vec![Suite {
            name,
            cases: vec![case],
        }];
    }
    let cases: Vec<&Case> = suites.iter().flat_map(|suite| &suite.cases).collect();
    let junit = include_str!("../../../templates/junit.xml");
    let environment = environment(&[("junit.xml", junit)]);
    let page = environment.get_template("junit.xml").and_then(|template| {
        let id = &record.id;
        let judged_on = &record.provenance.made_with.judged_on;
        template
            .render(context! { id, judged_on, suites => Serde(&suites), cases => Serde(&cases) })
    });
    page.unwrap_or_else(|error| panic!("junit.xml's template: {error:#}"))
}

/// The text about a part. We don't know how other graders show it, so it contains no control
/// characters for terminals.
fn text(part: &Part) -> String {
    let mut lines = vec![part.said.as_str()];
    if part.points < part.possible && !part.about.is_empty() {
        lines.insert(0, &part.about);
    }
    printable_lines(&lines.join("\n"))
}

fn printable_lines(text: &str) -> String {
    text.lines().map(printable).collect::<Vec<_>>().join("\n")
}

/// Text without the characters that XML cannot contain. The template escapes the rest.
fn xml_text(text: &str) -> String {
    let cannot = |c: char| c != '\n' && (c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'));
    text.replace(cannot, "\u{fffd}")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::grade::record::tests::graded;
    use pinhole_course::outcome::{FilmOutcome, Outcome, SceneOutcome};

    /// A control sequence, a character that reorders others, markup, and a second line.
    const HOSTILE: &str = "\u{1b}]0;x\u{7}\u{202e}<script>\u{9b}2J\nnext";

    fn record() -> Record {
        let refused = FilmOutcome::Refused {
            why: HOSTILE.into(),
        };
        let mut got = Outcome::new("Assignment", HOSTILE.into(), "bubblewrap");
        got.scenes = vec![SceneOutcome::new("scene".into(), 5, refused, Some(0.25))];
        got.add_up();
        Record {
            status: got.status(),
            got,
            ..graded("ada", 0, 5)
        }
    }

    #[test]
    fn a_result_for_classroom_50_has_the_documented_fields_and_no_others() {
        let runner = |name: &str| Some(format!("submit/{name}"));
        let result = classroom50(&record(), &runner).expect("it has a mark");
        let fields: BTreeSet<&str> = result
            .as_object()
            .into_iter()
            .flat_map(|it| it.keys())
            .map(String::as_str)
            .collect();
        // Those that its schema requires, without the two that the runner adds.
        let documented = [
            "schema",
            "classroom",
            "assignment",
            "submission",
            "commit",
            "release",
            "review",
            "datetime",
            "score",
            "max-score",
            "tests",
        ];
        assert_eq!(fields, documented.into());
        for value in [&result, &result["tests"][0]] {
            let points = ["score", "max-score"].map(|name| value[name].as_u64());
            assert!(points[0].is_some() && points[0] <= points[1], "{value}");
        }
        assert!(result["tests"][0]["test-name"].is_string());
        assert!(result["tests"][0]["passed"].is_boolean());
    }

    #[test]
    fn message_of_the_compiler_is_given_once_for_a_task() {
        let group = |name: &str| {
            json!({
                "name": name, "about": "", "points": 0, "possible": 7,
                "outcome": { "kind": "unanswered" }, "worst": [], "fails_fresh": false,
            })
        };
        let mut record = serde_json::to_value(graded("ada", 0, 14)).expect("it can be written");
        record["tasks"] = json!([{
            "name": "triangle", "chapter": "", "points": 0, "possible": 14,
            "file": { "state": "does not compile", "compiler": "error: no" }, "diagnosis": null,
            "groups": [group("edges"), group("front")],
        }]);
        let record = serde_json::from_value(record).expect("a record");
        let said: Vec<String> = parts(&record).into_iter().map(|it| it.said).collect();
        assert_eq!(said, ["error: no", "does not compile"]);
    }

    /// Every text in a document.
    fn texts(value: &Value) -> Vec<&str> {
        match value {
            Value::String(text) => vec![text],
            Value::Array(values) => values.iter().flat_map(texts).collect(),
            Value::Object(fields) => fields.values().flat_map(texts).collect(),
            _ => Vec::new(),
        }
    }

    #[test]
    fn no_format_passes_on_control_characters_or_markup() {
        let failing = record();
        let not_graded = record().not_graded(HOSTILE.into());
        let is_hostile = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        for record in [&failing, &not_graded] {
            let documents = [gradescope(record).unwrap_or_default(), prairielearn(record)];
            for text in documents.iter().flat_map(texts) {
                assert!(!text.contains(is_hostile), "{text:?}");
            }
            let xml = junit(record);
            assert!(xml.contains("2J"), "{xml}");
            assert!(
                !xml.contains(is_hostile) && !xml.contains("<script>"),
                "{xml:?}"
            );
        }
    }
}
