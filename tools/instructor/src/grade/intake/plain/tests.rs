use super::super::placement::place;
use super::super::placement::tests::{entries, person};
use super::super::roster::Person;

/// Whose each of these submissions is, by the last digit of the id; if that is not certain, the
/// digits of all who come into question, in brackets.
pub fn whose(names: &[&str], people: &[Person]) -> String {
    let placed = place(&entries(names), Some(people));
    let digits = |all: &[Person]| -> String {
        let mut all: Vec<&str> = all.iter().map(|it| &it.id[it.id.len() - 1..]).collect();
        all.sort();
        all.concat()
    };
    let of = |name: &&str| match (placed.of.get(*name), placed.ambiguous.get(*name)) {
        (Some(person), _) => digits(std::slice::from_ref(person)),
        (None, Some(people)) => format!("[{}]", digits(people)),
        (None, None) => "?".into(),
    };
    names.iter().map(of).collect()
}

/// A roster of Ada, Bob and Eve, with ids and logins on GitHub, and of Mallory, who has chosen
/// something.
fn with_mallory(chosen: fn(&mut Person, &str), what: &str) -> Vec<Person> {
    let all = [
        ("ab-1", "Ada Lovelace"),
        ("cd-2", "Bob Babbage"),
        ("gh-4", "Eve Evans"),
    ];
    let mut people = all.map(|(id, name)| person(id, name)).to_vec();
    for (person, login) in people.iter_mut().zip(["ada", "bob", "hacker"]) {
        person.github = Some(login.into());
    }
    people.push(person("ef-3", "Mallory Mallet"));
    chosen(&mut people[3], what);
    people
}

#[test]
fn nobody_gets_a_submission_because_they_have_chosen_a_part_of_its_name() {
    let github: fn(&mut Person, &str) = |it, what| it.github = Some(what.into());
    let address: fn(&mut Person, &str) = |it, what| it.logins = vec![format!("{what}@x.org")];
    let name: fn(&mut Person, &str) = |it, what| it.name = what.into();
    let group: fn(&mut Person, &str) = |it, what| it.group = Some(what.into());
    for (chosen, what, names, expected) in [
        (github, "ab-1", &["hw1-ab-1", "hw1-cd-2"][..], "[13]2"),
        (github, "1", &["hw1-ab-1", "hw1-cd-2"], "12"),
        (github, "late", &["ab-1-late", "cd-2"], "[13]2"),
        (github, "late", &["hw1-ada-late", "hw1-bob"], "[13]2"),
        (github, "late", &["Ada Lovelace-late", "cd-2"], "[13]2"),
        (github, "main", &["hw1-ada-main"], "[13]"),
        (address, "late", &["Eve Evans-late", "cd-2"], "[34]2"),
        (
            address,
            "hw1",
            &["hw1-nobody", "hw1-bob", "hw1-hacker"],
            "?24",
        ),
        (
            github,
            "hw1",
            &["hw1-nobody", "hw1-bob", "hw1-hacker"],
            "?24",
        ),
        (name, "HW1 ab 1", &["HW1 ab-1", "cd-2"], "[13]2"),
        (name, "HW1 ab 1", &["hw1_ab-1", "cd-2"], "[13]2"),
        (group, "HW1 ab-1", &["HW1 ab-1", "cd-2"], "[13]2"),
        (
            name,
            "Ada Lovelace late",
            &["Ada Lovelace (late)", "cd-2"],
            "[13]2",
        ),
        (
            name,
            "Ada Lovelace (late)",
            &["Ada Lovelace (late)", "cd-2"],
            "[13]2",
        ),
        (name, "ada (late)", &["ada (late)", "cd-2"], "[13]2"),
        (
            name,
            "Ada Lovelace Mann",
            &["Mann, Ada Lovelace", "cd-2"],
            "[13]2",
        ),
    ] {
        let people = with_mallory(chosen, what);
        assert_eq!(whose(names, &people), expected, "{what} {names:?}");
    }
}

