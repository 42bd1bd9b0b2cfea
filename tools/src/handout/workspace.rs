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

/// The features that students' command is built without, and the sources that go with
/// them: they hold formulas which students are to find, or belong to a package that does.
const FEATURES: [&str; 2] = ["validate", "study"];
/// Where their modules are declared; rustfmt looks for them whatever the features are.
const PARENTS: [&str; 3] = [
    "tools/src/main.rs",
    "tools/src/cli.rs",
    "tools/src/command.rs",
];
/// Whose profiles only such a package needs: cargo warns of profiles for nobody.
const AT_HOME: [&str; 4] = ["bvh", "dashu-", "obvhs", "parry3d"];

/// Whether a source belongs to one of [`FEATURES`].
fn stays(path: &str) -> bool {
    FEATURES.iter().any(|feature| {
        let own = ["tools/src/", "tools/src/cli/", "tools/src/command/"]
            .map(|folder| format!("{folder}{feature}"));
        own.iter().any(|own| {
            let rest = path.strip_prefix(own.as_str());
            rest.is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
        })
    })
}

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
        for table in tables
            .iter_mut()
            .filter(|table| table.header == "[profile.release.package]")
        {
            keep_lines(&mut table.text, |line| {
                !AT_HOME.iter().any(|package| line.starts_with(package))
            });
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
                    let features = FEATURES.map(|feature| format!("\"{feature}\""));
                    let default = format!("default = [{}]", features.join(", "));
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
    files.retain(|path, _| !stays(path));
    for (parent, feature) in PARENTS.iter().flat_map(|p| FEATURES.map(|f| (*p, f))) {
        let module = format!("#[cfg(feature = \"{feature}\")]\nmod {feature};\n");
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
