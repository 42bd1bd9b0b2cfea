use super::*;
use pinhole_course::checkout::Checkout;
use pinhole_testing::root;

fn assignment() -> Assignment {
    let checkout = Checkout::at(&root());
    Assignment::read(&checkout, "ray_casting").expect("it is committed")
}

#[test]
fn people_without_a_university_id_are_in_groups_by_their_number_on_canvas() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("groups.csv");
    let list = "name,canvas_user_id,user_id,login_id,sections,group_name,canvas_group_id,group_id\n\
        Ada,11,S1,ada,A,Team A,7,\nBob,12,,bob,A,Team A,7,\nCleo,13,,cleo,A,,,\n";
    fs::write(&path, list).expect("there is room");
    let groups = groups_in(&path).expect("it is a list of groups");
    let groups: Vec<_> = groups
        .iter()
        .map(|it| (&*it.name, &it.members[..]))
        .collect();
    assert_eq!(
        groups,
        [("Team A", &["S1".to_owned(), "12".to_owned()][..])]
    );
}

#[test]
fn nobody_joins_a_group_because_their_id_is_anothers_number_on_canvas() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("groups.csv");
    let (ada, eve) = ("11,12,\n", "12,,T\n");
    for rows in [[ada, eve], [eve, ada]] {
        let list = format!("canvas_user_id,user_id,group_name\n{}", rows.concat());
        fs::write(&path, list).expect("there is room");
        groups_in(&path).expect_err("nobody knows who is in the group");
    }
}

#[test]
fn a_group_named_like_somebody_elses_id_is_listed() {
    let group = |name: &str, member: &str| Group {
        name: name.into(),
        members: vec![member.into()],
    };
    let policy = Policy {
        groups: vec![
            group("ADA", "eve"),
            group("a-da", "eve"),
            group("eve", "eve"),
            group("T", "ada"),
        ],
        ..Policy::default()
    };
    let people = ["ada", "eve"].map(|id| Person {
        id: id.into(),
        ..Person::default()
    });
    assert_eq!(policy.misnamed_groups(&people), ["ADA", "a-da"]);
}

#[test]
fn a_group_named_like_another_one_does_not_get_its_mark() {
    let folder = tempfile::tempdir().expect("there is room");
    let read = |text: &str| {
        let path = folder.path().join("groups.csv");
        fs::write(&path, text).expect("there is room");
        groups_in(&path).map_err(|error| error.to_string())
    };
    let canvas = "user_id,group_name,canvas_group_id\nada,T,7\nbob,T,7\neve,T,8\nzoe,,\n";
    let members: Vec<_> = read(canvas).expect("it is a list").into_iter().collect();
    let members: Vec<_> = members
        .iter()
        .map(|group| group.members.join(" "))
        .collect();
    assert_eq!(members, ["ada bob", "eve"]);
    let unnumbered = read("user_id,group_name,group_id\nada,T,\nbob,T,\neve,U,\n");
    let unnumbered = unnumbered.expect("it is a list");
    assert_eq!(
        unnumbered.len(),
        2,
        "groups without a number go by their names"
    );
    for twin in ["T ", "\u{a0}T"] {
        let error = read(&format!("id,group\nada,T\neve,{twin}\n"));
        let error = error.expect_err("nobody knows whether they are the same");
        assert!(error.contains("differ only in spaces"), "{error}");
    }
    let plain = read("id, group\nada,T\n bob ,T\neve,t\n").expect("it is a list");
    assert_eq!(plain.len(), 2);
    assert_eq!(plain[0].members, ["ada", "bob"]);
}

#[test]
fn a_group_named_like_another_ones_number_does_not_get_its_mark() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("groups.csv");
    let rows = ["ada,Owls,7\n", "bob,Owls,7\n", "eve,7,\n"];
    for order in [[0, 1, 2], [2, 1, 0]] {
        let rows = order.map(|at| rows[at]).concat();
        fs::write(&path, format!("user_id,group_name,group_id\n{rows}")).expect("there is room");
        let groups = groups_in(&path).expect("it is a list of groups");
        let of_eve = groups.iter().find(|it| it.members.contains(&"eve".into()));
        let of_eve = of_eve.expect("she is in a group");
        assert_eq!((&*of_eve.name, of_eve.members.len()), ("7", 1));
    }
}

