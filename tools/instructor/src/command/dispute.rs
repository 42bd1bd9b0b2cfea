//! `pinhole dispute`: everything about one mark, for the lecturer who must explain it.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::json;

use crate::cli::Dispute;
use crate::grade::cache::standing;
use crate::grade::class::marks::{self, Rows};
use crate::grade::class::{ROLL, Roll, Row};
use crate::grade::evidence::Evidence;
use crate::grade::grader::fresh;
use crate::grade::intake::roster::Person;
use crate::grade::intake::{Entry, matching};
use crate::grade::policy::mark::{Mark, number};
use crate::grade::record::{Record, RecordSummary};
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::outcome::{GroupOutcome, Outcome, TaskOutcome};
use pinhole_report::escape::{printable, printable_json};
use pinhole_report::program::Status;
use pinhole_report::terminal::{self, FAIL, QUIET, STRONG};

pub fn run(arguments: &Dispute) -> Result<Status> {
    let roll = Roll::read(&arguments.out.join(ROLL))?;
    let id = id_of(&arguments.id, &roll)?;
    let submissions = arguments.out.join("submissions");
    let entry = roll.entries.iter().find(|entry| entry.id == id);
    let record = entry.and_then(|entry| standing(&submissions.join(&id), entry));
    let record = record.ok_or_else(|| {
        Error::input(
            format!("there is no mark for {id} in {}", arguments.out.display()),
            "grade it first: cargo pinhole grade … --out DIR",
        )
    })?;
    let mut evidence = Evidence::read(&arguments.out, &id)?;
    let made_with = &record.provenance.made_with;
    let fresh = evidence.fresh_folder.as_ref().zip(made_with.fresh.as_ref());
    evidence.fresh_folder = fresh.and_then(|(folder, hash)| fresh::still_kept(folder, hash));
    let attempts = attempts(&id, &roll, &submissions);
    let row = row(&arguments.id, &id, marks::rows(&roll, &attempts), &roll);
    let (mark, not_counted) = row.map_or((None, None), |row| (row.mark, row.not_counted));
    let whose = roll.whose(&id);
    if arguments.json {
        let document = json!({
            "whose": whose, "record": record, "mark": mark, "not_counted": not_counted, "evidence": evidence
        });
        let text = serde_json::to_string_pretty(&document)
            .or_environment("cannot write the result as JSON", "report this")?;
        anstream::println!("{}", printable_json(&text));
    } else {
        let whose = whose.map(|whose| format!("{}\n", printable(&whose)));
        let mark = mark_in_words(mark.as_ref(), not_counted.as_deref());
        let mark = whose.unwrap_or_default() + &mark;
        anstream::print!("{}", words(&record, &mark, &evidence));
    }
    Ok(Status::Well)
}

/// The row of the submission with this id, or that of a member of the group that the user named.
fn row<'a>(named: &str, id: &str, rows: Rows<'a>, roll: &Roll) -> Option<Row<'a>> {
    let is_members =
        |row: &Row| named != id && row.person.is_some_and(|it| is_named(named, it, roll));
    let of_members = rows.shared.into_iter().filter(is_members);
    of_members.chain(rows.own).find(|row| row.entry.id == id)
}

/// Whether the user named this person, by the id or the name. Somebody may have chosen another
/// person's id for a name.
fn is_named(named: &str, person: &Person, roll: &Roll) -> bool {
    let is_id = roll.people.iter().flatten().any(|it| it.id == named);
    match is_id {
        true => person.id == named,
        false => matching::is_name(named, person),
    }
}

/// The records of everything that the same people have handed in, by id. They decide which
/// submission counts.
fn attempts(id: &str, roll: &Roll, submissions: &Path) -> BTreeMap<String, RecordSummary> {
    let person = roll.placed.of.get(id);
    let team: Vec<&Person> = person.into_iter().flat_map(|it| roll.team_of(it)).collect();
    let is_theirs = |other: &str| {
        let owner = roll.placed.of.get(other);
        other == id || owner.is_some_and(|owner| team.iter().any(|it| it.id == owner.id))
    };
    let own = roll.entries.iter().filter(|entry| is_theirs(&entry.id));
    let record = |entry: &Entry| {
        let record = standing(&submissions.join(&entry.id), entry)?;
        Some((entry.id.clone(), record.into()))
    };
    own.filter_map(record).collect()
}

