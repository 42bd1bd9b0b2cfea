mod times;

use super::*;
use crate::grade::intake::matching::Proof;
use crate::grade::intake::names::{self, Sign};
use crate::grade::policy::TimeKey;
use crate::grade::policy::rules::Rules;
use crate::grade::policy::times::TimeLine;
use crate::grade::record::tests::graded;

fn person(id: &str) -> Person {
    Person {
        id: id.into(),
        name: format!("Name of {id}"),
        ..Person::default()
    }
}

pub fn entry(id: &str, person: &str, given: &str) -> Entry {
    Entry {
        id: id.into(),
        name: id.into(),
        given: vec![given.into()],
        platform: names::exported_by([names::platforms(given)].into_iter()),
        signs: vec![Sign::Plain(person.into())],
        at_most: Proof::Id,
        notes: Vec::new(),
        doubts: Vec::new(),
        unusable: Vec::new(),
        answers: None,
        submission: Err("not asked".into()),
    }
}

pub fn roll(entries: Vec<Entry>, rules: &str, groups: &[(&str, &[&str])]) -> Roll {
    let rules: Rules = toml::from_str(rules).expect("they are rules");
    let mut policy = Policy::of(rules).expect("they make sense");
    policy.groups = groups
        .iter()
        .map(|(name, members)| crate::grade::policy::Group {
            name: (*name).into(),
            members: members.iter().map(|id| (*id).to_owned()).collect(),
        })
        .collect();
    let people = Some(["ada", "bob", "eve"].map(person).to_vec());
    let mut roll = Roll {
        entries,
        people,
        policy: Some(policy),
        ..Roll::default()
    };
    roll.place();
    roll
}

/// Person, submission and final mark of every row that has one.
fn finals(rows: &Rows) -> Vec<(String, String, f64)> {
    let all = rows.own.iter().chain(&rows.shared);
    let all = all.filter_map(|row| {
        let person = row.person.map_or("-".into(), |it| it.id.clone());
        Some((person, row.entry.id.clone(), row.mark.as_ref()?.last))
    });
    all.collect()
}

fn records(points: &[(&str, u32)]) -> BTreeMap<String, RecordSummary> {
    let record = |(id, points): &(&str, u32)| ((*id).to_owned(), graded(id, *points, 100).into());
    points.iter().map(record).collect()
}

const RULES: &str = "time_zone = 'UTC'\ndeadline = '2026-11-20 12:00'\n\
    [late]\npercent = 10\nper = 'day'\n";
const EARLY: &str = "x_attempt_2026-11-20-11-00-00_a.zip";
const LATE: &str = "x_attempt_2026-11-20-13-00-00_a.zip";

#[test]
fn the_last_or_the_best_attempt_counts_and_each_person_has_one_mark() {
    let entries = || vec![entry("one", "ada", EARLY), entry("two", "ada", LATE)];
    let records = records(&[("one", 60), ("two", 65)]);
    let last = roll(entries(), RULES, &[]);
    let rows_of_last = rows(&last, &records);
    assert_eq!(finals(&rows_of_last), [("ada".into(), "two".into(), 55.0)]);
    let not_counted = rows_of_last.own[0].not_counted.as_deref();
    assert_eq!(
        not_counted,
        Some("not counted: the submission that counts is two")
    );
    let best = roll(entries(), &format!("attempts = 'best'\n{RULES}"), &[]);
    assert_eq!(
        finals(&rows(&best, &records)),
        [("ada".into(), "one".into(), 60.0)]
    );
    // Neither of these says which is the last.
    let entries = vec![entry("one", "ada", EARLY), entry("two", "ada", "ada")];
    let untold = roll(entries, RULES, &[]);
    let rows = rows(&untold, &records);
    assert_eq!(finals(&rows), []);
    assert!(rows.concerns[0].is_grave && rows.concerns[0].which == ["one and two"]);
}

