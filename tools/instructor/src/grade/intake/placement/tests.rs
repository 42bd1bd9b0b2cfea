use super::*;
use crate::grade::intake::plain::tests::whose;
use crate::grade::intake::{matching, names};

/// An entry with the signs that its name gives.
fn entry(name: &str) -> Entry {
    let platforms = names::platforms(name);
    let signs = match platforms.is_empty() {
        false => platforms.iter().map(|it| it.sign()).collect(),
        true => vec![Sign::Plain(name.into())],
    };
    Entry {
        given: Vec::new(),
        platform: None,
        id: name.into(),
        name: name.into(),
        signs,
        at_most: Proof::Id,
        notes: Vec::new(),
        doubts: Vec::new(),
        unusable: Vec::new(),
        answers: None,
        submission: Err("not asked".into()),
    }
}

pub fn entries(names: &[&str]) -> Vec<Entry> {
    names.iter().map(|name| entry(name)).collect()
}

pub fn person(id: &str, name: &str) -> Person {
    Person {
        id: id.into(),
        name: name.into(),
        ..Person::default()
    }
}

fn people() -> Vec<Person> {
    let mut people: Vec<Person> = [
        ("s1", "Ada Lovelace"),
        ("s2", "Hopper, Grace"),
        ("s3", "Zoë Müller"),
        ("s4", "Sam Lee"),
        ("s5", "Lee Sam"),
        ("20239999", "Gus Ghost"),
        ("s7", "Pat O`Brien"),
    ]
    .map(|(id, name)| person(id, name))
    .into();
    people[1].logins = vec!["ghopper@uni.example".into()];
    people
}

#[track_caller]
fn is(name: &str, id: &str) {
    let placed = place(&entries(&[name]), Some(&people()), &NamePattern::default());
    let found = placed.of.get(name).map(|person| person.id.as_str());
    assert_eq!(found, Some(id), "{name}: {placed:?}");
    assert!(placed.several.is_empty(), "{name}: {placed:?}");
    assert_eq!(placed.people, Some(people().len()));
}

#[test]
fn platform_names_and_plain_names_find_their_people() {
    is("lovelaceada_12345_67890_answers.zip", "s1");
    is("hoppergrace_LATE_12345_67890_src-2.zip", "s2");
    is("mllerzo_1_2_a.zip", "s3");
    is("müllerzoë_1_2_a.zip", "s3");
    is("Grace Hopper_777_assignsubmission_file", "s2");
    is("Ada Lovelace_777_assignsubmission_file_", "s1");
    is("Pat O%60Brien_777_assignsubmission_file_", "s7");
    is("s1", "s1");
    is("ghopper@uni.example", "s2");
}

#[test]
fn nobody_is_meant_because_an_address_is_like_the_name_that_a_platform_writes() {
    let mut people = people();
    people[1].logins = vec!["ada.lovelace@x.org".into(), "zed.zulu@x.org".into()];
    for (name, expected) in [
        ("Ada Lovelace_777_assignsubmission_file", "1"),
        ("lovelaceada_1_2_a.zip", "1"),
        ("11-5 - Ada Lovelace - Nov 20, 2026 1100 PM", "1"),
        ("Zed Zulu_778_assignsubmission_file", "?"),
    ] {
        assert_eq!(whose(&[name], &people), expected, "{name}");
    }
}

#[test]
fn accents_find_their_people_however_they_are_written() {
    is("Zoe\u{308} Mu\u{308}ller_777_assignsubmission_file", "s3");
    is("mu\u{308}llerzoe\u{308}_1_2_a.zip", "s3");
    is("mullerzoe_1_2_a.zip", "s3");
    // A letter that the roster's name lacks is not just an accent.
    for name in [
        "Ada Lovelace學_777_assignsubmission_file",
        "lovelaceada學_1_2_a.zip",
        "Ada Lovelace學",
    ] {
        let placed = place(&entries(&[name]), Some(&people()), &NamePattern::default());
        assert_eq!(placed.unknown, [name]);
    }
    // Without accents, a name may be that of somebody who has lost them.
    let people = [person("1", "Zoë Müller"), person("2", "Zoe Muller")];
    for (name, expected) in [("Zoe Muller", "[12]"), ("Zoe\u{308} Mu\u{308}ller", "1")] {
        let name = format!("{name}_777_assignsubmission_file");
        assert_eq!(whose(&[&name], &people), expected);
    }
    // Nobody else hides it by choosing the name with its accents.
    let mut people = [person("1", "Eve"), person("2", "Zoe Muller")];
    people[0].group = Some("Zo\u{eb} M\u{fc}ller".into());
    let name = "Zo\u{eb} M\u{fc}ller_777_assignsubmission_file";
    assert_eq!(whose(&[name], &people), "[12]");
}

