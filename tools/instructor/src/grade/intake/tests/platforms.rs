//! Attacks by names of files that look like those of another platform, or of another upload.

use super::hostile::{all_of, placed, placed_among};
use super::*;
use crate::grade::intake::placement::tests::person;

#[test]
fn only_the_platform_of_the_export_gives_times_and_numbers() {
    let export = Export::new();
    for file in [
        "class/Ada Lovelace_11_assignsubmission_file_hw.zip",
        "class/Eve Mann_13_assignsubmission_file_x_attempt_2026-11-20-10-00-00.zip",
        "folders/1001/hw.zip",
        "folders/1002/hw.zip",
        "folders/manneve_11_1_hw.zip",
    ] {
        export.put(file, &zip(&answers("", "somebody")));
    }
    let of_class = export.find("class").entries;
    for entry in &of_class {
        let number = entry.named_by(Platform::Moodle).next().map(|it| it.number);
        let is_ada = number == Some("11");
        assert_eq!(is_ada, entry.name.starts_with("Ada"), "{entry:?}");
        assert_eq!(entry.platform, Some(Platform::Moodle), "{entry:?}");
        let time = names::handed_in(&entry.given, Platform::Moodle);
        assert_eq!(time, None, "{entry:?}");
    }
    for entry in export.find("folders").entries {
        assert_eq!(entry.platform, None, "{entry:?}");
        assert_eq!(entry.named_by(Platform::Canvas).next(), None, "{entry:?}");
        let is_hers = entry.given[0].starts_with("manneve");
        assert_eq!(entry.at_most == Proof::Name, is_hers, "{entry:?}");
    }
}

#[test]
fn the_name_of_an_archive_passed_alone_gives_no_time_and_no_number() {
    let export = Export::new();
    let names = [
        "1001.zip",
        "manneve_11_1_hw.zip",
        "1-2 - Eve Mann - Nov 1, 2020 1159 PM - hw.zip",
    ];
    for name in names {
        export.put(name, &zip(&answers("", "somebody")));
    }
    let paths = names.map(|name| export.path(name));
    for paths in [&paths[..], &paths[1..2], &paths[2..]] {
        let intake = find(paths, &assignment(), None, None).expect("they can be read");
        assert_eq!(intake.entries.len(), paths.len());
        for entry in intake.entries {
            assert_eq!(entry.platform, None, "{entry:?}");
            assert!(entry.at_most <= Proof::Name, "{entry:?}");
        }
    }
}

#[test]
fn a_branch_named_like_a_platforms_file_proves_nothing() {
    let export = Export::new();
    let names = [
        "one/hw1-ada-main",
        "one/hw1-bob-main",
        "one/hw1-mal-x_mal_attempt_2026-11-19-10-00-00",
        "most/hw1-bob-main",
        "most/hw1-eve-y_13_9_z",
        "most/hw1-mal-x-ada_11_503_z",
        "all/hw1-eve-y_13_9_z",
        "all/hw1-mal-x-ada_11_503_z",
    ];
    for name in names {
        export.put_all(name, answers("", "somebody"));
    }
    let people = ["ada", "bob", "eve", "mal"].map(|login| Person {
        github: Some(login.into()),
        number: Some(login.replace("ada", "11")),
        ..person(login, login)
    });
    for (class, named) in [
        ("one", "hw1-{github}-main"),
        ("most", "hw1-{github}-main"),
        ("all", "hw1-{github}-main"),
        ("one", "{github}-main"),
        ("most", "{github}-main"),
    ] {
        let (intake, placed) = placed_among(&export, &[class], &people, named);
        for entry in intake.entries {
            assert_eq!(entry.platform, None, "{entry:?}");
        }
        let is_listed = |id: &String| placed.by_name.contains(id);
        let unlisted = placed.of.iter().filter(|(id, _)| !is_listed(id));
        let clones = unlisted.clone().filter(|(id, _)| id.ends_with("-main"));
        assert_eq!(unlisted.count(), clones.count(), "{placed:?}");
    }
}

#[test]
fn a_name_like_another_platforms_is_listed() {
    let export = Export::new();
    for name in ["Bob Byron_12", "Eve Evans_14"] {
        export.put_all(
            &format!("class/{name}_assignsubmission_file"),
            answers("", "hers"),
        );
    }
    export.put_all("class/lovelaceada_11_501_x", answers("", "mallory"));
    let list = "id,name,number\n1,Ada Lovelace,11\n2,Bob Byron,12\n3,Eve Evans,14\n";
    let (_, placed) = placed(&export, &["class"], list);
    assert_eq!(placed.of.len(), 3, "{placed:?}");
    assert_eq!(placed.by_name, ["lovelaceada_11"], "{placed:?}");
}

#[test]
fn somebody_whose_name_begins_with_a_dot_has_handed_in() {
    let export = Export::new();
    let folders = [". Ada", "Bob", ".git"];
    let folders = folders.map(|name| match name {
        ".git" => name.to_owned(),
        _ => format!("{name}_11_assignsubmission_file_"),
    });
    for folder in &folders {
        export.put_all(&format!("class/{folder}"), answers("", "somebody"));
    }
    let files = folders
        .iter()
        .map(|it| answers(&format!("{it}/"), "somebody"));
    export.put("class.zip", &zip(&files.flatten().collect::<Vec<_>>()));
    for class in ["class", "class.zip"] {
        export.is_of(class, &["Bob_11", ". Ada_11"]);
    }
}

