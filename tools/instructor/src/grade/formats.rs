//! Results as other graders' files: Gradescope's `results.json`, JUnit's XML and
//! PrairieLearn's `results.json`. Each is a view of a record.

use clap::ValueEnum;
use serde_json::{Value, json};

use super::record::Record;
use super::store::pretty;
use pinhole_course::error::Result;
use pinhole_course::escape::printable;
use pinhole_course::outcome::{AnswerFile, Status};
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
        return json!({ "gradable": false, "message": record.explanation });
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

fn junit(record: &Record) -> String {
    let parts = parts(record);
    let mut suites: Vec<&str> = parts.iter().map(|part| part.suite.as_str()).collect();
    suites.dedup();
    let mut body = String::new();
    let mut sums = [0; 3];
    for suite in suites {
        let own: Vec<&Part> = parts.iter().filter(|part| part.suite == suite).collect();
        let skipped = own
            .iter()
            .filter(|part| part.outcome == Status::Unanswered)
            .count();
        let passing = own
            .iter()
            .filter(|part| part.points == part.possible)
            .count();
        let failures = own.len() - skipped - passing;
        for (sum, count) in sums.iter_mut().zip([own.len(), failures, skipped]) {
            *sum += count;
        }
        body.push_str(&format!(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{failures}\" errors=\"0\" skipped=\"{skipped}\" time=\"0\">\n",
            xml(suite),
            own.len()
        ));
        for part in own {
            let [name, class] = [&part.name, &part.suite].map(|text| xml(text));
            body.push_str(&format!(
                "    <testcase name=\"{name}\" classname=\"{class}\" time=\"0\""
            ));
            let said = xml(&text(part));
            body.push_str(&match part.points == part.possible {
                true => "/>\n".into(),
                false if part.outcome == Status::Unanswered => {
                    "><skipped message=\"unanswered\"/></testcase>\n".into()
                }
                false => {
                    let kind = part.outcome.word();
                    format!(
                        "><failure type=\"{kind}\" message=\"{kind}\">{said}</failure></testcase>\n"
                    )
                }
            });
        }
        body.push_str("  </testsuite>\n");
    }
    if !record.is_graded() {
        let why = xml(&record.explanation);
        body = format!(
            "  <testsuite name=\"grading\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0\">\n    \
             <testcase name=\"grading\" classname=\"grading\" time=\"0\"><error type=\"not graded\" message=\"not graded\">{why}</error></testcase>\n  \
             </testsuite>\n"
        );
    }
    let errors = u32::from(!record.is_graded());
    let [tests, failures, skipped] = sums;
    let tests = tests.max(errors as usize);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\" time=\"0\">\n{body}</testsuites>\n",
        xml(&record.id)
    )
}

/// What somebody reads of a part; others show it as they please, so it holds nothing that
/// could be taken for a command or markup.
fn text(part: &Part) -> String {
    let mut lines = vec![part.said.as_str()];
    if part.points < part.possible && !part.about.is_empty() {
        lines.insert(0, &part.about);
    }
    let lines = lines.iter().flat_map(|text| text.lines()).map(printable);
    lines.collect::<Vec<_>>().join("\n")
}

/// Text inside XML: escaped, and without the characters that XML cannot hold.
fn xml(text: &str) -> String {
    let mut safe = String::new();
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&apos;"),
            '\n' => safe.push_str("&#10;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}