/// The final mark, and each change that the policy made to the points.
fn mark_in_words(mark: Option<&Mark>, not_counted: Option<&str>) -> String {
    let mut text = String::new();
    if let Some(mark) = mark {
        let (last, possible) = (number(mark.last), number(mark.possible));
        text += &format!("final mark: {last} of {possible}\n");
        for change in &mark.changes {
            text += &format!("  {}\n", printable(&change.in_words()));
        }
    }
    if let Some(why) = not_counted {
        text += &format!("{}\n", printable(why));
    }
    text
}

/// Finds the submission that the user named by its id, or by the id or the name of someone whose
/// mark it decides, or may decide.
fn id_of(named: &str, roll: &Roll) -> Result<String> {
    let is_named = |person: &Person| is_named(named, person, roll);
    let is_theirs = |id: &str| {
        let person = roll.placed.of.get(id);
        let mut team = person.into_iter().flat_map(|person| roll.team_of(person));
        team.any(is_named)
    };
    let is_meant = |id: &str| {
        let mut perhaps = roll.placed.ambiguous.get(id).into_iter().flatten();
        is_theirs(id) || perhaps.any(is_named)
    };
    let ids = roll.entries.iter().map(|entry| entry.id.clone());
    let theirs: Vec<String> = ids.clone().filter(|id| is_theirs(id)).collect();
    // Somebody may have named an archive after another person's id.
    let is_free = theirs.is_empty() || theirs.iter().any(|id| id == named);
    if let Some(id) = ids.clone().find(|id| id == named && is_free) {
        return Ok(id);
    }
    let found: Vec<String> = match theirs.is_empty() {
        true => ids.filter(|id| is_meant(id)).collect(),
        false => theirs,
    };
    match &found[..] {
        [id] => Ok(id.clone()),
        [] => Err(Error::input(
            format!("there is no submission by {named}"),
            "pass the id or name of someone in grades.csv who has a submission",
        )),
        several => Err(Error::input(
            format!("{named} could be any of {}", several.join(", ")),
            "pass one of these ids",
        )),
    }
}

fn words(record: &Record, mark: &str, evidence: &Evidence) -> String {
    let id = printable(&record.id);
    let points = record.got.points.map_or("no mark".into(), |points| {
        format!("{points} of {} points", record.got.possible)
    });
    let made_with = &record.provenance.made_with;
    let mut text = format!("{STRONG}{id}{STRONG:#}  {points}\n{mark}");
    text += &format!("judged on {}\n", made_with.judged_on);
    if let Some(seed) = made_with.seed {
        let folder = evidence.fresh_folder.as_ref();
        let place = folder.map_or("no longer kept".into(), |folder| {
            folder.display().to_string()
        });
        text += &format!("fresh questions: {place}, drawn from seed {seed}\n");
    }
    for task in &record.got.tasks {
        let failing = failing(&task.name, evidence);
        if failing.is_empty() {
            continue;
        }
        let (earned, possible) = (task.points, task.possible);
        text += &format!("\n{FAIL}✗{FAIL:#} {} {earned} / {possible}\n", task.name);
        let problem = task.file.problem();
        for line in problem.iter().flat_map(|problem| problem.lines()) {
            text += &format!("  {}\n", printable(line));
        }
        for (which, group) in failing.iter().filter(|_| problem.is_none()) {
            let said = terminal::outcome_of(&group.outcome, "answers");
            text += &format!("  {} ({which}): {said}\n", group.name);
            for line in terminal::facts(&group.worst).lines() {
                text += &format!("      {line}\n");
            }
        }
        if let Some(answer) = evidence.answers.get(&task.name) {
            text += &format!("  {QUIET}{}.rs as it was handed in{QUIET:#}\n", task.name);
            for (number, line) in (1..).zip(answer.lines()) {
                text += &format!("  {QUIET}{number:>4}{QUIET:#} {}\n", printable(line));
            }
        }
    }
    let scenes = evidence.public.scenes.iter();
    for scene in scenes.filter(|scene| !scene.outcome.passes()) {
        let said = terminal::outcome(&scene.outcome);
        text += &format!("\n{FAIL}✗{FAIL:#} {}: {said}\n", scene.name);
    }
    if let Some(most) = record.most_for_scenes {
        let (earned, possible) = record.scene_points();
        text += &format!(
            "\nscenes {earned} / {possible} (the tasks that they need allow at most {most})\n"
        );
    }
    text
}

