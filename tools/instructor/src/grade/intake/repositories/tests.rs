use super::super::placement::place;
use super::super::placement::tests::{entries, person};
use super::super::plain::tests::whose;
use super::super::roster::Person;

/// A roster of Ada, Bob and Eve, with these logins on GitHub, and of Mallory with another.
fn people(logins: [&str; 4]) -> Vec<Person> {
    let all = [
        ("1001", "Ada Lovelace"),
        ("1002", "Bob Babbage"),
        ("1003", "Eve Evans"),
        ("1004", "Mallory Mann"),
    ];
    let person = |((id, name), login): ((&str, &str), &str)| Person {
        github: (!login.is_empty()).then(|| login.to_owned()),
        ..person(id, name)
    };
    all.into_iter().zip(logins).map(person).collect()
}

#[test]
fn a_hyphen_makes_another_login() {
    let clones = ["hw1-ada", "hw1-bobby", "hw1-eve"];
    for mallory in ["a-da", "ad-a"] {
        let people = people(["ada", "bobby", "eve", mallory]);
        assert_eq!(whose(&clones, &people), "123", "{mallory}");
    }
    // The first login is not on the roster.
    let other = people(["", "bobby", "eve", "a-da"]);
    assert_eq!(whose(&clones, &other), "?23");
    let all = people(["ada-love", "bobby", "eve", "adalove"]);
    let clones = ["hw1-ada-love", "hw1-bobby", "hw1-eve", "hw1-adalove"];
    assert_eq!(whose(&clones, &all), "1234");
    let three = people(["ada-love", "bobby", "eve", ""]);
    assert_eq!(whose(&clones, &three), "123?");
}

#[test]
fn nothing_that_others_have_chosen_outweighs_a_login() {
    let name: fn(&mut Person, &str) = |it, what| it.name = what.into();
    let address: fn(&mut Person, &str) = |it, what| it.logins = vec![format!("{what}@x.org")];
    let group: fn(&mut Person, &str) = |it, what| it.group = Some(what.into());
    let login: fn(&mut Person, &str) = |it, what| it.github = Some(what.into());
    for (chosen, what) in [
        (name, "Countess"),
        (name, "Count Ess"),
        (name, "HW1 countess"),
        (address, "countess"),
        (group, "countess"),
        (login, "hw1-countess"),
    ] {
        let mut people = people(["countess", "bobby", "eve", "mal"]);
        chosen(&mut people[3], what);
        let clones = ["hw1-countess", "hw1-bobby", "hw1-eve"];
        assert_eq!(whose(&clones, &people), "123", "{what}");
    }
}

#[test]
fn a_repository_of_somebody_who_is_not_on_the_roster_belongs_to_nobody() {
    let mut people = people(["ada", "bobby", "eve", ""]);
    people[3].logins = vec!["mal@uni.edu".into()];
    for (other, expected) in [
        // An id, a name and an address, as logins
        ("1001", "?"),
        ("1004", "[4]"),
        ("mallory-mann", "[4]"),
        ("mal-uni-edu", "[4]"),
        ("ada-draft", "[1]"),
    ] {
        let other = format!("hw1-{other}");
        let clones = ["hw1-ada", "hw1-bobby", "hw1-eve", &other];
        assert_eq!(whose(&clones, &people), format!("123{expected}"));
    }
    // Such a login in a class that is passed as an archive, or that ends in a number, is listed.
    let mut clones = entries(&["hw1-ada", "hw1-bobby", "hw1-1002"]);
    for entry in &mut clones {
        entry.at_most = super::Proof::Given;
    }
    let placed = place(&clones, Some(&people));
    assert_eq!(placed.of["hw1-bobby"].id, "1002");
    assert_eq!(placed.contested, ["hw1-ada", "hw1-bobby"]);
}

#[test]
fn many_accounts_that_begin_alike_do_not_change_the_title() {
    let people = people(["ada", "bobby", "eve", "mal"]);
    let all = ["ada", "bobby", "zz-ada", "zz-bobby", "zz-eve", "zz-mal"];
    let all = all.map(|login| format!("hw1-{login}"));
    let all = all.each_ref().map(String::as_str);
    assert_eq!(whose(&all, &people), "12????");
}

#[test]
fn folders_may_be_named_after_logins_only() {
    let people = people(["ada", "bobby", "x-ada", "x-bobby"]);
    let all = ["ada", "bobby", "x-ada", "x-bobby"];
    assert_eq!(whose(&all, &people), "1234");
    // Beside repositories, two have handed in by e-mail.
    let all = ["hw1-ada", "hw1-bobby", "hw1-x-ada", "ada", "x-bobby"];
    assert_eq!(whose(&all, &people), "123[1][24]");
}

#[test]
fn teams_differ_by_hyphens_and_outweigh_logins_in_a_class_of_teams() {
    let mut people = people(["", "", "", "first-team"]);
    for (person, team) in people
        .iter_mut()
        .zip(["First Team", "Firstteam", "Röckets"])
    {
        person.group = Some(team.into());
    }
    let teams = ["hw1-first-team", "hw1-firstteam", "hw1-r-ckets"];
    assert_eq!(whose(&teams, &people), "123");
    people[3].name = "Firstteam".into();
    assert_eq!(whose(&["hw1-firstteam", "hw1-rockets"], &people), "23");
}

#[test]
fn folders_that_are_named_after_assigned_logins_are_not_repositories() {
    let mut people = people(["bb1", "x", "eve", "al1"]);
    for (person, login) in people.iter_mut().zip(["al1", "bb1", "ee1", "mm1"]) {
        person.logins = vec![login.into()];
    }
    assert_eq!(whose(&["al1", "bb1", "mm1"], &people), "124");
    // Some have the same login on GitHub, so nobody knows which is meant.
    people[0].github = None;
    people[1].github = Some("bb1".into());
    people[2].github = Some("ee1".into());
    let titled = ["hw1-al1", "hw1-bb1", "hw1-ee1"];
    assert_eq!(whose(&titled, &people), "[14]23");
}
