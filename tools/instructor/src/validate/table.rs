//! A validation as tables for people.

mod catches;
mod diagnoses;
mod mutants;
mod sensitivity;

use anstyle::{AnsiColor, Style};

use super::Validation;
use super::submissions::SubmissionVerdicts;

const PASS: Style = AnsiColor::Green.on_default();
const FAIL: Style = AnsiColor::Red.on_default();
const QUIET: Style = AnsiColor::BrightBlack.on_default();
const STRONG: Style = Style::new().bold();

/// The table: first what misses a target, then each part that was judged.
pub fn validation(validation: &Validation) -> String {
    let mut text = format!(
        "{STRONG}{}{STRONG:#}  {QUIET}the grading graded{QUIET:#}\n\n",
        validation.assignment
    );
    for fault in &validation.faults {
        text += &format!("{FAIL}✗{FAIL:#} {fault}\n");
    }
    if !validation.faults.is_empty() {
        text += "\n";
    }
    text += &submissions(validation);
    if let Some(diagnoses) = &validation.diagnoses {
        text += &diagnoses::table(diagnoses);
    }
    if let Some(mutants) = &validation.mutants {
        text += &mutants::table(mutants);
    }
    if let Some(catches) = &validation.catches {
        text += &catches::table(catches);
    }
    if let Some(scenes) = &validation.sensitivity {
        text += &sensitivity::table(scenes);
    }
    let verdict = match validation.faults.len() {
        0 => format!("{PASS}every target is met{PASS:#}"),
        1 => format!("{FAIL}1 target is missed{FAIL:#}, see the top"),
        some => format!("{FAIL}{some} targets are missed{FAIL:#}, see the top"),
    };
    let seconds = validation.seconds;
    text + &format!("\n{verdict}  {QUIET}{seconds:.0} s{QUIET:#}\n")
}

fn submissions(validation: &Validation) -> String {
    let pristine = &validation.pristine;
    let (points, possible) = pristine.reference;
    let stub = match pristine.stub {
        0 => "unanswered everywhere".into(),
        points => format!("{points} points"),
    };
    let mut text = row(pristine.stub == 0, "stub", stub);
    let reference = format!("{points} of {possible} points");
    text += &row(points == possible, "reference", reference);
    if let Some(mistakes) = &validation.mistakes {
        let compound = mistakes.judged.iter().filter(|judged| !judged.single);
        let both = format!("; {} of them hold two beliefs", compound.count());
        text += &failing("mistakes", mistakes, &both);
    }
    if let Some(rewrites) = &validation.rewrites {
        text += &failing("  rewritten", rewrites, "");
    }
    if let Some(variants) = &validation.variants {
        let wrong = variants.judged.iter().filter(|judged| judged.is_caught());
        let (wrong, all) = (wrong.count(), variants.judged.len());
        let said = format!("{} of {all} pass, {wrong} false fails", all - wrong);
        text += &row(wrong == 0, "variants", said);
    }
    text
}

/// A row of submissions that must fail.
fn failing(name: &str, known: &SubmissionVerdicts, more: &str) -> String {
    let judged = || known.judged.iter();
    let all = known.judged.len();
    let caught = judged().filter(|judged| judged.is_caught()).count();
    let declared = judged().filter(|judged| judged.is_as_declared()).count();
    let said = format!("{caught} of {all} caught, {declared} in exactly their own tasks{more}");
    row(declared == all, name, said)
}

fn row(well: bool, name: &str, said: String) -> String {
    let (style, mark) = if well { (PASS, "✓") } else { (FAIL, "✗") };
    format!("{style}{mark}{style:#} {name:<16}{said}\n")
}