#[test]
fn nobody_is_late_because_their_id_is_anothers_login_or_number() {
    use crate::grade::class::marks::tests::entry;
    use crate::grade::intake::Entry;
    use crate::grade::intake::names::{HandInTime, Sign};

    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("times.csv");
    let list = "Identifier,ID number,login,time\n\
        Participant 2001,77,bob,2026-11-20 10:00\n\
        Participant 2002,78,77,2026-11-27 10:00\n\
        Participant 77,79,eve,2026-11-28 10:00\n\
        Participant 2004,,zoe,2026-11-19 10:00\n";
    fs::write(&path, list).expect("there is room");
    let mut policy = Policy {
        times: times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times"),
        ..Policy::default()
    };
    let handed_in = |entry: &Entry, id: &str, number: Option<&str>, login: &str| {
        let person = Person {
            id: id.into(),
            number: number.map(str::to_owned),
            logins: vec![login.into()],
            ..Person::default()
        };
        policy.handed_in(entry, Some(&person), &[])
    };
    let day = |id: &str, number: &str, login: &str| {
        let entry = entry("one", id, "one");
        match handed_in(&entry, id, Some(number), login) {
            Ok(Some(HandInTime::At(time))) => time.strftime("%d").to_string(),
            other => panic!("{id}: {other:?}"),
        }
    };
    assert_eq!(day("77", "2001", "bob"), "20");
    assert_eq!(day("78", "2002", "77"), "27");
    assert_eq!(day("79", "77", "eve"), "28");
    // The list has no id for this person, and the roster has her login in its place.
    assert_eq!(day("zoe", "2004", "zoe"), "19");
    let mut of_group = entry("one", "80", "one");
    of_group.signs = vec![Sign::Account {
        number: "2002".into(),
        name: "Team".into(),
        may_be_group: true,
    }];
    assert_eq!(handed_in(&of_group, "80", None, "ian"), Ok(None));

    fs::write(&path, "login,time\n77,2026-11-27 10:00\n").expect("there is room");
    policy.times = times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times");
    let entry = entry("one", "ada", "one");
    let of = |policy: &Policy, login: &str| {
        let logins = vec![login.into()];
        let id = "77".into();
        policy.handed_in(
            &entry,
            Some(&Person {
                id,
                logins,
                ..Person::default()
            }),
            &[],
        )
    };
    assert!(of(&policy, "bob") == Ok(None) && of(&policy, "77") != Ok(None));

    // Anybody can work out the id of a name, and hand in under that name.
    let mut without_roster = entry.clone();
    (without_roster.id, without_roster.name) = ("77".into(), "Bob Brown".into());
    let list = "submission,time\n77,2026-11-27 10:00\n";
    fs::write(&path, list).expect("there is room");
    policy.times = times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times");
    assert_eq!(policy.handed_in(&without_roster, None, &[]), Ok(None));

    // On Gradescope, anybody can type in this id.
    fs::write(&path, "SID,Email,time\n77,eve@u.edu,2026-11-27 10:00\n").expect("there is room");
    policy.times = times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times");
    for (login, counts) in [("bob@u.edu", false), ("eve@u.edu", true), ("bob", true)] {
        assert_eq!(of(&policy, login).is_ok(), counts, "{login}");
    }
}

#[test]
fn a_submission_named_like_somebody_elses_id_has_its_owners_time() {
    use crate::grade::class::marks::tests::entry;
    use crate::grade::intake::names::HandInTime;

    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("times.csv");
    // Bob has left the course, and Eve has chosen his id for her login on GitHub.
    let list = "id,submission,time\nbob,,2026-11-19 10:00\neve,,2026-11-25 10:00\n\
        ada,,2026-11-20 10:00\nada,first,2026-11-18 10:00\n";
    fs::write(&path, list).expect("there is room");
    let policy = Policy {
        times: times_in(&path, Some(&TimeZone::UTC)).expect("it is a list of times"),
        ..Policy::default()
    };
    let day = |id: &str, name: &str| {
        let person = Person {
            id: id.into(),
            ..Person::default()
        };
        match policy.handed_in(&entry(name, id, name), Some(&person), &[]) {
            Ok(Some(HandInTime::At(time))) => time.strftime("%d").to_string(),
            other => panic!("{id}: {other:?}"),
        }
    };
    assert_eq!(day("eve", "bob"), "25");
    assert_eq!(day("ada", "first"), "18");
    assert_eq!(day("ada", "second"), "20");
}

