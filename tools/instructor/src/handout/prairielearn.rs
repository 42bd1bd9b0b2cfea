//! A question for PrairieLearn: its folder, and the files of the image that grades it.
//!
//! Follows <https://prairielearn.readthedocs.io/en/latest/externalGrading/>. The image contains
//! every golden and our answers, so it is for instructors only.

use std::fs;
use std::path::Path;

use serde_json::json;

use super::{Files, HandoutSize, gradescope};
use crate::grade::cache::pretty;
use crate::grade::provenance::sha256;
use crate::grade::redact::Reveal;
use pinhole_course::assignment::{Assignment, Task, examples_file};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::private::{is_private, make_private};

const DOCKERFILE: &str = include_str!("../../templates/handout/prairielearn/Dockerfile");
const RUN: &str = include_str!("../../templates/handout/prairielearn/run.sh");
const README: &str = include_str!("../../templates/handout/prairielearn/README.md");

/// Writes the question to a folder that is new or empty.
pub fn write(
    assignment: &Assignment,
    checkout: &Checkout,
    fresh: Option<&Path>,
    reveal: Reveal,
    out: &Path,
) -> Result<HandoutSize> {
    let is_empty = fs::read_dir(out).map_or(true, |mut entries| entries.next().is_none());
    if !is_empty {
        return Err(Error::input(
            format!("{} is not empty", out.display()),
            "name a new folder",
        ));
    }
    let mut files = question(assignment)?;
    let course = gradescope::course(assignment, checkout, fresh, reveal)?;
    let course = course.into_iter();
    files.extend(course.map(|(name, bytes)| (format!("image/pinhole/{name}"), bytes)));
    let failed = |path: &Path| {
        Error::environment(
            format!("cannot write {}", path.display()),
            "free some disk space, and check that the folder can be written",
        )
    };
    fs::create_dir_all(out)
        .and_then(|()| make_private(out))
        .or_fail(&failed(out))?;
    if !is_private(out) {
        return Err(Error::input(
            format!("another user has made {}", out.display()),
            "name a new folder",
        ));
    }
    let mut bytes = 0;
    for (name, content) in &files {
        let path = out.join(name);
        let failed = failed(&path);
        let folder = path.parent().unwrap_or(out);
        fs::create_dir_all(folder).or_fail(&failed)?;
        fs::write(&path, content).or_fail(&failed)?;
        bytes += content.len() as u64;
    }
    Ok(HandoutSize {
        files: files.len(),
        bytes,
    })
}

/// Everything except the course that the image grades with.
fn question(assignment: &Assignment) -> Result<Files> {
    let names: Vec<String> = assignment.tasks.iter().map(Task::file).collect();
    let names = names.join(",");
    let earlier = assignment.answerable().skip(assignment.tasks.len());
    let examples = assignment.with_examples();
    let examples = examples.map(|task| examples_file(&task.name));
    let optional: Vec<String> = earlier.map(Task::file).chain(examples).collect();
    let optional = match optional.as_slice() {
        [] => String::new(),
        names => format!(" optional-file-names=\"{}\"", names.join(",")),
    };
    let info = json!({
        "uuid": uuid(&assignment.name),
        "title": assignment.title,
        "topic": "Programming",
        "type": "v3",
        // Nothing in it is random.
        "singleVariant": true,
        "gradingMethod": "External",
        "externalGradingOptions": {
            "enabled": true,
            "image": format!("REGISTRY/pinhole-{}", assignment.name.replace('_', "-")),
            "entrypoint": "/grade/tests/run.sh",
            "timeout": 600,
        },
    });
    let html = format!(
        "<pl-question-panel>\n  <p>Hand in the files of your answers.</p>\n  \
         <pl-file-upload file-names=\"{names}\"{optional}></pl-file-upload>\n</pl-question-panel>\n\n\
         <pl-submission-panel>\n  <pl-external-grader-results></pl-external-grader-results>\n  \
         <pl-file-preview></pl-file-preview>\n</pl-submission-panel>\n"
    );
    let files = [
        ("README.md", README.to_owned()),
        ("image/Dockerfile", DOCKERFILE.to_owned()),
        ("question/info.json", pretty(&info)?),
        ("question/question.html", html),
        ("question/tests/run.sh", RUN.to_owned()),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), text.replace('\r', "").into_bytes()));
    Ok(files.into_iter().collect())
}

/// The question's UUID. PrairieLearn recognises questions by it, so it must be the same every
/// time. It has version 8 of RFC 9562, which lets us choose the bits.
fn uuid(name: &str) -> String {
    let hash = sha256(format!("pinhole question {name}").as_bytes());
    let (a, b, c, d, e) = (
        &hash[..8],
        &hash[8..12],
        &hash[13..16],
        &hash[17..20],
        &hash[20..32],
    );
    format!("{a}-{b}-8{c}-a{d}-{e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_names_every_answer_file_and_its_grader() {
        let checkout = Checkout::at(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")));
        let mut assignment = Assignment::read(&checkout, "bounding_volumes").expect("it is there");
        let points = toml::from_str("points = 2\ncatch = 0.8").expect("it is right");
        assignment.tasks[0].examples = Some(points);
        let files = question(&assignment).expect("it can be made");
        let text = |name: &str| String::from_utf8_lossy(&files[name]).into_owned();
        let info: serde_json::Value =
            serde_json::from_str(&text("question/info.json")).expect("it is JSON");
        let entrypoint = info["externalGradingOptions"]["entrypoint"].as_str();
        let entrypoint = entrypoint
            .expect("it has one")
            .replace("/grade/", "question/");
        assert!(files.contains_key(&entrypoint), "{entrypoint}");
        let uuid = info["uuid"].as_str().expect("it has one");
        let lengths: Vec<usize> = uuid.split('-').map(str::len).collect();
        assert_eq!(lengths, [8, 4, 4, 4, 12], "{uuid}");
        let html = text("question/question.html");
        for task in &assignment.tasks {
            assert!(html.contains(&task.file()), "{html}");
        }
        let (first, earlier) = (&assignment.tasks[0].name, "triangle.rs");
        let optional = format!(" optional-file-names=\"{earlier},{first}.examples.toml\"");
        assert!(html.contains(&optional), "{html}");
    }
}
