//! The results of all mutants.

use super::pairs::sentences;
use super::{QUIET, row};
use crate::validate::mutants::{Fate, MutantVerdict, Mutants};

/// Sums, and then each mutant that is not a mistake, with the reason.
pub fn table(mutants: &Mutants) -> String {
    let viable = mutants.count(MutantVerdict::is_viable);
    let missed = mutants.count(MutantVerdict::is_missed);
    let said = format!(
        "{missed} of {viable} viable ones missed ({} do not compile); {} caught by their own\n{:18}\
         task's questions, {} by a scene only, {} rightly listed in equivalent.toml",
        mutants.judged.len() - viable,
        mutants.count(|judged| judged.groups().is_some()),
        "",
        mutants.count(|judged| matches!(judged.fate, Fate::Scene(_))),
        mutants.count(MutantVerdict::is_equivalent),
    );
    let mut text = row(missed == 0 && mutants.faults.is_empty(), "mutants", said);
    text += &sentences(&mutants.sentences());
    for judged in &mutants.judged {
        if let Fate::Scene(scene) = &judged.fate {
            let diff = judged.mutant.diff();
            text += &format!(
                "\n  only {scene} catches {}\n{diff}\n",
                judged.mutant.name()
            );
        }
    }
    let equivalent = mutants
        .judged
        .iter()
        .filter(|judged| judged.is_equivalent());
    let rows = equivalent.map(equivalent_row).collect::<String>();
    if !rows.is_empty() {
        text += &format!("\n{QUIET}  mutants that are not mistakes{QUIET:#}\n{rows}");
    }
    text
}

fn equivalent_row(judged: &MutantVerdict) -> String {
    let Fate::Escaped { difference, .. } = &judged.fate else {
        return String::new();
    };
    let (name, becomes) = (judged.mutant.name(), &judged.mutant.becomes);
    let becomes = becomes.split_whitespace().collect::<Vec<_>>().join(" ");
    let shown = match (difference.same_program, difference.on_ties) {
        (true, _) => "the same machine code".into(),
        (false, 0) => {
            let asked = difference.asked + difference.ties;
            format!("the same answer to all {asked} questions")
        }
        (false, some) => format!(
            "another answer to {some} of {} exact ties, and to none of {} other questions",
            difference.ties, difference.asked
        ),
    };
    format!("  {name:<22}{becomes}\n{:24}{QUIET}{shown}{QUIET:#}\n", "")
}