#[test]
fn an_attempt_that_is_no_better_spends_no_late_days() {
    // The second is eve's, who hands in for ada too.
    let entries = vec![entry("one", "ada", EARLY), entry("two", "eve", LATE)];
    let rules = format!("attempts = 'best'\n{RULES}[late_days]\nbudget = 1\n");
    let roll = roll(entries, &rules, &[("team", &["ada", "eve"])]);
    let late_days = |points: [u32; 2]| {
        let records = records(&[("one", points[0]), ("two", points[1])]);
        let rows = rows(&roll, &records);
        let marks = rows.own.iter().chain(&rows.shared);
        let marks = marks.filter_map(|row| row.mark.as_ref());
        marks.map(|mark| mark.late_days).collect::<Vec<_>>()
    };
    assert_eq!(late_days([60, 60]), [0, 0]);
    assert_eq!(late_days([60, 61]), [1, 1]);
}

#[test]
fn who_has_a_members_name_does_not_hand_in_for_a_group() {
    let mut entries = vec![entry("one", "ada", EARLY), entry("two", "eve", LATE)];
    let records = records(&[("one", 100), ("two", 0)]);
    let team: &[(&str, &[&str])] = &[("team", &["ada", "eve"])];
    let finals_of = |entries: Vec<Entry>| {
        let roll = roll(entries, RULES, team);
        let rows = rows(&roll, &records);
        let listed = rows
            .concerns
            .iter()
            .find(|it| it.what.contains("placed by a name"));
        assert!(listed.is_none_or(|it| it.is_grave));
        (finals(&rows), listed.map(|it| it.which.clone()))
    };
    let own = |id: &str, submission: &str, points| (id.to_owned(), submission.to_owned(), points);
    let (marks, listed) = finals_of(entries.clone());
    assert_eq!(listed, None);
    assert_eq!(marks.len(), 2);
    entries[1].at_most = Proof::Name;
    let (marks, listed) = finals_of(entries.clone());
    assert_eq!(marks, [own("ada", "one", 100.0), own("eve", "one", 100.0)]);
    assert_eq!(listed, Some(vec!["two".into()]));
    // Somebody else may have chosen this id, which is listed elsewhere.
    entries[1].at_most = Proof::Given;
    let (marks, listed) = finals_of(entries.clone());
    assert_eq!((marks.len(), listed), (2, None));
    entries[1].at_most = Proof::Name;
    entries[0].at_most = Proof::Name;
    let (marks, listed) = finals_of(entries.clone());
    assert_eq!(marks, []);
    assert_eq!(listed, Some(vec!["one".into(), "two".into()]));
    // Who has chosen Eve's name has made her own submission ambiguous.
    let bobs = |at_most, signs: &[Sign]| {
        let mut entries = entries.clone();
        entries[1].at_most = at_most;
        entries[1].signs = signs.to_vec();
        finals_of(entries)
    };
    let [eve, both] = ["eve", "eve or bob"].map(|it| Sign::Plain(it.into()));
    let (marks, listed) = bobs(Proof::Name, &[eve.clone(), both]);
    assert_eq!(marks, [own("-", "two", 0.0)]);
    assert_eq!(listed, Some(vec!["one".into()]));
    // But what may be a copy does her no harm.
    let (marks, listed) = bobs(Proof::Hint, &[eve]);
    assert_eq!((marks.len(), listed), (3, None));
}

#[test]
fn a_member_of_a_group_is_as_late_as_the_table_of_times_says() {
    let entries = vec![entry("one", "ada", "ada"), entry("two", "eve", "eve")];
    let mut roll = roll(entries, RULES, &[("team", &["ada", "eve"])]);
    let policy = roll.policy.as_mut().expect("it has one");
    for (id, day) in [("ada", 20), ("eve", 25)] {
        let time = format!("2026-11-{day}T11:00:00Z").parse();
        policy.times.push(TimeLine {
            keys: vec![(TimeKey::Id, id.into())],
            at: Some(time.expect("it is a time")),
            said: String::new(),
        });
    }
    let records = records(&[("one", 60), ("two", 95)]);
    let expected = ["eve", "ada"].map(|id| (id.to_owned(), "two".to_owned(), 45.0));
    assert_eq!(finals(&rows(&roll, &records)), expected);
}