#[test]
fn ambiguous_and_unknown_submissions_are_listed() {
    let all = entries(&["leesam_1_2_a.zip", "mallory"]);
    let placed = place(&all, Some(&people()), &NamePattern::default());
    assert_eq!(placed.ambiguous["leesam_1_2_a.zip"].len(), 2);
    assert_eq!(placed.unknown, ["mallory"]);
    assert_eq!(placed.missing.len(), 5);
    assert_eq!(placed.in_doubt().len(), 2);
}

#[test]
fn an_account_with_somebody_elses_name_does_not_get_their_mark() {
    let names = ["lovelaceada_11_501_a.zip", "lovelaceada_12_502_a.zip"];
    let placed = place(&entries(&names), Some(&people()), &NamePattern::default());
    assert!(
        placed.of.is_empty() && placed.superseded.is_empty(),
        "{placed:?}"
    );
    assert_eq!(placed.ambiguous.len(), 2);
    // The roster can say which account is hers.
    let mut people = people();
    people[0].number = Some("11".into());
    let placed = place(&entries(&names), Some(&people), &NamePattern::default());
    assert_eq!(placed.of[names[0]].id, "s1");
    assert_eq!(placed.unknown, [names[1]]);
}

#[test]
fn file_name_chosen_by_the_uploader_is_not_trusted() {
    let names = [
        "lovelaceada_11_501_a.zip",
        "malletmallory_13_503_x_s1_assignsubmission_file.zip",
        "friendfred_14_504_y_20239999_assignsubmission_file.zip",
        "samlee_15_505_Ada Lovelace_16_assignsubmission_file.zip",
    ];
    let placed = place(&entries(&names), Some(&people()), &NamePattern::default());
    assert_eq!(placed.of.len(), 1, "{placed:?}");
    assert_eq!(placed.of[names[0]].id, "s1");
    assert_eq!(placed.unknown, names[1..3], "{placed:?}");
    assert!(placed.ambiguous.contains_key(names[3]), "{placed:?}");
}

#[test]
fn names_that_people_choose_are_listed_and_yield_to_names_that_they_do_not_choose() {
    let named = "lovelaceada_13_502_hw.zip";
    let placed = place(
        &entries(&[named, "s2", "s3"]),
        Some(&people()),
        &NamePattern::default(),
    );
    assert_eq!(placed.of[named].id, "s1");
    assert_eq!(placed.by_name, [named]);
    let placed = place(
        &entries(&[named, "s1"]),
        Some(&people()),
        &NamePattern::default(),
    );
    assert_eq!(placed.of.len(), 1);
    assert_eq!(placed.of["s1"].id, "s1");
    assert!(placed.ambiguous.contains_key(named), "{placed:?}");
    // A name among other words proves nothing, because it may be a login.
    let placed = place(
        &entries(&["hw1-ada-lovelace"]),
        Some(&people()),
        &NamePattern::default(),
    );
    assert!(placed.ambiguous.contains_key("hw1-ada-lovelace") && placed.of.is_empty());
}

#[test]
fn a_number_that_happens_to_be_another_persons_id_contradicts_the_name() {
    let name = "lovelaceada_20239999_501_a.zip";
    let placed = place(&entries(&[name]), Some(&people()), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
    let name = "nobodyever_20239999_501_a.zip";
    let placed = place(&entries(&[name]), Some(&people()), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 1, "{placed:?}");
    is("Gus Ghost_20239999_assignsubmission_file", "20239999");
}

#[test]
fn a_groups_number_on_moodle_is_not_mistaken_for_a_persons() {
    let mut people = people();
    people[0].number = Some("2001".into());
    let name = "Team Rocket_2001_assignsubmission_file";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous[name], [people[0].clone()], "{placed:?}");
    // Canvas writes the group's name, but the number of the person who handed in.
    for name in [
        "Lovelace Ada M._2001_assignsubmission_file",
        "teamrocket_2001_501_hw.zip",
    ] {
        let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
        assert_eq!(placed.of[name].id, "s1", "{placed:?}");
    }
}

