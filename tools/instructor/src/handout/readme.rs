//! A student's README: a template, filled with the assignment's README, the book's page about
//! file formats, and a table of points.

use super::sources::read_text;
use super::{Files, place_of};
use pinhole_course::assignment::{Assignment, ScenePoints, Task, examples_file};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};

const TEMPLATE: &str = include_str!("../../templates/handout/README.md");

/// The page of the book that describes scene and film files.
const FORMATS: &str = "book/src/appendix/scene_and_film_files.md";

/// The beginning of a template line that a section replaces. The section's heading follows.
const QUOTED: &str = "<!-- quoted: ";

/// The first word of a template line that stays only if the handout has this file (or, with
/// `false`, lacks it).
const ONLY_IF: [(&str, bool, &str); 3] = [
    ("<!-- book -->", true, "book/index.html"),
    ("<!-- no book -->", false, "book/index.html"),
    (
        "<!-- meshes -->",
        true,
        "<!-- folder -->/scenes/meshes/README.md",
    ),
];

/// Replaces the course's README with a student's. A section is quoted from the first of these that
/// has it: the assignment's own README, the course's, the page about formats.
pub fn adapt(files: &mut Files, assignment: &Assignment, checkout: &Checkout) -> Result<()> {
    let folder = place_of(assignment);
    let scene = assignment.scenes.iter().find(|scene| scene.public);
    let scene = scene.map_or("SCENE", |scene| &scene.name);
    let fill = |text: &str| {
        let examples = assignment.with_examples();
        let examples = examples.map(|task| examples_file(&task.name));
        let files = assignment.tasks.iter().map(Task::file).chain(examples);
        let answers: Vec<String> = files.map(|file| format!("`{file}`")).collect();
        text.replace("<!-- points -->", points(assignment).trim_end())
            .replace("<!-- answers -->", &answers.join(", "))
            .replace("<!-- folder -->", &folder)
            .replace("<!-- name -->", &assignment.name)
            .replace("<!-- start -->", &assignment.start)
            .replace("<!-- scene -->", scene)
    };
    let own = assignment.folder.join("README.md");
    let own = match own.is_file() {
        // Its links lead from the assignment's folder, those of a student's README from the root.
        true => read_text(&own)?.replace("\"../../", "\""),
        false => String::new(),
    };
    let course = files
        .get("README.md")
        .map(|bytes| String::from_utf8_lossy(bytes));
    let course = course.unwrap_or_default().replace("\r\n", "\n");
    let formats = read_text(&checkout.root().join(FORMATS))?;
    let sources = [&own, &course, &formats];
    let golden = |name: &str| format!("golden/{name}/");
    let (others, its) = (
        golden(&checkout.default_assignment()?),
        golden(&assignment.name),
    );
    let mut missing = None;
    let mut text = String::new();
    for line in TEMPLATE.lines() {
        let mut only = ONLY_IF.iter();
        let line = match only.find(|(word, ..)| line.starts_with(word)) {
            Some((_, has, file)) if files.contains_key(&fill(file)) != *has => continue,
            Some((word, ..)) => &line[word.len()..],
            None => line,
        };
        let heading = line
            .strip_prefix(QUOTED)
            .and_then(|rest| rest.strip_suffix(" -->"));
        let quoted = |heading| sources.iter().find_map(|text| section(text, heading));
        match heading.map(|heading| (heading, quoted(heading))) {
            Some((_, Some(section))) => {
                text.push_str(&section.trim_end().replace(&others, &its));
            }
            Some((heading, None)) => missing = Some(heading),
            None => text.push_str(&fill(line)),
        }
        text.push('\n');
    }
    files.insert("README.md".into(), text.into());
    match missing {
        None => Ok(()),
        Some(heading) => Err(Error::input(
            format!("neither README.md nor {FORMATS} has a section `{heading}` for students"),
            "restore it, or correct tools/instructor/templates/handout/README.md, which quotes it",
        )),
    }
}

/// A table of the points of each task and of all scenes.
fn points(assignment: &Assignment) -> String {
    let mut table = "| answer | points |\n| --- | --- |\n".to_owned();
    for task in &assignment.tasks {
        let worth: u32 = task.points.iter().map(|group| group.worth).sum();
        table.push_str(&format!("| `{}` | {worth} |\n", task.file()));
        if let Some(examples) = &task.examples {
            let (file, worth) = (examples_file(&task.name), examples.get_ref().points);
            table.push_str(&format!("| `{file}` | {worth} |\n"));
        }
    }
    let (public, withheld): (Vec<_>, Vec<_>) =
        assignment.scenes.iter().partition(|scene| scene.public);
    let sum = |scenes: &[&ScenePoints]| scenes.iter().map(|scene| scene.points).sum::<u32>();
    let row = format!(
        "| all of them together, in {} scenes | {} |\n",
        public.len(),
        sum(&public)
    );
    table.push_str(&row);
    if !withheld.is_empty() {
        let row = format!(
            "| scenes that are used only in grading | {} |\n",
            sum(&withheld)
        );
        table.push_str(&row);
    }
    table
}

/// A section with its heading. The section `beginning` is everything before the first heading.
fn section<'a>(readme: &'a str, heading: &str) -> Option<&'a str> {
    let start = match heading {
        "beginning" if readme.is_empty() => return None,
        "beginning" => 0,
        _ => readme.find(&format!("\n## {heading}\n"))? + 1,
    };
    let text = &readme[start..];
    let end = text[1..].find("\n## ").map_or(text.len(), |end| end + 2);
    Some(&text[..end])
}
