//! How often diagnoses give the right name, as a table.

use crate::validate::naming::{Diagnoses, SubmissionDiagnosisCounts};

use super::{QUIET, STRONG};

/// A row for each kind of wrong submission and film.
pub fn table(diagnoses: &Diagnoses) -> String {
    let mut text = format!(
        "\n{STRONG}diagnosis{STRONG:#}  {QUIET}how often a wrong film gets the name of its mistake{QUIET:#}\n  \
         right: that mistake alone is named; among: it is named with one or two others that\n  look \
         the same in that film; none: nothing is named; false: another mistake is named\n\n\
         {QUIET}  {:<46}{:>6}{:>7}{:>7}{:>6}{:>7}{QUIET:#}\n",
        "", "films", "right", "among", "none", "false"
    );
    let kinds = [
        ("known mistakes in other code", &diagnoses.rewrites),
        ("several known mistakes at once", &diagnoses.compounds),
        (
            "mistakes treated as unknown, so that every name is false",
            &diagnoses.unmet,
        ),
    ];
    for (kind, naming) in kinds {
        text += &rows(kind, naming);
    }
    text
}

fn rows(kind: &str, naming: &SubmissionDiagnosisCounts) -> String {
    let films = [
        ("tasks", &naming.tasks),
        ("scenes, once their tasks are diagnosed", &naming.scenes),
        ("scenes alone, as `diff` sees them", &naming.pictures),
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
