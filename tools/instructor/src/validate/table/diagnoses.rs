//! How often diagnoses give the right name, as a table.

use crate::validate::naming::{Diagnoses, SubmissionDiagnosisCounts};

use super::{QUIET, STRONG};

/// A row for each kind of wrong submission and film.
pub fn table(diagnoses: &Diagnoses) -> String {
    let mut text = format!(
        "\n{STRONG}diagnosis{STRONG:#}  {QUIET}of films that are not stored{QUIET:#}\n{QUIET}  {:<46}{:>6}{:>7}\
         {:>7}{:>6}{:>7}{QUIET:#}\n",
        "", "films", "right", "among", "none", "false"
    );
    let kinds = [
        ("one belief, rewritten", &diagnoses.rewrites),
        ("two beliefs at once", &diagnoses.compounds),
        ("one belief, as if never met before", &diagnoses.unmet),
    ];
    for (kind, naming) in kinds {
        text += &rows(kind, naming);
    }
    text + "  right: only the right belief is named; among: it is named with one or two others that\n  \
            look the same in that film; none: nothing is named; false: only others are named\n"
}

fn rows(kind: &str, naming: &SubmissionDiagnosisCounts) -> String {
    let films = [
        ("tasks", &naming.tasks),
        ("scenes, after the tasks", &naming.scenes),
        ("single pictures", &naming.pictures),
    ];
    let mut text = format!("  {kind}\n");
    for (what, names) in films {
        text += &format!(
            "    {what:<44}{:>6}{:>7}{:>7}{:>6}{:>7}\n",
            names.all(),
            names.right,
            names.among,
            names.none,
            names.wrong.len()
        );
    }
    text
}
