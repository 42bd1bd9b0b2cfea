use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

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

/// Adds two people to a roster, and returns their logins.
fn others(people: &mut Vec<Person>) -> [&'static str; 3] {
    let all = ["hal", "ida", "joe"];
    for (id, login) in ["1006", "1007", "1008"].into_iter().zip(all) {
        people.push(Person {
            github: Some(login.into()),
            ..person(id, &format!("{login} Somebody"))
        });
    }
    all
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
    assert_eq!(whose(&clones[..1], &other), "?");
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
fn a_folder_may_hold_the_repositories_of_two_sections() {
    let people = people(["ada", "bobby", "eve", "mal"]);
    let all = [
        "cs-a-hw1-ada",
        "cs-a-hw1-bobby",
        "cs-b-hw1-eve",
        "cs-b-hw1-mal",
    ];
    assert_eq!(whose(&all, &people), "1234");
    // The instructor has added a folder.
    let all = ["hw1-lab-ada", "hw1-lab-bobby", "hw1-1003"];
    let placed = place(&entries(&all), Some(&people));
    assert_eq!(placed.of.len(), 3);
    assert_eq!(placed.by_name, all[2..]);
}

#[test]
fn folders_may_be_named_after_logins_only() {
    let people = people(["ada", "bobby", "x-ada", "x-bobby"]);
    let all = ["ada", "bobby", "x-ada", "x-bobby"];
    assert_eq!(whose(&all, &people), "1234");
    // Beside repositories, the instructor has added folders.
    let all = ["hw1-ada", "hw1-bobby", "hw1-x-ada", "ada", "x-bobby"];
    assert_eq!(whose(&all, &people), "12314");
}

#[test]
fn nobody_has_a_login_that_is_the_end_of_the_title_and_anothers_login() {
    for (title, logins) in [
        ("hw1", ["hw1-ada", "hw1-bobby"]),
        ("homework-1", ["1-ada", "1-bobby"]),
    ] {
        let mut people = people(["ada", "bobby", "eve", logins[0]]);
        people.push(Person {
            github: Some(logins[1].into()),
            ..person("1005", "Mia Mann")
        });
        let logins = ["ada", "bobby", "eve"]
            .into_iter()
            .chain(others(&mut people));
        let mut all: Vec<String> = logins.map(|login| format!("{title}-{login}")).collect();
        let found = |all: &[String]| {
            let all: Vec<&str> = all.iter().map(String::as_str).collect();
            whose(&all, &people)
        };
        assert_eq!(found(&all), "123678");
        // In a small class, it is uncertain.
        assert_eq!(found(&all[..2]), "[14][25]");
        // The instructor has added a folder.
        all.push("eve".into());
        let found = found(&all);
        assert!(found.starts_with("123678"), "{found}");
    }
}

#[test]
fn nobody_has_a_login_that_is_anothers_login_and_a_branch() {
    let people = people(["ada", "bobby", "eve", "ada-submission"]);
    let branches = ["ada", "bobby", "eve"].map(|login| format!("hw1-{login}-submission"));
    let branches = branches.each_ref().map(String::as_str);
    assert_eq!(whose(&branches, &people), "123");
    // If only one is of a branch, nobody knows, so it is listed.
    let one = ["hw1-bobby", "hw1-eve", "hw1-ada-submission"];
    let placed = place(&entries(&one), Some(&people));
    assert_eq!(placed.contested, one[2..]);
    // Somebody may have many accounts whose names end alike.
    let many = ["ada", "bobby", "ada-x", "bobby-x", "eve-x", "y-x"];
    let many = many.map(|login| format!("hw1-{login}"));
    let many = many.each_ref().map(String::as_str);
    assert_eq!(whose(&many, &people), "12[1][2][3]?");
}

#[test]
fn nobody_has_the_work_of_a_team_or_of_an_id_by_a_login() {
    let mut all = people(["17", "204", "1001", ""]);
    for (person, team) in all[2..].iter_mut().zip(["17", "204"]) {
        person.group = Some(team.into());
    }
    let teams = whose(&["hw1-17", "hw1-204"], &all);
    assert_eq!(teams, "[13][24]");
    // The instructor has named the folders.
    for folders in [
        ["hw1-1001", "hw1-1002", "hw1-1004"],
        ["hw1-ada-lovelace", "hw1-bob-babbage", "hw1-mallory-mann"],
    ] {
        let mut people = people(["", "", &folders[0][4..], &folders[1][4..]]);
        people[2].name = "E. E.".into();
        let found = whose(&folders, &people);
        assert!(found.contains('1') && !found.starts_with('3'), "{found}");
    }
    let mut people = people(["ada", "bobby", "eve", "mal"]);
    for (person, team) in people[2..].iter_mut().zip(["hw1 ada", "hw1 bobby"]) {
        person.group = Some(team.into());
    }
    let logins = ["ada", "bobby", "eve"]
        .into_iter()
        .chain(others(&mut people));
    let all: Vec<String> = logins.map(|login| format!("hw1-{login}")).collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    assert_eq!(whose(&all, &people), "123678");
}

#[test]
fn ids_may_be_logins_on_github() {
    let mut people = people(["ada", "bobby", "eve", "mal"]);
    for person in &mut people {
        person.id = person.github.clone().expect("it has one").to_uppercase();
    }
    people[3].name = "Ada".into();
    let of = |names: &[&str]| place(&entries(names), Some(&people)).of;
    let of = of(&["hw1-ada", "hw1-bobby", "hw1-eve"]);
    assert_eq!(of["hw1-ada"].id, "ADA");
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

/// A text of one to three parts that occur in names.
fn word(below: &mut dyn FnMut(usize) -> usize) -> String {
    const PARTS: [&str; 18] = [
        "hw", "1", "hw-1", "hw-1-ada", "ada", "bobby", "eve", "lee", "eve-lee", "dan", "hal",
        "ida", "main", "x", "2001", "2002", "2009", "surname",
    ];
    let count = 1 + below(3);
    let parts: Vec<&str> = (0..count).map(|_| PARTS[below(PARTS.len())]).collect();
    parts.join("-")
}

#[test]
fn nobodys_repository_is_lost_or_given_away_whatever_a_few_others_choose() {
    const HONEST: [&str; 8] = [
        "ada", "bobby", "eve-lee", "dan", "fay", "gil9", "hal", "ida",
    ];
    for seed in 0..300 {
        let mut random = SplitMix64::seed_from_u64(seed);
        let mut below = |most: usize| random.next_u64() as usize % most;
        let mut people: Vec<Person> = Vec::new();
        for (k, login) in HONEST.iter().enumerate() {
            people.push(Person {
                github: Some((*login).into()),
                ..person(&format!("200{k}"), &format!("{login} Surname"))
            });
        }
        // The last one has handed in nothing.
        let mut names: Vec<String> = HONEST[..7].iter().map(|it| format!("hw-1-{it}")).collect();
        for k in 0..3 {
            let login = word(&mut below);
            let is_free = |it: &Person| it.github.as_deref() != Some(&login);
            let mut mallory = person(&format!("300{k}"), &word(&mut below).replace('-', " "));
            mallory.github = Some(login.clone()).filter(|_| people.iter().all(is_free));
            mallory.group = Some(word(&mut below)).filter(|_| below(2) == 0);
            if mallory.github.is_some() && below(2) == 0 {
                names.push(format!("hw-1-{login}"));
            }
            people.push(mallory);
        }
        for _ in 0..below(12) {
            // An account of somebody who is not on the roster
            let login = word(&mut below);
            let is_free = |it: &Person| it.github.as_deref() != Some(&login);
            if people.iter().all(is_free) {
                names.push(format!("hw-1-{login}"));
            }
        }
        names.sort();
        names.dedup();
        let placed = place(
            &entries(&names.iter().map(String::as_str).collect::<Vec<_>>()),
            Some(&people),
        );
        for (k, login) in HONEST[..7].iter().enumerate() {
            let own = placed.of.get(&format!("hw-1-{login}")).map(|it| &*it.id);
            let id = format!("200{k}");
            assert_eq!(
                own,
                Some(&*id),
                "{seed} {login} {names:#?} {people:#?} {placed:#?}"
            );
            let several = placed.of.values().filter(|it| it.id == id).count();
            assert_eq!(
                several, 1,
                "{seed} {login} {names:#?} {people:#?} {placed:#?}"
            );
        }
        let idas = placed.of.values().find(|it| it.id == "2007");
        assert_eq!(idas, None, "{seed} {names:#?} {people:#?} {placed:#?}");
    }
}