#[test]
fn a_group_with_somebodys_number_and_a_word_of_their_name_is_not_taken_for_them() {
    let mut people = people();
    people[0].number = Some("2001".into());
    people[3].number = Some("2004".into());
    people[3].group = Some("Ada fans".into());
    let name = "Ada fans_2001_assignsubmission_file";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
    // Nobody can put a person's own submission in doubt by a group's name, but it is listed.
    let name = "Ada Lovelace_2001_assignsubmission_file";
    for group in ["Ada fans", "Ada Lovelace"] {
        people[3].group = Some(group.into());
        let others = [
            "Grace Hopper_2002_assignsubmission_file",
            "Zoë Müller_2003_assignsubmission_file",
        ];
        let placed = place(
            &entries(&[name, others[0], others[1]]),
            Some(&people),
            &NamePattern::default(),
        );
        assert_eq!(placed.of[name].id, "s1", "{placed:?}");
        let is_listed = placed.contested.iter().any(|it| it == name);
        assert_eq!(is_listed, group == "Ada Lovelace", "{placed:?}");
    }
    // Another group's name may look like that of her group.
    people[0].group = Some("1".into());
    people[3].group = Some("1.".into());
    let name = "1._2001_assignsubmission_file";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
    // Somebody who is not on the roster may have the same name.
    people[3].group = Some("Ada fans".into());
    let name = "Ada fans_3001_assignsubmission_file";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous[name], people[3..4], "{placed:?}");
    let name = "adafans_3001_501_hw.zip";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert!(
        placed.of.is_empty(),
        "Canvas writes a person's number: {placed:?}"
    );
}

#[test]
fn a_date_in_an_uploads_own_name_is_not_mistaken_for_an_account() {
    let mut people = people();
    people[0].number = Some("11".into());
    people[1].number = Some("12".into());
    let name = "lovelaceada_11_501_hw_2026_11_20.zip";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.of[name].id, "s1", "{placed:?}");
    assert_eq!(placed.by_name, [name]);
    // Here, the first part is the name of nobody whom we know.
    let chosen = "nobody_77_11_501_z.zip";
    let placed = place(&entries(&[chosen]), Some(&people), &NamePattern::default());
    assert!(placed.ambiguous.contains_key(chosen), "{placed:?}");
    // The date may also be somebody else's number.
    let mut others = people.clone();
    others[2].number = Some("2026".into());
    let placed = place(&entries(&[name]), Some(&others), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
    // An account whose name looks like hers replaces nothing.
    for names in [
        [
            "lovelaceada_11_9_12_502_hw.zip",
            "lovelaceada_11_501_hw.zip",
        ],
        [
            "lovelaceada_11_9_13_502_hw.zip",
            "lovelaceada_11_501_hw.zip",
        ],
    ] {
        let placed = place(&entries(&names), Some(&people), &NamePattern::default());
        assert_eq!(placed.of.len(), 1, "{placed:?}");
        assert_eq!(placed.of[names[1]].id, "s1");
        assert!(placed.ambiguous.contains_key(names[0]), "{placed:?}");
        assert!(placed.in_doubt().iter().all(|person| person.id != "s1"));
        // Beside other paths, even the platform's number proves less.
        let mut all = entries(&names);
        all.iter_mut().for_each(|it| it.at_most = Proof::Name);
        let placed = place(&all, Some(&people), &NamePattern::default());
        assert!(placed.of.is_empty(), "{placed:?}");
    }
    let both = [name, "lovelaceada_11_99_777_hw.zip"];
    let placed = place(&entries(&both), Some(&people), &NamePattern::default());
    assert!(
        placed.of.is_empty(),
        "nobody knows which is hers: {placed:?}"
    );
    assert_eq!(placed.ambiguous.len(), 2);
    // The date is also somebody else's number, or only the name says who it is.
    for people in [&others, &people[..1]] {
        let mut people = people.to_vec();
        if people.len() == 1 {
            people[0].number = None;
        }
        let both = [name, "lovelaceada_13_502_hw.zip"];
        let placed = place(&entries(&both), Some(&people), &NamePattern::default());
        assert!(placed.of.is_empty(), "{placed:?}");
    }
}

