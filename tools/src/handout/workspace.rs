//! The workspace around a student's answers: the course's own, without what students
//! do not have.

use super::{Files, tables};
use crate::assignment::Assignment;
use crate::error::{Error, Result};

/// In a student's hands this replaces the course's `[workspace]`.
fn members(assignment: &str) -> String {
    format!(
        "[workspace]\n\
         members = [\"assignments/{assignment}/handout\", \"tools\"]\n\
         # `cargo test` tests your answers. `cargo run` is the `pinhole` command: only its\n\
         # package names a program to run by default.\n\
         default-members = [\"assignments/{assignment}/handout\", \"tools\"]\n\
         resolver = \"3\"\n\n"
    )
}

/// The feature that students' command is built without, and the sources that go with it:
/// they hold formulas which students are to find.
const FEATURE: &str = "validate";
const ITS_SOURCES: [&str; 3] = [
    "tools/src/validate/",
    "tools/src/validate.rs",
    "tools/src/command/validate.rs",
];
/// Where its modules are declared; rustfmt looks for them whatever the features are.
const ITS_PARENTS: [&str; 2] = ["tools/src/main.rs", "tools/src/command.rs"];

/// Where the workflow for GitHub lies.
const WORKFLOW: &str = ".github/workflows/check.yml";

/// Turns the course's manifests into a student's, and adds the workflow.
pub fn adapt(files: &mut Files, assignment: &Assignment) -> Result<()> {
    change(files, "Cargo.toml", |text| {
        let mut tables = tables::cut(text);
        tables.retain(|table| !table.header.contains("-reference"));
        for table in tables
            .iter_mut()
            .filter(|table| table.header == "[workspace]")
        {
            table.text = members(&assignment.name);
        }
        tables::join(tables)
    })?;
    change(files, "tools/Cargo.toml", |text| {
        let mut tables = tables::cut(text);
        // Benches and whole-program tests stay at home, and with them what they need.
        let ours = |header: &str| header == "[[bench]]" || header.ends_with(".dev-dependencies]");
        tables.retain(|table| !ours(&table.header));
        for table in &mut tables {
            match table.header.as_str() {
                "[dev-dependencies]" => keep_lines(&mut table.text, |line| {
                    ["[", "tempfile"].iter().any(|kept| line.starts_with(kept))
                }),
                "[features]" => {
                    let default = format!("default = [\"{FEATURE}\"]");
                    table.text = table.text.replace(&default, "default = []");
                }
                "[[bin]]" => {
                    let text = table.text.trim_end();
                    table.text = format!("{text}\n# Tested at home.\ntest = false\n\n");
                }
                _ => {}
            }
        }
        tables::join(tables)
    })?;
    files.retain(|path, _| !ITS_SOURCES.iter().any(|own| path.starts_with(own)));
    for parent in ITS_PARENTS {
        let module = format!("#[cfg(feature = \"{FEATURE}\")]\nmod {FEATURE};\n");
        change(files, parent, |text| text.replace(&module, ""))?;
    }
    let workflow = include_str!("../../templates/handout/check.yml");
    files.insert(WORKFLOW.into(), workflow.into());
    Ok(())
}

fn keep_lines(text: &mut String, keep: impl Fn(&str) -> bool) {
    let kept: Vec<&str> = text.lines().filter(|line| keep(line)).collect();
    *text = format!("{}\n\n", kept.join("\n"));
}

/// Puts another text in place of a file's.
pub fn change(files: &mut Files, path: &str, change: impl FnOnce(&str) -> String) -> Result<()> {
    let text = files
        .get(path)
        .and_then(|bytes| std::str::from_utf8(bytes).ok());
    let Some(text) = text else {
        return Err(Error::input(
            format!("{path} is no text"),
            "restore the file; a checkout of the course has it",
        ));
    };
    let text = change(&text.replace("\r\n", "\n"));
    files.insert(path.into(), text.into());
    Ok(())
}