/// The groups of a task that fail, and the questions on which they fail.
fn failing<'a>(task: &str, evidence: &'a Evidence) -> Vec<(&'static str, &'a GroupOutcome)> {
    let of = |outcome: &'a Outcome, which| {
        let tasks = outcome
            .tasks
            .iter()
            .filter(|own: &&TaskOutcome| own.name == task);
        let groups = tasks.flat_map(|task| &task.groups);
        let failing = groups.filter(|group| !group.outcome.passes());
        failing.map(move |group| (which, group)).collect::<Vec<_>>()
    };
    let mut all = of(&evidence.public, "public questions");
    for (which, group) in evidence
        .fresh
        .iter()
        .flat_map(|it| of(it, "fresh questions"))
    {
        if all.iter().all(|(_, public)| public.name != group.name) {
            all.push((which, group));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::class::marks::tests::{entry, roll};

    const RULES: &str = "time_zone = 'UTC'";

    #[test]
    fn a_mark_is_found_by_everyone_in_the_group() {
        let entries = vec![entry("one", "ada", "ada"), entry("two", "eve", "eve")];
        let roll = roll(entries, RULES, &[("team", &["ada", "bob"])]);
        for named in [
            "one",
            "ada",
            "Name of ada",
            "bob",
            "Name of bob",
            "bob, Name of",
        ] {
            assert_eq!(id_of(named, &roll).expect("it is there"), "one");
        }
        // Each of a group's submissions is found by its own id.
        let entries = vec![entry("one", "ada", "ada"), entry("bob", "bob", "bob")];
        let both =
            crate::grade::class::marks::tests::roll(entries, RULES, &[("team", &["ada", "bob"])]);
        assert_eq!(id_of("bob", &both).expect("it is there"), "bob");
        assert!(id_of("ada", &both).is_err());
        // An archive with a person's id for a name is not the person's submission.
        let entries = vec![entry("bob", "eve", "eve"), entry("one", "bob", "bob")];
        let archive = crate::grade::class::marks::tests::roll(entries, RULES, &[]);
        assert_eq!(id_of("bob", &archive).expect("it is there"), "one");
        assert_eq!(id_of("eve", &archive).expect("it is there"), "bob");
        let mut named = archive;
        named
            .placed
            .of
            .values_mut()
            .for_each(|it| it.name = "bob".into());
        assert_eq!(id_of("bob", &named).expect("it is there"), "one");
        let error = id_of("Name of nobody", &roll).expect_err("nobody has this name");
        assert!(error.to_string().contains("no submission by"), "{error}");
    }

    #[test]
    fn a_member_of_a_group_sees_the_members_own_mark() {
        let rules = "[[adjust]]\nid = 'ada'\npoints = -5\nreason = 'late by e-mail'";
        let roll = roll(
            vec![entry("one", "ada", "ada")],
            rules,
            &[("team", &["ada", "bob"])],
        );
        let record = crate::grade::record::tests::graded("one", 80, 100);
        let records = BTreeMap::from([("one".to_owned(), record.into())]);
        let last = |named: &str| {
            let row = row(named, "one", marks::rows(&roll, &records), &roll);
            row.and_then(|row| row.mark).map(|mark| mark.last)
        };
        let named = ["one", "ada", "bob", "Name of bob"];
        assert_eq!(named.map(last), [75., 75., 80., 80.].map(Some));
    }

    #[test]
    fn the_final_mark_is_shown_with_the_reason_of_each_change() {
        let rules = "[[adjust]]\nid = 'ada'\npoints = -5\nreason = 'late by e-mail'";
        let roll = roll(vec![entry("one", "ada", "ada")], rules, &[]);
        let record = crate::grade::record::tests::graded("one", 80, 100);
        let records = BTreeMap::from([("one".to_owned(), record.into())]);
        let rows = marks::rows(&roll, &records);
        let mark = rows.own[0].mark.as_ref();
        let said = mark_in_words(mark, Some("not counted: the submission that counts is two"));
        assert_eq!(
            said,
            "final mark: 75 of 100\n  −5: late by e-mail\nnot counted: the submission that counts is two\n"
        );
    }

    #[test]
    fn a_submission_in_doubt_is_found_by_everyone_it_may_belong_to() {
        let mut roll = roll(vec![entry("one", "ada", "ada")], RULES, &[]);
        let ada = roll.placed.of.remove("one").expect("it is hers");
        let bob = roll.placed.missing[0].clone();
        roll.placed.ambiguous.insert("one".into(), vec![ada, bob]);
        for named in ["ada", "Name of bob"] {
            assert_eq!(id_of(named, &roll).expect("it is there"), "one");
        }
        let whose = roll.whose("one").expect("there is a roster");
        assert_eq!(
            whose,
            "belongs to nobody, perhaps to Name of ada [ada] or Name of bob [bob]"
        );
    }
}