#[test]
fn nobody_puts_a_class_in_doubt_because_they_have_chosen_a_part_of_the_title() {
    let github: fn(&mut Person, &str) = |it, what| it.github = Some(what.into());
    let address: fn(&mut Person, &str) = |it, what| it.logins = vec![format!("{what}@x.org")];
    let name: fn(&mut Person, &str) = |it, what| it.name = what.into();
    for (chosen, what, names, expected) in [
        (github, "hw", &["hw-1-ada", "hw-1-bob"][..], "12"),
        (address, "hw", &["hw-1-ada", "hw-1-bob"], "12"),
        (address, "hw", &["hw 1 ab-1", "hw 1 cd-2"], "12"),
        (
            address,
            "hw",
            &["hw_1_Ada Lovelace", "hw_1_Bob Babbage"],
            "12",
        ),
        (
            name,
            "HW 1",
            &["hw-1-ada", "hw-1-bob", "hw-1-hacker"],
            "124",
        ),
        // This is somebody else's, whose login is `mal`.
        (
            github,
            "1-mal",
            &["hw-1-ada", "hw-1-bob", "hw-1-mal"],
            "12?",
        ),
    ] {
        let people = with_mallory(chosen, what);
        assert_eq!(whose(names, &people), expected, "{what} {names:?}");
    }
    // A display name may be the title and somebody else's login.
    let people = with_mallory(|it, what| it.name = what.into(), "HW1 Ada");
    assert_eq!(whose(&["HW1 ada", "HW1 bob"], &people), "[13]2");
    // A number in the title may be somebody's id.
    let mut people = with_mallory(address, "mal");
    people[0].id = "1".into();
    assert_eq!(whose(&["hw_1_mal"], &people), "[13]");
    assert_eq!(whose(&["1_hw_mal"], &people), "[13]");
    // After the title of most submissions, a login counts as a whole.
    let people = with_mallory(github, "1-ada");
    let three = ["hw-ada", "hw-bob", "hw-hacker", "hw-1-ada"];
    assert_eq!(whose(&three, &people), "1243");
    assert_eq!(whose(&three[2..], &people), "43");
    // A login that was assigned may also stand before a title.
    let mut people = with_mallory(address, "mal");
    for (person, login) in people.iter_mut().zip(["al", "bb", "ee"]) {
        person.logins = vec![login.into()];
    }
    let names = ["al-hw-1", "bb-hw-1", "ee-hw-1", "mal-ab"];
    assert_eq!(whose(&names, &people), "124[3]");
    let mut people = with_mallory(address, "1_mal");
    people[0].logins = vec!["ada@uni.edu".into()];
    people[1].logins = vec!["bob@uni.edu".into()];
    let names = ["ada", "bob", "mal"].map(|it| format!("HW_1_{it}_attempt_2026-11-20-23-00-00"));
    let names = names.each_ref().map(String::as_str);
    assert_eq!(whose(&names, &people), "123");
}

#[test]
fn an_id_and_a_name_that_agree_outweigh_other_logins_and_numbers() {
    let mut people = vec![
        person("1001", "Ana Turing"),
        person("1002", "Ana Alan Park"),
        person("3", "Eve Evans"),
    ];
    people[0].logins = vec!["ana".into()];
    people[1].logins = vec!["alan".into()];
    for (name, expected) in [
        ("Ana Alan Park (1002)", "2"),
        ("hw1_1002_Ana_Alan_Park", "2"),
        // Her login is a part of her name, so it proves nothing.
        ("Ana Turing 3", "[13]"),
        ("Eve Evans 1001", "[13]"),
        ("3 Eve Evans", "3"),
    ] {
        assert_eq!(whose(&[name], &people), expected, "{name}");
    }
}

#[test]
fn a_login_outweighs_somebodys_name() {
    let github = |it: &mut Person, what: &str| it.github = Some(what.into());
    let mut people = with_mallory(github, "plato");
    people[0].name = "Plato".into();
    assert_eq!(whose(&["hw1-plato", "hw1-bob"], &people), "32");
    // An id may begin with what most names begin with.
    let mut people = with_mallory(github, "1-late");
    for (person, id) in people.iter_mut().zip(["26-1", "26-2", "26-4"]) {
        person.id = id.into();
    }
    assert_eq!(whose(&["26-1-late", "26-2", "26-4"], &people), "[13]24");
}

#[test]
fn nobody_puts_a_class_in_doubt_because_they_have_chosen_its_ending() {
    let github = |it: &mut Person, what: &str| it.github = Some(what.into());
    for (what, names) in [
        ("main", ["hw1-ada-main", "hw1-bob-main", "hw1-hacker-main"]),
        (
            "late",
            [
                "Ada Lovelace (late)",
                "Bob Babbage (late)",
                "Eve Evans (late)",
            ],
        ),
        ("hw1", ["ab-1-hw1", "cd-2-hw1", "gh-4-hw1"]),
    ] {
        let people = with_mallory(github, what);
        assert_eq!(whose(&names, &people), "124", "{what}");
    }
}

