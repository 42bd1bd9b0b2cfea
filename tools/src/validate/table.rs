//! A validation as tables for people.

use anstyle::{AnsiColor, Style};

use super::Validation;
use super::catches::{Catch, Catches};
use super::submissions::Known;

const PASS: Style = AnsiColor::Green.on_default();
const FAIL: Style = AnsiColor::Red.on_default();
const QUIET: Style = AnsiColor::BrightBlack.on_default();
const STRONG: Style = Style::new().bold();

/// Faults first, then each part that was judged.
pub fn validation(validation: &Validation) -> String {
    let mut text = format!(
        "{STRONG}{}{STRONG:#}  {QUIET}the grading graded{QUIET:#}\n\n",
        validation.assignment
    );
    for fault in &validation.faults {
        text += &format!("{FAIL}✗ {fault}{FAIL:#}\n");
    }
    if !validation.faults.is_empty() {
        text += "\n";
    }
    text += &submissions(validation);
    if let Some(catches) = &validation.catches {
        text += &self::catches(catches);
    }
    let verdict = match validation.faults.len() {
        0 => format!("{PASS}every target is met{PASS:#}"),
        1 => format!("{FAIL}1 target is missed{FAIL:#}, see the top"),
        some => format!("{FAIL}{some} targets are missed{FAIL:#}, see the top"),
    };
    text += &format!("\n{verdict}  {QUIET}{:.0} s{QUIET:#}\n", validation.seconds);
    text
}

fn submissions(validation: &Validation) -> String {
    let pristine = &validation.pristine;
    let (points, possible) = pristine.reference;
    let mut text = row(
        pristine.stub == 0,
        "stub",
        format!("{} points, unanswered everywhere", pristine.stub),
    );
    text += &row(
        points == possible,
        "reference",
        format!("{points} of {possible} points"),
    );
    let failing = |known: &Known| {
        let caught = known
            .judged
            .iter()
            .filter(|judged| judged.is_caught())
            .count();
        let declared = known.judged.iter().filter(|judged| judged.is_as_declared());
        let all = known.judged.len();
        (
            declared.clone().count() == all,
            format!(
                "{caught} of {all} caught, {} in exactly their own tasks",
                declared.count()
            ),
        )
    };
    if let Some(mistakes) = &validation.mistakes {
        let (well, mut said) = failing(mistakes);
        let compound = mistakes
            .judged
            .iter()
            .filter(|judged| !judged.single)
            .count();
        said += &format!("; {compound} of them hold two beliefs");
        text += &row(well, "mistakes", said);
    }
    if let Some(rewrites) = &validation.rewrites {
        let (well, said) = failing(rewrites);
        text += &row(well, "  written anew", said);
    }
    if let Some(variants) = &validation.variants {
        let failing = variants
            .judged
            .iter()
            .filter(|judged| judged.is_caught())
            .count();
        let all = variants.judged.len();
        text += &row(
            failing == 0,
            "variants",
            format!("{} of {all} pass, {failing} false fails", all - failing),
        );
    }
    text
}

fn row(well: bool, name: &str, said: String) -> String {
    let (style, mark) = if well { (PASS, "✓") } else { (FAIL, "✗") };
    format!("{style}{mark}{style:#} {name:<16}{said}\n")
}

fn catches(catches: &Catches) -> String {
    let names = catches.probes.iter().chain(&catches.scenes);
    let width = names.map(|catch| catch.name.len()).max().unwrap_or(0) + 2;
    let mut text = format!(
        "\nOf {} single mistakes: how many fail here; how many of them fail nowhere else among\n\
         the probes (or the scenes); how many nowhere else at all.\n",
        catches.mistakes
    );
    for (kind, rows) in [("probes", &catches.probes), ("scenes", &catches.scenes)] {
        text += &format!("\n{QUIET}  {kind:<width$}fail  only here  only here of all{QUIET:#}\n");
        for catch in rows {
            text += &catch_row(catch, width);
        }
    }
    text
}

fn catch_row(catch: &Catch, width: usize) -> String {
    let dash = |count: usize| match count {
        0 => "–".into(),
        count => count.to_string(),
    };
    let mut names: Vec<&str> = catch
        .only
        .iter()
        .map(|name| name.trim_start_matches("mistakes/"))
        .collect();
    names.truncate(3);
    format!(
        "  {:<width$}{:>4}  {:>9}  {:>16}  {QUIET}{}{QUIET:#}\n",
        catch.name,
        dash(catch.catches),
        dash(catch.only_of_its_kind.len()),
        dash(catch.only.len()),
        names.join(", "),
    )
}