#[test]
fn a_time_under_a_login_that_two_people_have_is_listed_and_counts_for_neither() {
    let entries = ["ada", "bob", "eve"].map(|id| entry(id, id, id)).to_vec();
    let mut roll = roll(entries, RULES, &[]);
    let people = roll.people.as_mut().expect("it has people");
    let accounts = [("al123", "countess"), ("bb9", "bob"), ("em7", "al123")];
    for (person, (login, github)) in people.iter_mut().zip(accounts) {
        person.logins = vec![login.into()];
        person.github = Some(github.into());
    }
    roll.place();
    let marks = |roll: &Roll, times: [(&str, u32); 3]| {
        let mut roll = roll.clone();
        let policy = roll.policy.as_mut().expect("it has one");
        for (login, day) in times {
            let time = format!("2026-11-{day}T11:00:00Z").parse();
            policy.times.push(TimeLine {
                keys: vec![(TimeKey::Login, login.into())],
                at: Some(time.expect("it is a time")),
                said: String::new(),
            });
        }
        let records = records(&[("ada", 60), ("bob", 60), ("eve", 60)]);
        let rows = rows(&roll, &records);
        let points: Vec<f64> = finals(&rows).into_iter().map(|it| it.2).collect();
        let listed = rows.concerns.iter().filter(|it| it.is_grave);
        let listed: Vec<String> = listed.flat_map(|it| it.which.clone()).collect();
        (points, listed)
    };
    // The table has logins on GitHub, and eve is late.
    let (points, listed) = marks(&roll, [("countess", 20), ("bob", 20), ("al123", 25)]);
    assert_eq!(points, [60.0; 3]);
    assert_eq!(listed, ["eve: al123"]);
    // A stranger on GitHub has the login that bob has at the university, and bob is late.
    let (points, listed) = marks(&roll, [("countess", 20), ("bb9", 20), ("Bob", 25)]);
    assert_eq!(points, [60.0; 3]);
    assert_eq!(listed, ["bob: bob", "eve"]);
    // The table has the university's logins, and ada is late.
    let (points, listed) = marks(&roll, [("al123", 25), ("bb9", 25), ("em7", 20)]);
    assert_eq!(points, [60.0, 10.0, 60.0]);
    assert_eq!(listed, ["ada: al123"]);
    // The roster has no logins of the university, and eve calls herself by ada's id.
    for person in roll.people.iter_mut().flatten() {
        person.logins.clear();
        person.github = (person.id == "eve").then(|| "ada".into());
    }
    roll.place();
    let (points, listed) = marks(&roll, [("ada", 20), ("bob", 20), ("eve", 25)]);
    assert_eq!(points, [60.0; 3]);
    assert_eq!(listed, ["eve: ada", "ada", "bob"]);
}

#[test]
fn each_person_has_one_mark_even_without_a_policy() {
    let records = records(&[("one", 60), ("two", 65)]);
    let of = |given: [&str; 2]| {
        let entries = vec![entry("one", "ada", given[0]), entry("two", "ada", given[1])];
        let mut roll = roll(entries, RULES, &[]);
        roll.policy = None;
        let rows = rows(&roll, &records);
        (finals(&rows), rows.concerns)
    };
    let (marks, concerns) = of(["ada", "ada again"]);
    assert_eq!(marks, []);
    assert!(concerns[0].is_grave && concerns[0].which == ["one and two"]);
    // Nothing is taken off without a policy, but the names say which is the last.
    let (marks, concerns) = of([EARLY, LATE]);
    assert_eq!(marks, [("ada".into(), "two".into(), 65.0)]);
    assert_eq!(concerns[0].which, ["one and two (counts: two)"]);
}

