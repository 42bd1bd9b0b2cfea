//! What each group of questions and each scene catches.

use super::QUIET;
use crate::validate::catches::{DetectionRow, DetectionTable};

/// How many mistakes a row names.
const MOST_NAMED: usize = 3;

/// A row for each group and each scene.
pub fn table(catches: &DetectionTable) -> String {
    let mut text = format!(
        "\nHow many mistakes fail in each group and scene, how many of them fail in no other\n\
         group (or in no other scene), and how many, and which, fail nowhere else at all.\n\
         Mistakes of two beliefs are left out. Others: {}.",
        catches.mistakes
    );
    if let Some(mutants) = catches.mutants {
        text += &format!(
            " Of {mutants} mutants that their own\n\
             task's questions catch, how many fail in this group, and how many only there."
        );
    }
    text += "\n";
    let names = catches.probes.iter().chain(&catches.scenes);
    let width = names.map(|catch| catch.name.len()).max().unwrap_or(0) + 2;
    let mutants = |columns: String| catches.mutants.map(|_| columns).unwrap_or_default();
    for (kind, rows) in [("probes", &catches.probes), ("scenes", &catches.scenes)] {
        let is_probe = kind == "probes";
        // Mutants are judged only by their own task's questions.
        if !is_probe && catches.mistakes == 0 {
            continue;
        }
        let heads = match is_probe {
            true => mutants(format!("  {:>7}  {:>4}", "mutants", "only")),
            false => String::new(),
        };
        text += &format!(
            "\n{QUIET}  {kind:<width$}{:>8}  {:>4}  {:>6}{heads}{QUIET:#}\n",
            "mistakes", "only", "at all"
        );
        for catch in rows {
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
                "  {name:<width$}{:>8}  {:>4}  {:>6}{counts}  {QUIET}{}{QUIET:#}\n",
                dash(*mistakes),
                dash(only_of_its_kind.len()),
                dash(catch.only.len()),
                named(&catch.only),
            );
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
