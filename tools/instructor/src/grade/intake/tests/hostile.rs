//! Attacks by uploaders: names, logins and archives that target other people's marks.

use super::*;
use crate::grade::intake::placement::Placement;
use crate::grade::intake::placement::tests::person;

#[test]
fn an_archive_with_other_peoples_names_is_one_submission() {
    let export = Export::new();
    let forged = zip(&answers("", "mallory"));
    let inside = vec![("lovelaceada_11_999_hw1.zip".to_owned(), forged)];
    export.put("class/malletmallory_13_502_hw1.zip", &zip(&inside));
    export.put(
        "class/lovelaceada_11_501_hw1.zip",
        &zip(&answers("", "ada")),
    );
    let intake = export.is_of("class", &["lovelaceada_11", "malletmallory_13"]);
    assert_eq!(text(&intake, 0, "sphere"), "// sphere by ada");
    assert_eq!(text(&intake, 1, "sphere"), "// sphere by mallory");
    let intake = export.find("class/malletmallory_13_502_hw1.zip");
    let sign = &intake.entries[0].signs[0];
    assert!(
        matches!(sign, Sign::Account { number, .. } if number == "13"),
        "{sign:?}"
    );
}

#[test]
fn a_folder_with_names_of_others_beside_single_submissions_is_listed() {
    let export = Export::new();
    export.put_all("clones/hw1-mal/2001", answers("", "mallory"));
    export.put_all("clones/hw1-bob", answers("", "bob"));
    let list = "id,name,github\n2001,Ada Lovelace,ada\n2002,Mal Mann,mal\n2003,Bob Boole,bob\n";
    let (intake, placed) = placed(&export, &["clones/hw1-mal", "clones/hw1-bob"], list);
    let of_mallory = &intake.entries[0];
    assert_eq!(of_mallory.id, "2001");
    assert!(of_mallory.doubts[0].contains("contains names of people"));
    assert!(placed.ambiguous.contains_key(&of_mallory.id), "{placed:?}");
}

#[test]
fn one_of_several_classes_may_be_a_students_so_all_are_listed() {
    let export = Export::new();
    export.put_all("late/2001", answers("", "mallory"));
    export.put_all("class/2003", answers("", "bob"));
    let list = "id,name\n2001,Ada Lovelace\n2002,Mal Mann\n2003,Bob Boole\n";
    let (_, placed) = placed(&export, &["late", "class"], list);
    assert_eq!(placed.by_name, ["2001", "2003"]);
}

#[test]
fn submissions_of_the_same_name_are_listed() {
    let export = Export::new();
    for (name, author) in [
        ("t/ada", "ada"),
        ("t/bob", "bob"),
        ("late/mal/ada", "mallory"),
    ] {
        export.put_all(name, answers("", author));
    }
    let paths = ["t/ada", "t/bob", "late/mal/ada"].map(|path| export.path(path));
    let intake = find(&paths, &assignment(), None, None).expect("it can be read");
    let doubts = intake.entries.iter().map(|it| it.doubts.len());
    assert_eq!(doubts.collect::<Vec<_>>(), [1, 1, 0]);
}

#[test]
fn a_folder_named_after_a_person_is_not_a_class() {
    let people = [
        person("bob", "Bob Brown"),
        person("eve", "Eve Malory"),
        person("mm", "class"),
    ];
    let export = Export::new();
    for others in ["bob", "Bob Brown_2001_assignsubmission_file"] {
        let forged = answers(&format!("{others}/"), "forged");
        export.put_all("eve", [answers("", "eve"), forged.clone()].concat());
        export.put_all(
            "Eve Malory",
            [answers("src/", "eve"), forged.clone()].concat(),
        );
        export.put_all("alone/eve", forged.clone());
        export.put_all("class", forged);
        let names = |folder: &str| -> Vec<String> {
            let found = find(&[export.path(folder)], &assignment(), Some(&people), None);
            let entries = found.expect("it can be read").entries.into_iter();
            entries.map(|entry| entry.given.concat()).collect()
        };
        assert_eq!(names("eve"), ["eve"]);
        assert_eq!(names("Eve Malory"), ["Eve Malory"]);
        assert_eq!(names("alone/eve"), ["eve"]);
        // The folder of the class doesn't become the submission of somebody who has its name.
        assert_eq!(names("class"), [others]);
        for folder in ["eve", "Eve Malory", "alone", "class"] {
            fs::remove_dir_all(export.path(folder)).expect("it is there");
        }
    }
}

