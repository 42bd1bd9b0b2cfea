//! Attacks by names of files that look like those of another platform, or of another upload.

use super::*;

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
        ..placement::tests::person(login, login)
    });
    for (class, named) in [
        ("one", "hw1-{github}-main"),
        ("most", "hw1-{github}-main"),
        ("all", "hw1-{github}-main"),
        ("one", "{github}-main"),
        ("most", "{github}-main"),
    ] {
        let (intake, placed) = hostile::placed_among(&export, &[class], &people, named);
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
    let (_, placed) = hostile::placed(&export, &["class"], list);
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