#[test]
fn an_upload_that_may_be_a_persons_second_is_listed() {
    let export = Export::new();
    for file in [
        "moodle/Ada Lovelace_11_assignsubmission_file_hw.zip",
        "moodle/Eve Mann_13_assignsubmission_file_hw.zip",
        "moodle/Eve Mann_13_assignsubmission_file_Eve_13_1_b.zip",
        "canvas/lovelaceada_11_501_hw.zip",
        "canvas/manneve_13_502_hw.zip",
        "canvas/manneve_13_503_manneve_13_1_b.zip",
    ] {
        export.put(file, &zip(&answers("", "somebody")));
    }
    export.is_of("moodle", &["Ada Lovelace_11", "Eve Mann_13"]);
    let further = "canvas/manneve_13_503_manneve_13_1_b.zip";
    for entry in export.find("canvas").entries {
        let is_listed = entry.doubts.iter().any(|it| it.contains("a later upload"));
        assert_eq!(is_listed, further.ends_with(&entry.name), "{entry:?}");
    }
}

#[test]
fn blackboard_names_the_person_before_the_attempt_and_the_uploader_names_the_rest() {
    let export = Export::new();
    let ada = zip(&answers("", "ada"));
    export.put("class/HW1_al1_attempt_2026-11-20-20-00-00_hw.zip", &ada);
    let name = "class/HW1_mm1_attempt_2026-11-20-21-00-00_Ada Lovelace.zip";
    export.put(name, &zip(&answers("", "mallory")));
    let found = placed(&export, &["class"], "id,name,login\n1,Ada Lovelace,al1\n");
    assert_eq!(all_of(&found, "1"), ["// sphere by ada"], "{:#?}", found.1);
    assert_eq!(found.1.unknown.len(), 1, "{:#?}", found.1);
    assert_eq!(
        found.1.by_name.len(),
        1,
        "it may be x_al1's: {:#?}",
        found.1
    );
    // Without logins on the roster, no submission is guessed to be anybody's.
    let found = placed(&export, &["class"], "id,name\n1,Ada Lovelace\n");
    assert!(found.1.of.is_empty(), "{:#?}", found.1);
}

#[test]
fn blackboards_title_is_what_the_instructor_says() {
    let export = Export::new();
    // All of these could also be Canvas's, because the title contains a number.
    for (login, author) in [("1001", "ada"), ("1002", "bob"), ("7_1001", "mallory")] {
        let name = format!("HW_1_{login}_attempt_2026-11-20-20-00-00");
        let upload = zip(&answers("", author));
        export.put(
            &format!("class/{name}_x_attempt_2026-11-20-10-00-00.zip"),
            &upload,
        );
        export.put(&format!("class/{name}.txt"), b"Files: 1");
    }
    export.put("class/HW_1_notes.txt", b"mine");
    // Somebody who hands in too much takes nothing from the others.
    for k in 10..30 {
        let name = format!("class/HW_1_1000_attempt_2026-11-20-10-{k}-00_hw.zip");
        export.put(&name, &zip(&archives::many_answers("")));
    }
    let people = [("1001", "Ada Lovelace"), ("1002", "Bob Byron")];
    let people = people.map(|(id, name)| person(id, name));
    let found = placed_among(&export, &["class"], &people, "HW_1_{id}");
    assert_eq!(
        all_of(&found, "1001"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
    assert_eq!(
        all_of(&found, "1002"),
        ["// sphere by bob"],
        "{:#?}",
        found.1
    );
    let (intake, placed) = found;
    assert_eq!(intake.entries.len(), 23, "{intake:#?}");
    assert_eq!(intake.ignored, ["HW_1_notes.txt"]);
    let of_mallory = "HW_1_7_1001_attempt_2026-11-20-20-00-00";
    assert_eq!(placed.ambiguous[of_mallory], people[..1], "{placed:#?}");
    assert!(
        placed.by_name.is_empty() && placed.contested.is_empty(),
        "{placed:#?}"
    );
    for entry in &intake.entries {
        let time = names::handed_in(&entry.given, Platform::Blackboard);
        assert_eq!(entry.platform, Some(Platform::Blackboard));
        assert!(time.is_some(), "{entry:?}");
    }
    // A clone is named by the instructor alone.
    export.put_all(
        "clones/hw1-ada_attempt_2026-11-20-20-00-00",
        answers("", "mallory"),
    );
    export.put_all("clones/hw1-bob", answers("", "bob"));
    let people = people.map(|it| Person {
        group: Some(if it.id == "1001" { "ada" } else { "bob" }.into()),
        ..it
    });
    let (_, placed) = placed_among(&export, &["clones"], &people, "hw1-{group}");
    assert_eq!(placed.of.len(), 1, "{placed:#?}");
}

#[test]
fn names_with_several_times_are_listed() {
    let export = Export::new();
    for name in [
        // Only the second time is the platform's.
        "display/13-77 - Eve - Nov 1, 2026 1200 AM - x - Nov 19, 2026 1000 AM - a.zip",
        "display/13-77 - Eve - Nov 1, 2026 1200 AM - x - Nov 20, 2026 800 PM - b.zip",
        "file/HW1_eve_attempt_2026-11-19-10-00-00_x_attempt_2026-11-20-23-58-00.zip",
        "file/HW1_eve_attempt_2026-11-20-20-00-00_b.zip",
        "honest/13-77 - Eve - Nov 19, 2026 1000 AM - a.zip",
        "honest/13-77 - Eve - Nov 20, 2026 800 PM - b.zip",
    ] {
        export.put(name, &zip(&answers("", "eve")));
    }
    for (class, listed) in [("display", 1), ("file", 1), ("honest", 0)] {
        let all = export.find(class).entries;
        let doubts = all.iter().flat_map(|it| &it.doubts);
        let times = doubts.filter(|it| it.contains("several times"));
        assert_eq!(times.count(), listed, "{class}: {all:#?}");
    }
}