#[test]
fn a_persons_name_that_looks_like_another_account_replaces_nobody() {
    let export = Export::new();
    for [ada, mallory] in [
        [
            "lovelaceada_11_501_hw.zip",
            "lovelaceada_11_99999_13_502_hw.zip",
        ],
        [
            "lovelaceada_11_501_hw.zip",
            "lovelaceada_LATE_11_99999_x_13_502_hw.zip",
        ],
    ] {
        let _former = fs::remove_dir_all(export.path("class"));
        export.put_all("class", vec![(ada.to_owned(), zip(&answers("", "ada")))]);
        export.put(&format!("class/{mallory}"), &zip(&answers("", "mallory")));
        let intake = export.find("class");
        assert!(intake.superseded.is_empty(), "{intake:#?}");
        let signs = |who: &str| {
            let mut entries = intake.entries.iter();
            let entry = entries.position(|it| text_of(it) == who);
            intake.entries[entry.expect("it is there")].signs.len()
        };
        assert_eq!(signs("ada"), 1, "{intake:#?}");
        assert!(signs("mallory") > 1, "{intake:#?}");
    }
}

#[test]
fn every_submission_is_in_exactly_one_shard() {
    let all: Vec<u32> = (0..10).collect();
    let mut shared: Vec<u32> = (1..=3)
        .flat_map(|k| shard(all.clone(), Some((k, 3))))
        .collect();
    shared.sort();
    assert_eq!(shared, all);
}

/// What was found at these paths, and whose it is according to this roster.
pub fn placed(export: &Export, names: &[&str], list: &str) -> (Intake, Placement) {
    export.put("roster.csv", list.as_bytes());
    let people = roster::read(&export.path("roster.csv")).expect("it is a roster");
    placed_among(export, names, &people, "{id}")
}

pub fn placed_among(
    export: &Export,
    names: &[&str],
    people: &[Person],
    named: &str,
) -> (Intake, Placement) {
    let named: NamePattern = named.parse().expect("it is a pattern");
    let paths: Vec<PathBuf> = names.iter().map(|name| export.path(name)).collect();
    let intake = find(&paths, &assignment(), Some(people), Some(&named)).expect("it can be read");
    let placed = placement::place(&intake.entries, Some(people), &named);
    (intake, placed)
}

/// The answers of everything that belongs to a person.
#[track_caller]
pub fn all_of(found: &(Intake, Placement), id: &str) -> Vec<String> {
    let (intake, placed) = found;
    let is_theirs = |entry: &&Entry| placed.of.get(&entry.id).is_some_and(|it| it.id == id);
    let own = intake.entries.iter().filter(is_theirs);
    own.map(|entry| {
        let submission = entry.submission.as_ref().expect("it can be read");
        let answer = submission.answer("sphere").expect("it is a task");
        answer.text.clone().expect("it is there")
    })
    .collect()
}

#[test]
fn brightspace_names_the_person_before_the_date_and_the_uploader_names_the_rest() {
    let export = Export::new();
    let ada = "class/11-22 - Ada Lovelace - Nov 20, 2026 1207 AM - hw1.zip";
    export.put(ada, &zip(&answers("", "ada")));
    let mallory = "class/11-23 - Mallory Mann - Nov 20, 2026 1100 PM - Ada Lovelace.zip";
    export.put(mallory, &zip(&answers("", "mallory")));
    let found = placed(&export, &["class"], "id,name\n1,Ada Lovelace\n");
    assert_eq!(all_of(&found, "1"), ["// sphere by ada"], "{:#?}", found.1);
}

#[test]
fn a_file_name_cannot_pose_as_a_part_of_our_message() {
    let export = Export::new();
    export.put_all("class/ada", answers("", "ada"));
    fs::remove_file(export.path("class/ada/sphere.rs")).expect("it was there");
    let said = "sphere` is fine: 100 points (`";
    export.put(&format!("class/ada/{said}.txt"), b"");
    export.put_all(&format!("class/bob/{said}"), answers("", "bob"));
    export.put_all("class/bob/z", answers("", "other"));
    export.put(&format!("class/eve/{said}.zip"), b"no archive");
    let intake = export.find("class");
    let told = intake.entries.iter();
    let told: Vec<&String> = told
        .flat_map(|it| it.doubts.iter().chain(&it.unusable))
        .collect();
    let is_about = |text: &&&String| text.contains("is fine");
    assert_eq!(told.iter().filter(is_about).count(), 8, "{told:#?}");
    for text in told {
        // Text between backticks is a name, and the rest is ours.
        let ours: String = text.split('`').step_by(2).collect();
        assert!(!ours.contains("100 points"), "{text}");
    }
}