#[test]
fn a_login_with_a_hyphen_is_certain_only_if_every_login_is_known() {
    let mut people = with_mallory(|it, what| it.github = Some(what.into()), "zoe");
    for (login, is_known, is_certain) in [
        ("zoe-lee", true, true),
        ("zoe-main", true, false),
        ("zoe-2", true, false),
        ("zoe-lee", false, false),
        ("zoe", false, true),
    ] {
        people.truncate(4);
        people[3].github = Some(login.into());
        if !is_known {
            people.push(person("ij-5", "Zoe Zuse"));
        }
        let own = format!("hw1-{login}");
        let names = ["hw1-ada", "hw1-bob", "hw1-hacker", &own];
        let placed = place(&entries(&names), Some(&people));
        assert_eq!(placed.of[&own].id, "ef-3");
        assert_eq!(placed.contested.is_empty(), is_certain, "{placed:?}");
    }
}

#[test]
fn everyone_near_a_name_is_compared_with_it() {
    let mut people = vec![
        person("1001", "Sean O'Neil"),
        person("1002", "Sean Connery"),
        person("1003", "Zoe Muller"),
        person("1004", "Eve Evans"),
    ];
    people[0].group = Some("team-a".into());
    people[1].group = Some("team-b".into());
    for (name, expected) in [
        ("hw1_Sean_Oneil_late", "[1]"),
        ("hw1_Sean_O'Neil_late", "[1]"),
        ("Zo\u{eb} M\u{fc}ller", "3"),
        ("muller, zoe", "3"),
    ] {
        assert_eq!(whose(&[name], &people), expected, "{name}");
    }
    assert_eq!(whose(&["hw1-team-a", "hw1-team-b"], &people), "12");
}

#[test]
fn a_name_with_accents_may_stand_before_a_title() {
    let people = [
        person("11", "Ada Lovelace"),
        person("12", "Bob Babbage"),
        person("13", "Zoë King"),
    ];
    let remarks = ["11 (1)", "12 (1)", "Zoë King (1)"];
    assert_eq!(whose(&remarks, &people), "123");
    assert_eq!(whose(&remarks[2..], &people), "3");
}

#[test]
fn a_login_on_github_is_certain_only_after_a_title_of_such_logins() {
    let people = |github: [&str; 3]| -> Vec<Person> {
        let all = [
            ("11", "Ada Lovelace"),
            ("12", "Bob Babbage"),
            ("13", "Eve Evans"),
        ];
        let person = |((id, name), github): ((&str, &str), &str)| Person {
            github: (!github.is_empty()).then(|| github.to_owned()),
            ..person(id, name)
        };
        all.into_iter().zip(github).map(person).collect()
    };
    let by_id = place(
        &entries(&["hw1_11", "hw1_12", "hw1_0099"]),
        Some(&people(["", "", "0099"])),
    );
    assert!(by_id.by_name.contains(&"hw1_0099".into()), "{by_id:?}");
    // The second one may also be Ada's, with the name of a branch.
    for (eve, is_listed) in [("eve", false), ("ada-main", true), ("late-ada", false)] {
        let own = format!("hw1-{eve}");
        let names = ["hw1-ada", "hw1-bob", &own];
        let placed = place(&entries(&names), Some(&people(["ada", "bob", eve])));
        assert_eq!(placed.of[&own].id, "13", "{placed:?}");
        assert_eq!(placed.contested == [own], is_listed);
    }
}

#[test]
fn a_repository_of_a_team_is_not_taken_for_one_of_somebody_with_such_a_login() {
    for (group, login) in [("R\u{f6}ckets", "r-ckets"), ("7", "7")] {
        let mut people = with_mallory(|it, what| it.github = Some(what.into()), login);
        people[0].group = Some(group.into());
        people[1].group = Some("First Team".into());
        people[3].group = Some("Second Team".into());
        let own = format!("hw1-{login}");
        let teams = ["hw1-first-team", "hw1-second-team", &own];
        assert_eq!(whose(&teams, &people), "231", "{group}");
        let alone = ["hw1-bob", "hw1-hacker", &own];
        assert_eq!(whose(&alone, &people), "243", "{group}");
    }
    // Browsers add numbers to the names of files.
    let people = with_mallory(|it, what| it.group = Some(what.into()), "7");
    assert_eq!(whose(&["ab-1 (7)", "7"], &people), "13");
}