#[test]
fn the_same_answers_handed_in_twice_count_once() {
    let entries = vec![entry("one", "ada", "ada"), entry("two", "eve", "eve")];
    let roll = roll(entries, RULES, &[("team", &["ada", "eve"])]);
    let mut records = records(&[("one", 60), ("two", 60)]);
    let mut marks = |tokens: [&str; 2]| {
        for (record, tokens) in records.values_mut().zip(tokens) {
            record.tokens = Box::new([("any".to_owned(), tokens.to_owned())]);
        }
        finals(&rows(&roll, &records)).len()
    };
    assert_eq!(marks(["same", "same"]), 2);
    assert_eq!(marks(["same", "other"]), 0);
}

#[test]
fn a_group_is_graded_once_and_marked_for_all() {
    let by_hand = format!("{RULES}[[adjust]]\nid = 'eve'\npoints = 5\nreason = 'talk'\n");
    let groups: [(&str, &[&str]); 1] = [("team", &["ada", "eve"])];
    let entries = vec![entry("one", "ada", EARLY), entry("two", "bob", LATE)];
    let roll = roll(entries, &by_hand, &groups);
    assert_eq!(roll.placed.missing, [], "eve's group has handed in");
    let records = records(&[("one", 60), ("two", 65)]);
    let expected = [
        ("ada", "one", 60.0),
        ("bob", "two", 55.0),
        ("eve", "one", 65.0),
    ];
    let expected = expected.map(|(id, entry, points)| (id.to_owned(), entry.to_owned(), points));
    assert_eq!(finals(&rows(&roll, &records)), expected);
    assert!(
        roll.headline(&|_| true, "graded")
            .contains("3 are graded; 0 handed in nothing")
    );
}

#[test]
fn people_whose_group_has_handed_in_are_not_in_doubt() {
    let in_doubt = |own: &str, groups: &[(&str, &[&str])]| {
        let both = entry("two", own, own);
        let roll = roll(vec![entry("one", "ada", "ada"), both], RULES, groups);
        assert!(roll.placed.missing.is_empty(), "{:?}", roll.placed.missing);
        let people = roll.in_doubt().into_iter().map(|person| person.id.clone());
        people.collect::<Vec<_>>()
    };
    assert_eq!(in_doubt("bob eve", &[]), ["bob", "eve"]);
    assert_eq!(in_doubt("bob eve", &[("team", &["ada", "bob"])]), ["eve"]);
    // The rest of a group is in doubt, too.
    assert_eq!(
        in_doubt("hw-bob", &[("team", &["bob", "eve"])]),
        ["bob", "eve"]
    );
}

#[test]
fn unknown_lateness_and_unknown_ids_are_listed() {
    let rules = format!("{RULES}[[adjust]]\nid = 'adda'\npoints = 5\nreason = 'talk'\n");
    let entries = vec![
        entry("one", "ada", "ada_LATE_1_2_a.zip"),
        entry("two", "bob", "bob"),
        entry("three", "eve", EARLY),
    ];
    let mut roll = roll(entries, &rules, &[]);
    let nothing_graded = BTreeMap::new();
    let concerns = rows(&roll, &nothing_graded).concerns;
    let of = |word: &str| {
        let mut concerns = concerns.iter();
        let concern = concerns.find(|it| it.what.contains(word)).expect(word);
        assert!(concern.is_grave, "{word}");
        concern.which.clone()
    };
    assert_eq!(of("not on the roster"), ["adda"]);
    assert_eq!(of("by how much: no points"), ["one"]);
    assert_eq!(of("counted as on time"), ["two"]);
    assert_eq!(concerns.len(), 3);
    let policy = roll.policy.as_mut().expect("it has one");
    policy.times.push(TimeLine {
        keys: vec![(TimeKey::Id, "eve".into())],
        at: None,
        said: String::new(),
    });
    let concerns = rows(&roll, &nothing_graded).concerns;
    let mut concerns = concerns.iter();
    let on_time = concerns.find(|it| it.what.contains("counted as on time"));
    assert!(on_time.is_some_and(|it| it.is_grave && it.which == ["two"]));
}

