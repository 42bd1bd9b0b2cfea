use super::super::names::Sign;
use super::super::placement::place;
use super::super::placement::tests::{entries, person};
use super::*;

/// Whose each of these submissions is, by the last digit of the id; if that is not certain, the
/// digits of all who come into question, in brackets.
pub fn whose(names: &[&str], people: &[Person]) -> String {
    whose_named("{id}", names, people)
}

fn pattern(text: &str) -> NamePattern {
    text.parse().expect("it is a pattern")
}

fn whose_named(named: &str, names: &[&str], people: &[Person]) -> String {
    let placed = place(&entries(names), Some(people), &pattern(named));
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
    for (person, login) in people.iter_mut().zip(["ada", "bob", "eve"]) {
        person.github = Some(login.into());
    }
    people.push(person("ef-3", "Mallory Mallet"));
    chosen(&mut people[3], what);
    people
}

const CHOICES: [fn(&mut Person, &str); 4] = [
    |it, what| it.github = Some(what.into()),
    |it, what| it.logins = vec![format!("{what}@x.org")],
    |it, what| it.name = what.into(),
    |it, what| it.group = Some(what.into()),
];

#[test]
fn only_a_whole_name_says_whose_it_is() {
    let people = with_mallory(|it, what| it.name = what.into(), "Zoë Müller");
    for (name, expected) in [
        ("ab-1", "1"),
        ("AB-1", "1"),
        // These are suggestions.
        ("ada", "[1]"),
        ("Ada Lovelace", "[1]"),
        ("Lovelace, Ada", "[1]"),
        ("zoe muller", "[3]"),
        ("Zo\u{eb} M\u{fc}ller", "[3]"),
        ("hw1-ab-1", "[1]"),
        ("ab-1 (late)", "[1]"),
        ("Ada Lovelace (late)", "[1]"),
        ("hw1-ada", "[1]"),
        ("ada-late", "[1]"),
        ("ab_1", "[1]"),
        ("ab-1 cd-2", "[12]"),
        ("a-da", "[1]"),
        ("hw1", "?"),
    ] {
        assert_eq!(whose(&[name], &people), expected, "{name}");
        let many = [name, "hw1-bob", "hw1-eve", "cd-2 (late)"];
        let of_many = whose(&many, &people);
        assert_eq!(of_many, format!("{expected}[2][4][2]"), "{name}");
    }
}

#[test]
fn nobodys_choice_takes_an_id() {
    for chosen in CHOICES {
        for (what, name, is_contested) in [
            ("ab-1", "ab-1", true),
            ("AB-1", "ab-1", true),
            ("ab1", "ab-1", true),
            ("ab", "ab-1", false),
            ("1", "ab-1", false),
        ] {
            let people = with_mallory(chosen, what);
            let placed = place(
                &entries(&[name, "cd-2"]),
                Some(&people),
                &NamePattern::default(),
            );
            assert_eq!(placed.of[name].id, "ab-1", "{what}");
            assert_eq!(placed.of["cd-2"].id, "cd-2", "{what}");
            let listed = if is_contested { &[name][..] } else { &[] };
            assert_eq!(placed.contested, listed, "{what}");
        }
    }
}

#[test]
fn whatever_others_choose_a_repository_belongs_to_the_person_with_its_login() {
    let names = ["hw1-ada", "hw1-bob", "hw1-eve"];
    for chosen in CHOICES {
        for what in [
            "ada", "a-da", "hw1", "hw1-ada", "hw1-hw1", "ada-main", "main", "1",
        ] {
            let mut people = with_mallory(chosen, what);
            if people[3].github.as_deref() == Some("ada") {
                // No two accounts have the same login.
                people[3].github = None;
            }
            let whose = |names: &[&str]| whose_named("hw1-{github}", names, &people);
            assert_eq!(whose(&names), "124", "{what}");
            // Nobody gets the repository of somebody who is not on the roster.
            for stranger in ["hw1-zed", "hw1-zz-ada", "hw1-ab-1", "hw1-Ada Lovelace"] {
                let found = whose(&[stranger]);
                let is_nobodys = found == "?" || found.starts_with('[');
                assert!(is_nobodys, "{what} {stranger}: {found}");
            }
        }
    }
}

#[test]
fn a_pattern_says_which_part_of_a_name_is_whose() {
    let mut people = with_mallory(|it, what| it.github = Some(what.into()), "ada-main");
    people[1].group = Some("First Team".into());
    for (named, names, expected) in [
        ("hw1-{github}", &["hw1-ada", "hw1-ada-main"][..], "13"),
        ("hw1-{github}-main", &["hw1-ada-main"], "1"),
        ("{id}_hw1", &["ab-1_hw1", "ada_hw1", "cd-2"], "1[1]2"),
        ("hw 1 {name}", &["hw 1 Ada Lovelace", "Bob Babbage"], "1[2]"),
        ("{name}", &["Ada Lovelace", "Babbage, Bob"], "12"),
        (
            "{name}",
            &["Ada Lovelace", "Babbage, Bob", "ada"],
            "[1]2[1]",
        ),
        ("hw1-{group}", &["hw1-first-team", "hw1-ada"], "2[1]"),
        // The instructor may have made a folder for somebody.
        ("hw1-{github}", &["hw1-bob", "ab-1"], "21"),
        // But students may have chosen these.
        ("{github}", &["ada", "gh-4"], "1[4]"),
        ("{github}", &["ada", "Ada Lovelace", "ab-1"], "1[1][1]"),
        ("hw1-{github}", &["hw1-ab-1", "hw1-Ada Lovelace"], "[1][1]"),
    ] {
        let found = whose_named(named, names, &people);
        assert_eq!(found, expected, "{named} {names:?}");
    }
}