#[test]
fn a_persons_name_may_begin_with_the_first_or_the_last_name() {
    let ada = person("s1", "Ada Lovelace");
    for (name, is_hers) in [
        ("Lovelace, Ada", true),
        ("ada lovelace", true),
        ("Ada", false),
        ("Ada Byron", false),
        ("", false),
    ] {
        assert_eq!(matching::is_name(name, &ada), is_hers, "{name}");
    }
}

#[test]
fn a_name_of_one_word_is_not_looked_for_among_other_words() {
    let plato = person("s9", "Plato");
    let placed = place(
        &entries(&["homework1-plato"]),
        Some(&[plato]),
        &NamePattern::default(),
    );
    assert!(
        placed.of.is_empty() && placed.ambiguous.is_empty(),
        "{placed:?}"
    );
}

#[test]
fn several_submissions_by_one_person_are_all_listed() {
    let mut people = people();
    people[1].logins.push("gh77".into());
    let placed = place(
        &entries(&["s2", "gh77"]),
        Some(&people),
        &NamePattern::default(),
    );
    assert!(placed.superseded.is_empty());
    assert_eq!(placed.several.len(), 1);
    assert_eq!(placed.of.len(), 2);
    // Two archives may have one name, and their authors chose it.
    let mut both = entries(&["s2", "s2"]);
    both[1].id = "s2.2".into();
    both.iter_mut().for_each(|it| it.at_most = Proof::Name);
    let placed = place(&both, Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous.len(), 2, "{placed:?}");
}

#[test]
fn an_address_that_people_may_have_typed_in_is_listed() {
    // Eve may have entered Ada's private address on the platform.
    let mut people = people();
    people[0].logins = vec!["ada@home.example".into()];
    people[1].id = "grace@uni.example".into();
    let placed = place(
        &entries(&["ada@home.example", "grace@uni.example"]),
        Some(&people),
        &NamePattern::default(),
    );
    assert_eq!(placed.of.len(), 2);
    assert_eq!(placed.by_name, ["ada@home.example"]);
}

#[test]
fn a_single_name_like_a_platforms_is_listed() {
    let mut people = people();
    people[0].number = Some("11".into());
    let chosen = "lovelaceada_11_501_hw.zip";
    for (others, is_listed) in [
        (["s2", "s3"], true),
        (
            ["hoppergrace_12_502_hw.zip", "mullerzoe_13_503_hw.zip"],
            false,
        ),
    ] {
        let names = [chosen, others[0], others[1]];
        let placed = place(&entries(&names), Some(&people), &NamePattern::default());
        assert_eq!(placed.of[chosen].id, "s1");
        assert_eq!(placed.by_name.iter().any(|it| it == chosen), is_listed);
    }
}

#[test]
fn an_address_is_not_confused_with_one_that_has_the_same_letters() {
    let mut people = people();
    people[0].logins = vec!["ada@cs.uni.edu".into()];
    people[1].logins = vec!["adacs@uni.edu".into()];
    for name in ["ada@cs.uni.edu", "Ada@cs.uni.edu"] {
        let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
        assert_eq!(placed.of.get(name), Some(&people[0]), "{placed:?}");
    }
    let name = "ada_cs_uni_edu";
    let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
    assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
}

#[test]
fn a_group_named_like_anothers_id_or_login_takes_nobodys_place() {
    let mut people = people();
    people[0].logins = vec!["al123".into()];
    people[1].group = Some("AL-123".into());
    people[2].group = Some("S-1".into());
    people[3].group = Some("AL123".into());
    let placed = place(&entries(&["al123"]), Some(&people), &NamePattern::default());
    assert_eq!(placed.of["al123"].id, "s1", "{placed:?}");
    assert_eq!(placed.contested, ["al123"]);
    people[3].group = None;
    for (name, member) in [("AL-123", 1), ("S-1", 2)] {
        let placed = place(&entries(&[name]), Some(&people), &NamePattern::default());
        assert_eq!(placed.ambiguous[name].len(), 2, "{placed:?}");
        assert!(
            placed.ambiguous[name].contains(&people[member]),
            "{placed:?}"
        );
    }
    // Nobody takes an id, but it is listed.
    let placed = place(&entries(&["s1"]), Some(&people), &NamePattern::default());
    assert_eq!(placed.of["s1"].id, "s1", "{placed:?}");
    assert_eq!(placed.contested, ["s1"], "{placed:?}");
}