#[test]
fn a_chosen_login_or_group_name_takes_nobodys_submission() {
    // The folder that Ada's answers are in, Ada's own login on GitHub, and what Mallory calls
    // herself or her group.
    let certain = [
        ("2001", "", "2001"),
        ("al1", "", "A-L1"),
        ("homework1-zed", "", "homework1"),
    ];
    let in_doubt = [
        ("Ada Lovelace", "", "ada-lovelace"),
        ("Lovelace, Ada", "", "lovelaceada"),
        ("homework1-countess", "countess", "homework1-countess"),
    ];
    for (folder, countess, mallory) in certain.into_iter().chain(in_doubt) {
        for by_group in [false, true] {
            let export = Export::new();
            export.put_all(&format!("class/{folder}"), answers("", "ada"));
            export.put_all("class/2003", answers("", "bob"));
            let person = |id: &str, name: &str, github: &str| Person {
                id: id.into(),
                name: name.into(),
                github: (!github.is_empty()).then(|| github.into()),
                ..Person::default()
            };
            let mut people = vec![
                person("2001", "Ada Lovelace", countess),
                person("2002", "Mallory Mann", ""),
                person("2003", "Bob Boole", ""),
            ];
            people[0].logins = vec!["al1".into()];
            match by_group {
                true => people[1].group = Some(mallory.into()),
                false => people[1].github = Some(mallory.into()),
            }
            let found = placed_among(&export, &["class"], &people, "{id}");
            let who = format!("{folder} {mallory} {by_group}: {:#?}", found.1);
            assert_eq!(all_of(&found, "2002"), [""; 0], "{who}");
            let is_hers = all_of(&found, "2001") == ["// sphere by ada"];
            let is_listed = found.1.ambiguous.len() + found.1.unknown.len() == 1;
            assert!(is_hers || is_listed, "{who}");
            if folder == "2001" || folder == "al1" {
                assert!(is_hers, "{who}");
            }
        }
    }
}

#[test]
fn a_chosen_address_or_login_like_somebodys_name_takes_nobodys_submission() {
    let by_address = "id,name,email\n2001,Ada Lovelace,al@uni.edu\n2003,Bob Boole,bob@uni.edu\n\
        2002,Mallory Mann,";
    let by_login = "username,name,github_id,student_id\nal,Ada Lovelace,1,2001\n\
        bob,Bob Boole,3,2003\n";
    let by_id = "username,name,github_id\nal,Ada Lovelace,1\nbob,Bob Boole,3\n";
    for (list, folder) in [
        (
            format!("{by_address}ada.lovelace@evil.org\n"),
            "Ada Lovelace",
        ),
        (format!("{by_address}al123@evil.org\n"), "al123"),
        (
            format!("{by_address}al123@evil.org\n"),
            "HW1_al123_attempt_2026-11-20-23-59-01",
        ),
        (
            format!("{by_login}AdaLovelace,Mallory Mann,2,2002\n"),
            "Ada Lovelace",
        ),
        (
            format!("{by_id}AdaLovelace,Mallory Mann,2\n"),
            "Ada Lovelace",
        ),
    ] {
        let export = Export::new();
        export.put_all(&format!("class/{folder}"), answers("", "ada"));
        export.put_all("class/Bob Boole", answers("", "bob"));
        let (_, placed) = placed(&export, &["class"], &list);
        // So is Bob's submission, because it has only his name.
        let listed = placed.ambiguous.len() + placed.by_name.len();
        assert_eq!(listed, 2, "{folder}: {placed:#?}");
    }
}

#[test]
fn a_login_on_github_with_the_name_of_the_class_does_not_take_the_class() {
    for list in [
        "username,name,github_id,student_id\nal,Ada Lovelace,1,2001\nclass,Mallory Mann,2,2002\n",
        "username,name,github_id\nal,Ada Lovelace,1\nclass,Mallory Mann,2\n",
    ] {
        let export = Export::new();
        export.put_all("class/al", answers("", "ada"));
        let (_, placed) = placed(&export, &["class"], list);
        assert_eq!(placed.missing.len(), 1, "{placed:#?}");
        assert_eq!(placed.missing[0].name, "Mallory Mann");
    }
}