#[test]
fn a_number_in_a_name_with_several_meanings_gives_no_time() {
    use crate::grade::class::marks::tests::entry;
    use crate::grade::intake::names::platforms;

    let policy = Policy {
        times: vec![super::times::TimeLine {
            keys: vec![(TimeKey::Number, "99".into())],
            at: "2026-11-20T10:00:00Z".parse().ok(),
            said: String::new(),
        }],
        ..Policy::default()
    };
    // Only in the first one, 99 is certainly Eve's number.
    for (name, is_hers) in [
        ("eve_99_501_hw.zip", true),
        ("eve_13_501_x_99_1_hw.zip", false),
    ] {
        let mut entry = entry("one", "eve", name);
        entry.signs = platforms(name).iter().map(|it| it.sign()).collect();
        let time = policy.handed_in(&entry, Some(&Person::default()), &[]);
        assert_eq!(time.is_ok_and(|it| it.is_some()), is_hers, "{name}");
    }
}

#[test]
fn no_time_in_a_name_is_too_late_to_count() {
    use crate::grade::class::marks::tests::entry;
    use crate::grade::intake::names::HandInTime;

    let name = "HW1_ada_attempt_9999-12-31-23-59-59_x.zip";
    let at = Policy::default().handed_in(&entry("ada", "ada", name), None, &[]);
    assert_eq!(at, Ok(Some(HandInTime::At(Timestamp::MAX))));
}

#[test]
fn late_days_are_spent_by_people_whose_id_looks_like_a_formula() {
    let folder = tempfile::tempdir().expect("there is room");
    let ids = ["ada", "-mal@example.org", "=eve;+1"];
    let lines = ids.map(|id| format!("{},2\n", printable_cell(id)));
    let of_nobody = ",0\n";
    let grades = format!("id,late_days\n{of_nobody}{}", lines.concat());
    fs::write(folder.path().join("grades.csv"), grades).expect("there is room");
    let rules = folder.path().join("policy.toml");
    let budget = "[late_days]\nbudget = 3\nspent = ['grades.csv', 'grades.csv']\n";
    let late = "[late]\npercent = 10\nper = 'day'\n";
    fs::write(
        folder.path().join("many.csv"),
        "id,late_days\nada,4294967295\n",
    )
    .expect("there is room");
    fs::write(
        &rules,
        format!("time_zone = 'UTC'\ndeadline = '2026-11-20 23:59'\n{late}{budget}"),
    )
    .expect("there is room");
    let policy = Policy::read(&rules, &assignment()).expect("it is a policy");
    assert_eq!(ids.map(|id| policy.late_days_left(id)), [1, 1, 1]);
    let person = |id: &str| Person {
        id: id.into(),
        ..Person::default()
    };
    let people = ids.map(person);
    assert_eq!(policy.strangers(&people), [""; 0]);
    assert_eq!(policy.strangers(&people[1..]), ["ada"]);
    let text = fs::read_to_string(&rules).expect("it was written");
    let text = text.replace("'grades.csv']", "'many.csv']");
    fs::write(&rules, text).expect("there is room");
    let policy = Policy::read(&rules, &assignment()).expect("it is a policy");
    assert_eq!(policy.late_days_left("ada"), 0);
}

#[test]
fn extra_credit_for_a_part_that_does_not_exist_is_refused() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("policy.toml");
    let read = |parts: &str| {
        let rules = format!("[extra_credit]\nparts = {parts}\n");
        fs::write(&path, rules).expect("there is room");
        Policy::read(&path, &assignment())
    };
    read("['sphere', 'scenes']").expect("both exist");
    let error = read("['scenes', 'spere']").expect_err("it is misspelt");
    let error = error.to_string();
    assert!(error.contains("extra_credit.parts has `spere`"), "{error}");
}