#[test]
fn a_login_that_may_be_anothers_and_something_behind_it_is_listed() {
    for (login, is_listed) in [
        ("ada-1", true),
        ("late-ada", true),
        ("Ada-x", true),
        ("late-ada-1", true),
        ("teamwork", true),
        ("adam", false),
        ("ada1-ad", false),
    ] {
        let mut people = with_mallory(|it, what| it.github = Some(what.into()), login);
        // A group's repository may have the group's name.
        people[1].group = Some("Teamwork".into());
        let name = format!("hw1-{login}");
        let placed = place(&entries(&[&name]), Some(&people), &pattern("hw1-{github}"));
        assert_eq!(placed.of[&name].id, "ef-3");
        assert_eq!(placed.by_name.len(), usize::from(is_listed), "{login}");
        // A browser has saved two files of this name.
        let both = [&*name, &format!("{name} (1)")];
        let placed = place(&entries(&both), Some(&people), &pattern("hw1-{github}"));
        assert_eq!(placed.of.is_empty(), is_listed, "{login}: {placed:?}");
    }
}

#[test]
fn an_id_that_may_be_anothers_and_a_branch_is_listed() {
    let mut people = with_mallory(|it, what| it.name = what.into(), "Mallory");
    people[3].id = "ab".into();
    for (named, name, is_listed) in [
        ("hw1-{id}", "hw1-ab-1", true),
        ("hw1-{id}-main", "hw1-ab-1-main", true),
        ("{id}-main", "ab-1-main", true),
        ("{id}-main", "ab-1", true),
        ("hw1-{id}", "hw1-cd-2", false),
        // The instructor has named these after ids, and Blackboard knows no branches.
        ("{id}", "ab-1", false),
        ("HW1_{id}", "HW1_ab-1_attempt_2026-11-19-10-00-00", false),
    ] {
        let mut all = entries(&[name, "HW1_gh-4_attempt_2026-11-19-10-00-00"]);
        for entry in &mut all {
            if let Some((login, _)) = entry.name.split_once("_attempt") {
                entry.signs = vec![Sign::Login(login.into())];
            }
        }
        let placed = place(&all, Some(&people), &pattern(named));
        assert!(placed.of.contains_key(name), "{name}");
        assert_eq!(placed.by_name.contains(&name.into()), is_listed, "{name}");
    }
}

#[test]
fn a_folder_named_after_any_id_on_the_roster_has_an_owner() {
    let mut people = with_mallory(|it, what| it.github = Some(what.into()), "mal-3");
    people[3].id = "mal-3".into();
    let placed = place(
        &entries(&["mal-3", "ab-1"]),
        Some(&people),
        &NamePattern::default(),
    );
    assert_eq!(placed.of["mal-3"].id, "mal-3");
    assert_eq!(placed.by_name, ["mal-3"], "people choose their logins");
    // Somebody's assigned login outweighs it.
    people[0].logins = vec!["mal-3".into()];
    assert_eq!(whose(&["mal-3"], &people), "1");
    // An id outweighs an address that somebody has typed in.
    people[0].id = "ada-1@x.org".into();
    people[3].logins = vec!["ada-1@x.org".into()];
    assert_eq!(whose(&["ada-1@x.org"], &people), "g");
}

#[test]
fn an_id_that_may_be_a_login_and_a_branch_is_listed() {
    let people = with_mallory(|it, what| it.github = Some(what.into()), "ab");
    let placed = |named: &str| place(&entries(&["ab-1"]), Some(&people), &pattern(named));
    assert_eq!(placed("{github}-main").contested, ["ab-1"]);
    assert_eq!(placed("{id}-main").contested, ["ab-1"]);
    assert_eq!(placed("{id}").contested, [""; 0]);
}

#[test]
fn a_persons_name_counts_if_the_instructor_says_so_but_is_listed() {
    let mut people = with_mallory(|it, what| it.name = what.into(), "Zo\u{eb} M\u{fc}ller");
    let names = ["Bob Babbage", "zoe muller"];
    let placed = place(&entries(&names), Some(&people), &pattern("{name}"));
    assert_eq!(placed.of["Bob Babbage"].id, "cd-2");
    assert_eq!(placed.of["zoe muller"].id, "ef-3");
    assert_eq!(placed.by_name, names);
    people[3].name = "ab-1".into();
    let found = whose_named("{name}", &["ab-1"], &people);
    assert_eq!(found, "[13]", "it is an id, too");
    people[3].name = "Bob Babbage".into();
    people[3].group = Some("7".into());
    let found = whose_named("{name}", &["Bob Babbage", "7"], &people);
    assert_eq!(found, "[23][3]", "a group's number is not a name");
}

#[test]
fn a_group_is_listed_and_one_that_is_written_like_another_is_nobodys() {
    let mut people = with_mallory(|it, what| it.group = Some(what.into()), "R\u{f6}ckets");
    let placed = place(
        &entries(&["hw1-r-ckets"]),
        Some(&people),
        &pattern("hw1-{group}"),
    );
    assert_eq!(placed.of["hw1-r-ckets"].id, "ef-3");
    assert_eq!(placed.contested, ["hw1-r-ckets"]);
    people[0].group = Some("R ckets".into());
    let found = whose_named("hw1-{group}", &["hw1-r-ckets"], &people);
    assert_eq!(found, "[13]");
}
