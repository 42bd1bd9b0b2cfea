//! Shows a validation as tables.

mod catches;
mod diagnoses;
mod mutants;
mod pairs;
mod sensitivity;

use anstyle::{AnsiColor, Style};

use super::Validation;
use super::draws::Draws;
use super::submissions::{SubmissionVerdict, SubmissionVerdicts};

const PASS: Style = AnsiColor::Green.on_default();
const FAIL: Style = AnsiColor::Red.on_default();
const QUIET: Style = AnsiColor::BrightBlack.on_default();
const STRONG: Style = Style::new().bold();

/// The table: first what misses a target, then each part that was judged.
pub fn validation(validation: &Validation) -> String {
    let mut text = format!(
        "{STRONG}{}{STRONG:#}  {QUIET}test of the grading{QUIET:#}\n\n",
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
    if let Some(pairs) = &validation.pairs {
        text += &pairs::table(pairs);
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
    if let Some(draws) = &validation.draws {
        text += &drawn(draws);
    }
    let verdict = match validation.faults.len() {
        0 => format!("{PASS}every target is met{PASS:#}"),
        1 => format!("{FAIL}1 target is missed{FAIL:#}, see the top"),
        some => format!("{FAIL}{some} targets are missed{FAIL:#}, see the top"),
    };
    let seconds = validation.seconds;
    text + &format!("\n{verdict}  {QUIET}{seconds:.0} s{QUIET:#}\n")
}

/// The groups that pass the public questions but not all fresh ones, the rarest first.
fn drawn(draws: &Draws) -> String {
    let (answers, groups, asked) = (draws.answers, draws.groups, draws.asked);
    let mut text = format!(
        "\n{STRONG}fresh questions of many seeds{STRONG:#}  {QUIET}{answers} wrong answers; \
         {groups} of their groups pass the public questions, and were then asked fresh ones \
         {asked} times{QUIET:#}\n"
    );
    for group in &draws.caught {
        text += &row(!group.depends_on_the_draw(), "", group.to_string());
    }
    text
}

fn submissions(validation: &Validation) -> String {
    let pristine = &validation.pristine;
    let (points, possible) = pristine.reference;
    let stub = match pristine.stub {
        0 => "every task is unanswered, as it should be".into(),
        points => format!("{points} points"),
    };
    let mut text = row(pristine.stub == 0, "stub", stub);
    let reference = format!("{points} of {possible} points");
    text += &row(points == possible, "reference", reference);
    if let Some(mistakes) = &validation.mistakes {
        let compound = mistakes.judged.iter().filter(|judged| !judged.single);
        let both = format!("; combined mistakes: {}", compound.count());
        text += &failing("mistakes", mistakes, &both);
        text += &capped(mistakes);
    }
    if let Some(rewrites) = &validation.rewrites {
        text += &failing("  in other code", rewrites, "");
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
    let said = format!(
        "{caught} of {all} caught; {declared} fail in their own tasks and in no others{more}"
    );
    row(declared == all, name, said)
}

/// How many points scenes lose because of their tasks, if no fresh scene earns them back.
fn capped(mistakes: &SubmissionVerdicts) -> String {
    let lost = |judged: &SubmissionVerdict| {
        let (earned, most) = (judged.scene_points, judged.most_for_scenes);
        (earned.saturating_sub(most), judged.name.clone())
    };
    let mut lost: Vec<(u32, String)> = mistakes.judged.iter().map(lost).collect();
    lost.sort_by(|a, b| b.cmp(a));
    let some = lost.iter().filter(|(points, _)| *points > 0).count();
    let worst = lost.first().filter(|(points, _)| *points > 0);
    let worst = worst.map_or(String::new(), |(points, name)| {
        format!(", at most {points} ({name})")
    });
    let all = lost.len();
    let said = format!("takes points from {some} of {all}{worst}");
    row(true, "  cap on scenes", said)
}

fn row(well: bool, name: &str, said: String) -> String {
    let (style, mark) = if well { (PASS, "✓") } else { (FAIL, "✗") };
    format!("{style}{mark}{style:#} {name:<16}{said}\n")
}