#[test]
fn an_assigned_login_outweighs_the_same_login_on_github() {
    let mut people = people();
    people[0].logins = vec!["al123".into()];
    people[1].github = Some("AL123".into());
    let placed = place(&entries(&["al123"]), Some(&people), &NamePattern::default());
    assert_eq!(placed.of["al123"].id, "s1", "{placed:?}");
    assert_eq!(placed.contested, ["al123"]);
    people[1].github = Some("al-123".into());
    let placed = place(
        &entries(&["al123", "al-123"]),
        Some(&people),
        &NamePattern::default(),
    );
    assert_eq!(placed.of["al123"].id, "s1", "{placed:?}");
    assert_eq!(placed.ambiguous["al-123"], people[..2]);
    // The instructor decides by an id, which nobody can contest. But if somebody has chosen it, it is
    // listed, because that name may be meant.
    for chosen in ["github", "address", "name"] {
        people[1].github = (chosen == "github").then(|| "s1".into());
        people[1].logins = vec!["gh".into()];
        match chosen {
            "address" => people[1].logins.push("s1@uni.edu".into()),
            "name" => people[1].name = "S1".into(),
            _ => {}
        }
        let placed = place(
            &entries(&["s1", "al123"]),
            Some(&people),
            &NamePattern::default(),
        );
        assert_eq!(placed.of["s1"].id, "s1", "{placed:?}");
        assert_eq!(placed.of["al123"].id, "s1", "{placed:?}");
        assert_eq!(placed.contested, ["s1"], "{chosen}: {placed:?}");
    }
}

#[test]
fn a_single_name_like_a_platforms_is_listed_even_if_there_is_no_other() {
    let mut people = people();
    people[0].number = Some("11".into());
    let mailed = "lovelaceada_11_999_late.zip";
    let placed = place(&entries(&[mailed]), Some(&people), &NamePattern::default());
    assert_eq!(placed.by_name, [mailed], "{placed:?}");
}

#[test]
fn a_login_that_blackboard_writes_is_certain_only_if_the_title_is_known() {
    let mut people = people();
    for (person, login) in people.iter_mut().zip(["al", "x_bob", "stud_s4"]) {
        person.logins = vec![login.into()];
    }
    let class = ["al", "x_bob", "stud_s4", "ext_s5", "S7"];
    let class = class.map(|login| format!("HW_1_{login}_attempt_2026-11-20-23-00-00"));
    let [ada, bob, zoe, stranger, pat] = class.each_ref().map(String::as_str);
    let placed = |people: &[Person], named: &NamePattern| {
        let entries = entries(&class.each_ref().map(String::as_str));
        place(&entries, Some(people), named)
    };
    let of = placed(&people, &NamePattern::default());
    assert_eq!(of.by_name, [ada, bob, stranger, pat], "{of:?}");
    assert_eq!(of.ambiguous[zoe].len(), 2, "{of:?}");
    let named = "HW_1_{id}".parse().expect("it is a pattern");
    let of = placed(&people, &named);
    let ids = [ada, bob, zoe, pat].map(|name| &*of.of[name].id);
    assert_eq!(ids, ["s1", "s2", "s3", "s7"]);
    assert_eq!(of.ambiguous[stranger], people[4..5], "{of:?}");
    assert!(of.by_name.is_empty() && of.contested.is_empty(), "{of:?}");
    // A group may have chosen a login, and somebody's login may be another person's id.
    people[3].group = Some("al".into());
    people[6].logins = vec!["pat".into()];
    assert_eq!(placed(&people, &named).contested, [ada, pat]);
    // People may have typed in an address, and its beginning may be somebody else's login.
    people[0].logins = vec!["al@x.org".into()];
    assert_eq!(placed(&people, &named).ambiguous[ada].len(), 2);
}
