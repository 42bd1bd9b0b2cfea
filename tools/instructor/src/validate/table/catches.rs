//! What each group of questions and each scene catches.

use textwrap::{fill, indent};

use super::QUIET;
use crate::validate::catches::{DetectionRow, DetectionTable};

/// How many characters fit into a line.
const LINE: usize = 86;

/// How many mistakes a row names.
const MOST_NAMED: usize = 3;

/// A row for each group and each scene.
pub fn table(catches: &DetectionTable) -> String {
    let mut text = format!(
        "\nmistakes: how many single mistakes, of {} in all, fail in this group or scene;\n\
         unique: how many of these fail in no other group, or in no other scene;\n\
         only here: how many of these fail nowhere else, neither in a group nor in a scene.",
        catches.mistakes
    );
    if let Some(mutants) = catches.mutants {
        text += &format!(
            "\nmutants: of the {mutants} mutants that their own task's questions catch, how many\n\
             fail in this group; only: how many of these fail in no other group."
        );
    }
    text += "\n";
    let names = catches.probes.iter().chain(&catches.scenes);
    let width = names.map(|catch| catch.name.len()).max().unwrap_or(0) + 2;
    let mutants = |columns: String| catches.mutants.map(|_| columns).unwrap_or_default();
    for (kind, rows) in [("groups", &catches.probes), ("scenes", &catches.scenes)] {
        let is_probe = kind == "groups";
        // Mutants are judged only by their own task's questions.
        if !is_probe && catches.mistakes == 0 {
            continue;
        }
        let heads = match is_probe {
            true => mutants(format!("  {:>7}  {:>4}", "mutants", "only")),
            false => String::new(),
        };
        text += &format!(
            "\n{QUIET}  {kind:<width$}{:>8}  {:>6}  {:>9}{heads}{QUIET:#}\n",
            "mistakes", "unique", "only here"
        );
        let (idle, busy): (Vec<_>, Vec<_>) =
            rows.iter().partition(|row| row.mistakes + row.mutants == 0);
        for catch in busy {
            let DetectionRow {
                name,
                mistakes,
                only_of_its_kind,
                ..
            } = catch;
            let counts = match is_probe {
                true => mutants(format!(
                    "  {:>7}  {:>4}",
                    dash(catch.mutants),
                    dash(catch.mutants_only)
                )),
                false => String::new(),
            };
            text += &format!(
                "  {name:<width$}{:>8}  {:>6}  {:>9}{counts}  {QUIET}{}{QUIET:#}\n",
                dash(*mistakes),
                dash(only_of_its_kind.len()),
                dash(catch.only.len()),
                named(&catch.only),
            );
        }
        if !idle.is_empty() {
            let names: Vec<&str> = idle.iter().map(|row| row.name.as_str()).collect();
            text += &indent(&fill(&format!("none in {}", names.join(", ")), LINE), "  ");
            text += "\n";
        }
    }
    text
}

fn dash(count: usize) -> String {
    match count {
        0 => "–".into(),
        count => count.to_string(),
    }
}

fn named(names: &[String]) -> String {
    let slugs = names
        .iter()
        .map(|name| name.trim_start_matches("mistakes/"));
    let mut shown: Vec<&str> = slugs.take(MOST_NAMED).collect();
    if names.len() > MOST_NAMED {
        shown.push("…");
    }
    shown.join(", ")
}