#[test]
fn an_e_mail_address_elsewhere_puts_nobodys_submission_in_doubt() {
    let export = Export::new();
    export.put_all("class/2001", answers("", "ada"));
    let list = "id,name,email\n2001,Ada Lovelace,ada@uni.edu\n2002,Mallory Mann,2001@evil.org\n";
    let found = placed(&export, &["class"], list);
    assert_eq!(
        all_of(&found, "2001"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
}

#[test]
fn a_display_name_like_that_of_a_platforms_archive_does_not_take_the_class() {
    let export = Export::new();
    let upload = |name: &str, whose: &str| (name.to_owned(), zip(&answers("", whose)));
    let class = [
        upload("lovelaceada_11_501_hw.zip", "ada"),
        upload("brownbob_13_503_hw.zip", "bob"),
    ];
    export.put("submissions.zip", &zip(&class));
    let list = "id,name,number\n1,Ada Lovelace,11\n2,Submissions,12\n3,Bob Brown,13\n";
    let found = placed(&export, &["submissions.zip"], list);
    assert_eq!(all_of(&found, "1"), ["// sphere by ada"], "{:#?}", found.1);
    assert_eq!(all_of(&found, "2"), [""; 0], "{:#?}", found.1);
}

#[test]
fn a_chosen_login_like_a_folder_of_the_handout_takes_nobodys_submission() {
    let export = Export::new();
    export.put_all("late/src", answers("", "ada"));
    let list = "id,name,email\n1,Mallory Mann,src@x.org\n";
    let (intake, placement) = placed(&export, &["late"], list);
    assert_eq!(placement.unknown, [&*intake.entries[0].id]);
}

#[test]
fn a_platforms_number_beside_another_name_is_listed() {
    let export = Export::new();
    let list = "id,name,number\n2001,Ada Lovelace,77\n2002,Mallory Mann,\n";
    let put = |name: &str, whose| export.put(name, &zip(&answers("", whose)));
    put("class/manmallory_77_999_hw.zip", "mallory");
    let found = placed(&export, &["class"], list);
    assert_eq!(found.1.by_name.len(), 1, "{:#?}", found.1);
    put("class/lovelaceada_77_501_hw.zip", "ada");
    let found = placed(&export, &["class"], list);
    assert_eq!(
        all_of(&found, "2001"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
    assert_eq!(found.1.ambiguous.len(), 1, "{:#?}", found.1);
}

#[test]
fn a_class_never_becomes_one_submission_silently() {
    let export = Export::new();
    for (class, place) in [
        ("one", "handout/src/"),
        ("two", "assignments/x/handout/src/"),
        ("three", "src/"),
        ("four", ""),
    ] {
        export.put_all(class, answers(place, "mallory"));
        export.put_all(&format!("{class}/ada"), answers("", "ada"));
        export.put(&format!("{class}/bob.zip"), &zip(&answers("src/", "bob")));
        let intake = export.find(class);
        let of = |name: &str| intake.entries.iter().position(|entry| entry.name == name);
        let [Some(ada), Some(bob)] = ["ada", "bob.zip"].map(of) else {
            panic!("{class}: {intake:#?}");
        };
        assert_eq!(text(&intake, ada, "sphere"), "// sphere by ada");
        assert_eq!(text(&intake, bob, "sphere"), "// sphere by bob");
        // If there is only one other folder, it may also be the student's own copy.
        fs::remove_file(export.path(&format!("{class}/bob.zip"))).expect("it was there");
        let intake = export.find(class);
        let told = intake.entries.iter().any(|entry| !entry.doubts.is_empty());
        assert!(told || intake.entries.len() > 1, "{class}: {intake:#?}");
    }
    // In an archive too, nobody's files are left out silently.
    let both = [
        answers("ada/handout/src/", "ada"),
        answers("bob/src/", "bob"),
    ]
    .concat();
    export.put("class.zip", &zip(&both));
    let intake = export.find("class.zip");
    assert!(!intake.entries[0].doubts.is_empty(), "{intake:#?}");
}

#[test]
fn an_upload_among_others_does_not_bring_other_peoples_submissions() {
    let list = "id,name,number\n1,Ada Lovelace,11\n";
    for inside in ["lovelaceada_11_999_hw/", "1/"] {
        let export = Export::new();
        export.put("1.zip", &zip(&answers("", "ada")));
        export.put("my homework.zip", &zip(&answers(inside, "mallory")));
        let found = placed(&export, &["1.zip", "my homework.zip"], list);
        assert_eq!(all_of(&found, "1"), ["// sphere by ada"], "{:#?}", found.1);
        let told = found.0.entries.iter().any(|entry| !entry.doubts.is_empty());
        assert!(told, "{:#?}", found.0);
    }
}

#[test]
fn an_archive_proves_no_id_by_its_own_name_or_by_those_inside() {
    let list = "id,name,number\n1001,Ada Lovelace,11\n1002,Bob Boole,12\n";
    let export = Export::new();
    // Her name for the file may look like a platform's.
    export.put("lovelaceada_11_999_late.zip", &zip(&answers("", "mallory")));
    let both = [answers("1001/", "ada"), answers("1002/", "bob")].concat();
    export.put("class.zip", &zip(&both));
    for path in ["lovelaceada_11_999_late.zip", "class.zip"] {
        let (intake, placement) = placed(&export, &[path], list);
        assert!(intake.entries.iter().all(|it| it.at_most < Proof::Id));
        let listed = [placement.by_name, placement.contested].concat();
        assert_eq!(listed.len(), intake.entries.len(), "{listed:?}");
    }
}

#[test]
fn a_long_name_hides_nobodys_account() {
    let numbers =
        "id,name,number\n2001,Ada Lovelace,11\n2002,Bob Boole,12\n2003,Mallory Mallet,13\n";
    let names = "id,name\n2001,Ada Lovelace\n2002,Bob Boole\n2003,Mallory Mallet\n";
    for file in [
        format!("2001 {}.zip", "x".repeat(240)),
        format!("{}.zip", "作业一光线投射".repeat(12)),
    ] {
        let export = Export::new();
        let whole = |name: &str, whose| (name.to_owned(), zip(&answers("", whose)));
        let mut files = vec![
            whole("boolebob_12_502_hw.zip", "bob"),
            whole(&format!("malletmallory_13_503_{file}"), "mallory"),
        ];
        export.put("class.zip", &zip(&files));
        for list in [numbers, names] {
            let found = placed(&export, &["class.zip"], list);
            assert_eq!(all_of(&found, "2003"), ["// sphere by mallory"]);
            let missing: Vec<&str> = found.1.missing.iter().map(|it| &*it.id).collect();
            assert_eq!(missing, ["2001"], "{:#?}", found.1);
        }
        // Several such files, of which none is a submission, don't hide the class.
        files.extend((0..4).map(|k| (format!("malletmallory_13_60{k}_{file}.txt"), Vec::new())));
        export.put("class.zip", &zip(&files));
        let intake = export.find("class.zip");
        let names: Vec<&str> = intake.entries.iter().map(|it| &*it.name).collect();
        assert_eq!(names, ["boolebob_12", "malletmallory_13"]);
    }
}

#[test]
fn a_name_that_leads_out_of_a_class_refuses_only_that_upload() {
    type Pack = fn(&Files) -> Vec<u8>;
    for (pack, file) in [
        ((|files| zip(files)) as Pack, r"\..\x.zip"),
        (|files| zip(files), "\0.zip"),
        (tar_gz, r"\..\x.zip"),
    ] {
        let export = Export::new();
        let whole = |name: &str, whose| (name.to_owned(), zip(&answers("", whose)));
        let mut files = vec![
            whole("boolebob_12_502_hw.zip", "bob"),
            whole("lovelaceada_11_501_hw.zip", "ada"),
        ];
        // Several of them don't hide the class.
        files.extend((0..4).map(|k| whole(&format!("mallet_13_50{k}_{file}"), "mallory")));
        export.put("class.zip", &pack(&files));
        let intake = export.find("class.zip");
        let names: Vec<&str> = intake.entries.iter().map(|it| &*it.name).collect();
        assert_eq!(names, ["boolebob_12", "lovelaceada_11", "mallet_13"]);
        assert_eq!(text(&intake, 0, "sphere"), "// sphere by bob");
        let told = intake.entries[2].unusable.join("; ");
        assert!(told.contains("mallet_13_503_"), "{told}");
        // A single ZIP file with such a name is refused as a whole.
        export.put("class/mallory.zip", &zip(&files));
        let told = export.find("class").entries[0].unusable.join("; ");
        assert!(told.contains("refused: `mallory.zip`"), "{told}");
    }
}

#[test]
fn a_name_that_leads_out_of_a_folder_is_not_a_platforms() {
    let name = "evil_77_assignsubmission_file_";
    assert_eq!(names::platforms(name).len(), 1);
    assert_eq!(names::platforms(&format!(r"..\..\{name}")), []);
}

fn text_of(entry: &Entry) -> String {
    let submission = entry.submission.as_ref().expect("it can be read");
    let text = submission.answers[0].text.clone().expect("it is there");
    text.rsplit(' ').next().unwrap_or_default().to_owned()
}