#[test]
fn nobody_is_late_because_somebody_else_has_typed_in_their_id() {
    let line = |keys: &[(TimeKey, &str)], day: u32| TimeLine {
        keys: keys
            .iter()
            .map(|(kind, key)| (*kind, (*key).into()))
            .collect(),
        at: format!("2026-11-{day}T11:00:00Z").parse().ok(),
        said: String::new(),
    };
    let [id, login, submission] = [TimeKey::Id, TimeKey::Login, TimeKey::Submission];
    let entries = ["ada", "eve"].map(|id| entry(id, id, id)).to_vec();
    let records = records(&[("ada", 60), ("eve", 60)]);
    let ada = [(id, "ada"), (login, "ada@u.edu")];
    let named = [(id, "s1"), (submission, "ada")];
    let honest = [(id, "eve"), (login, "eve@u.edu")];
    // Ada is in time, if she is in the table. Eve is late, and has typed in something of Ada's.
    for (has_roster, ada, eve, listed) in [
        (true, &ada[..], &honest, None),
        (
            true,
            &ada,
            &[(id, "ada"), (login, "eve@u.edu")],
            Some("ada: ada"),
        ),
        (
            true,
            &ada[1..],
            &[(id, "ada"), (login, "eve@u.edu")],
            Some("ada: ada"),
        ),
        (
            true,
            &[],
            &[(id, "ada"), (login, "eve@u.edu")],
            Some("ada: ada"),
        ),
        (
            true,
            &[],
            &[(id, "eve"), (login, "ada@u.edu")],
            Some("ada: ada@u.edu"),
        ),
        (
            true,
            &ada,
            &[(id, "eve"), (submission, "ada")],
            Some("ada: ada"),
        ),
        (false, &ada, &honest, None),
        (
            false,
            &named,
            &[(id, "s2"), (submission, "ada")],
            Some("ada: ada"),
        ),
        (
            false,
            &ada,
            &[(id, "ada"), (login, "eve@u.edu")],
            Some("ada: ada"),
        ),
        (
            false,
            &ada,
            &[(id, "eve"), (submission, "ada")],
            Some("ada: ada"),
        ),
    ] {
        let mut roll = roll(entries.clone(), RULES, &[]);
        for person in roll.people.iter_mut().flatten() {
            person.logins = vec![format!("{}@u.edu", person.id)];
        }
        roll.people = roll.people.filter(|_| has_roster);
        roll.place();
        let policy = roll.policy.as_mut().expect("it has one");
        policy.times = vec![line(ada, 20), line(eve, 25)];
        let rows = rows(&roll, &records);
        let marks = rows.own.iter().filter_map(|row| row.mark.as_ref());
        assert_eq!(marks.map(|it| it.last).next(), Some(60.0), "{eve:?}");
        let grave = rows.concerns.iter().filter(|it| it.is_grave);
        let grave: Vec<&str> = grave.flat_map(|it| &it.which).map(|it| &**it).collect();
        assert_eq!(grave.first().copied(), listed, "{has_roster} {eve:?}");
    }
}

#[test]
fn two_groups_of_one_name_get_their_own_marks() {
    let entries = vec![entry("one", "ada", "ada"), entry("two", "eve", "eve")];
    let teams: &[(&str, &[&str])] = &[("T", &["ada", "bob"]), ("T", &["eve"])];
    let roll = roll(entries, "attempts = 'best'", teams);
    let records = records(&[("one", 80), ("two", 0)]);
    let marks = finals(&rows(&roll, &records)).into_iter();
    let mut marks: Vec<_> = marks.map(|(person, _, points)| (person, points)).collect();
    marks.sort_by(|a, b| a.0.cmp(&b.0));
    let expected = [("ada", 80.0), ("bob", 80.0), ("eve", 0.0)];
    assert_eq!(
        marks,
        expected.map(|(person, points)| (person.to_owned(), points))
    );
}
