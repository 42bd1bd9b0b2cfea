//! Results as other graders' files: Gradescope's `results.json`, JUnit's XML and
//! PrairieLearn's `results.json`. Each is a view of a record.

use clap::ValueEnum;
use minijinja::{context, value::Serde};
use serde::Serialize;
use serde_json::{Value, json};

use crate::grade::cache::pretty;
use crate::grade::record::Record;
use pinhole_course::error::Result;
use pinhole_course::outcome::{AnswerFile, Status};
use pinhole_report::escape::printable;
use pinhole_report::html::environment;
use pinhole_report::terminal;

/// A file to write beside each result.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub enum Format {
    /// gradescope.json: Gradescope's results.json
    Gradescope,
    /// junit.xml: a test for each group of questions and each scene
    Junit,
    /// prairielearn.json: PrairieLearn's results.json
    Prairielearn,
    /// groups.csv in the class's folder: a line for each group of questions
    Csv,
}

/// One thing that earns points.
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
    /// The file's name and content for a submission; none for the class's own.
    pub fn of(self, record: &Record) -> Result<Option<(&'static str, String)>> {
        Ok(match self {
            Format::Gradescope => match gradescope(record) {
                Some(document) => Some(("gradescope.json", pretty(&document)?)),
                None => None,
            },
            Format::Junit => Some(("junit.xml", junit(record))),
            Format::Prairielearn => Some(("prairielearn.json", pretty(&prairielearn(record))?)),
            Format::Csv => None,
        })
    }
}

fn parts(record: &Record) -> Vec<Part> {
    let groups = record.got.tasks.iter().flat_map(|task| {
        task.groups.iter().map(|group| Part {
            suite: task.name.clone(),
            name: group.name.clone(),
            about: group.about.clone(),
            points: group.points,
            possible: group.possible,
            outcome: match task.file {
                AnswerFile::Compiled => group.outcome.status(),
                _ => task.status(),
            },
            said: match &task.file {
                AnswerFile::DoesNotCompile { compiler } => {
                    anstream::adapter::strip_str(compiler).to_string()
                }
                _ => terminal::outcome_of(&group.outcome, "questions"),
            },
        })
    });
    // What fresh questions have shown takes points from the scenes one by one, the last
    // first, so that the parts add up to the mark.
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

/// None without a mark: Gradescope then says that grading failed, and records no score.
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
    // No execution time: it would tell what withheld questions cost.
    Some(json!({
        "score": points,
        "output": record.explanation,
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": { "judged_on": record.provenance.made_with.judged_on, "outcome": record.status },
        "tests": tests.collect::<Vec<_>>(),
    }))
}

fn prairielearn(record: &Record) -> Value {
    let Some(points) = record.got.points else {
        return json!({ "gradable": false, "message": printable_lines(&record.explanation) });
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
        "message": record.explanation,
        "tests": tests.collect::<Vec<_>>(),
    })
}

/// A suite of JUnit's, as `templates/junit.xml` shows it.
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
            element: match part.outcome {
                _ if part.points == part.possible => None,
                Status::Unanswered => Some("skipped"),
                _ => Some("failure"),
            },
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
        template.render(context! { id, suites => Serde(&suites), cases => Serde(&cases) })
    });
    page.unwrap_or_else(|error| panic!("junit.xml's template: {error:#}"))
}

/// The text about a part. We don't know how other graders show it, so it holds nothing that
/// a terminal takes for a command.
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

/// Text without the characters that XML cannot hold; the template escapes the rest.
fn xml_text(text: &str) -> String {
    let cannot = |c: char| c != '\n' && (c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'));
    text.replace(cannot, "\u{fffd}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::provenance::{MadeWith, Provenance, Tool};
    use crate::grade::record::Timings;
    use pinhole_course::outcome::{FilmOutcome, Outcome, SceneOutcome};

    /// A terminal's command, a character that reorders others, markup, and a second line.
    const HOSTILE: &str = "\u{1b}]0;x\u{7}\u{202e}<script>\u{9b}2J\nnext";

    fn record() -> Record {
        let refused = FilmOutcome::Refused {
            why: HOSTILE.into(),
        };
        let mut got = Outcome::new("Assignment", HOSTILE.into(), "bubblewrap");
        got.scenes = vec![SceneOutcome::new("scene".into(), 5, refused, 0.25)];
        got.add_up();
        Record {
            id: "ada".into(),
            status: got.status(),
            explanation: String::new(),
            got,
            fresh_scenes: Vec::new(),
            most_for_scenes: None,
            tokens: Default::default(),
            provenance: Provenance {
                answers: Vec::new(),
                made_with: MadeWith {
                    judged_on: "public goldens only".into(),
                    seed: None,
                    goldens: String::new(),
                    fresh: None,
                    assignment: String::new(),
                    tool: Tool {
                        version: String::new(),
                        sha256: String::new(),
                        rustc: String::new(),
                    },
                    sandbox: "bubblewrap".into(),
                    timeout: 10,
                    reveal: None,
                },
            },
            timings: Timings::default(),
        }
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
    fn no_format_passes_on_commands_or_markup_of_a_students() {
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
