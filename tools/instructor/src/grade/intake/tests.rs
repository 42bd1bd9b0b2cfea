//! Submissions as platforms export them and as people pack them.

mod archives;
mod clones;
mod hostile;
mod hostile_files;
mod platforms;

use std::fs;

use pinhole_course::checkout::Checkout;
use pinhole_testing::{TASKS, root, zip};

use super::*;

fn assignment() -> Assignment {
    let checkout = Checkout::at(&root());
    Assignment::read(&checkout, "ray_casting").expect("it is committed")
}

/// A folder as someone has downloaded it.
struct Export(tempfile::TempDir);

/// Files of an archive, by name.
type Files = Vec<(String, Vec<u8>)>;

/// All answers in a folder. Each names its author.
fn answers(folder: &str, whose: &str) -> Files {
    let file = |task: &&str| {
        let text = format!("// {task} by {whose}");
        (format!("{folder}{task}.rs"), text.into_bytes())
    };
    TASKS.iter().map(file).collect()
}

fn tar_gz(files: &Files) -> Vec<u8> {
    let packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    let mut tar = tar::Builder::new(packed);
    for (name, bytes) in files {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(0o644);
        tar.append_data(&mut header, name, &bytes[..])
            .expect("memory can be written");
    }
    tar.into_inner()
        .and_then(|packed| packed.finish())
        .expect("it ends")
}

impl Export {
    fn new() -> Export {
        Export(tempfile::tempdir().expect("there is room"))
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, bytes: &[u8]) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("it has one")).expect("there is room");
        fs::write(path, bytes).expect("there is room");
    }

    fn put_all(&self, folder: &str, files: Files) {
        fs::create_dir_all(self.path(folder)).expect("there is room");
        for (name, bytes) in files {
            self.put(&format!("{folder}/{name}"), &bytes);
        }
    }

    fn find(&self, name: &str) -> Intake {
        find(&[self.path(name)], &assignment(), None, None).expect("it can be read")
    }

    /// Checks whose submissions were found, and that each contains all answers of that person and
    /// nobody else's.
    #[track_caller]
    fn is_of(&self, name: &str, who: &[&str]) -> Intake {
        let intake = self.find(name);
        let names: Vec<&str> = intake
            .entries
            .iter()
            .map(|entry| entry.name.as_str())
            .collect();
        assert_eq!(names, who, "{intake:#?}");
        for entry in &intake.entries {
            assert_eq!(entry.unusable, Vec::<String>::new(), "{entry:#?}");
            let submission = entry.submission.as_ref().expect("it can be read");
            let texts = submission.answers.iter().map(|answer| answer.text.clone());
            let whose: BTreeSet<String> = texts
                .map(|text| {
                    text.expect("it is there")
                        .rsplit(' ')
                        .next()
                        .unwrap_or("")
                        .into()
                })
                .collect();
            assert_eq!(whose.len(), 1, "{whose:?}");
        }
        intake
    }
}

#[track_caller]
fn text(intake: &Intake, entry: usize, task: &str) -> String {
    let submission = intake.entries[entry]
        .submission
        .as_ref()
        .expect("it can be read");
    let answer = submission.answer(task).expect("it is a task");
    answer.text.clone().expect("it is there")
}

#[test]
fn a_class_folder_with_archives_and_one_unpacked_folder_is_a_class() {
    let export = Export::new();
    export.put("class/bob.zip", &zip(&answers("", "bob")));
    export.put("class/cleo.zip", &zip(&answers("homework/src/", "cleo")));
    export.put_all("class/ada", answers("", "ada"));
    export.is_of("class", &["ada", "bob.zip", "cleo.zip"]);
}

#[test]
fn a_class_folder_with_a_single_students_folder_is_a_class_of_one() {
    let export = Export::new();
    export.put_all("class/ada", answers("src/", "ada"));
    export.is_of("class", &["ada"]);
    // A submission that is named on the command line keeps its own name.
    export.is_of("class/ada", &["ada"]);
}

#[test]
fn archives_in_the_folders_of_moodle_are_opened() {
    let export = Export::new();
    let folder = "class/Ada Lovelace_2001_assignsubmission_file";
    export.put(&format!("{folder}/hw1.zip"), &zip(&answers("hw1/", "ada")));
    export.put_all(
        "class/Zoë Müller_2002_assignsubmission_file_",
        answers("", "zoe"),
    );
    let flat = "class/Bob Bobson_2003_assignsubmission_file_hw1.zip";
    export.put(flat, &zip(&answers("", "bob")));
    let all = ["Ada Lovelace_2001", "Bob Bobson_2003", "Zoë Müller_2002"];
    export.is_of("class", &all);
}

#[test]
fn loose_files_of_canvas_are_put_together_for_each_account() {
    let export = Export::new();
    for (k, (name, bytes)) in answers("", "yangyu").into_iter().enumerate() {
        export.put(&format!("class/yangyu_1025_{}_{name}", 99_001 + k), &bytes);
    }
    // Canvas marks late files, and files that were handed in again.
    for (k, (name, bytes)) in answers("", "ada").into_iter().enumerate() {
        let name = name.replace(".rs", "-1.rs");
        export.put(
            &format!("class/lovelaceada_LATE_11_{}_{name}", 98_001 + k),
            &bytes,
        );
    }
    export.put(
        "class/lovelaceada_11_97000_sphere.rs",
        b"// the first attempt",
    );
    let intake = export.is_of("class", &["lovelaceada_11", "yangyu_1025"]);
    assert_eq!(text(&intake, 0, "sphere"), "// sphere by ada");
    let note = "sphere.rs: the newest upload was taken, which differs from an earlier one";
    assert_eq!(intake.entries[0].notes.last().expect("a note"), note);
}

#[test]
fn the_newest_archive_of_an_account_counts_and_the_others_are_listed() {
    let export = Export::new();
    export.put("class/lovelaceada_11_501_a.zip", &zip(&answers("", "old")));
    export.put(
        "class/lovelaceada_LATE_11_1010_a-1.zip",
        &zip(&answers("", "new")),
    );
    let intake = export.is_of("class", &["lovelaceada_11"]);
    assert_eq!(text(&intake, 0, "plane"), "// plane by new");
    assert_eq!(
        intake.superseded["lovelaceada_11_501_a.zip"],
        "lovelaceada_11"
    );
}

#[test]
fn a_clone_or_the_whole_handout_is_read_where_students_write() {
    let export = Export::new();
    let clone = |whole: &str| {
        let layout = format!("{whole}assignments/ray_casting/handout/src/");
        let mut files = answers(&layout, "ada");
        // Files with the same names that are not the student's.
        files.extend(answers(
            &format!("{whole}assignments/ray_casting/stubs/src/"),
            "us",
        ));
        files.push((
            format!("{whole}src/shape/sphere.rs"),
            b"// the harness".to_vec(),
        ));
        files.push((format!("{whole}.git/config"), b"".to_vec()));
        files.push((
            format!("{whole}target/debug/sphere.rs"),
            b"// built".to_vec(),
        ));
        files
    };
    export.put_all("class/hw1-ada", clone(""));
    export.put("class/bob.zip", &zip(&clone("pinhole-main/")));
    export.put("class/cleo.zip", &zip(&answers("handout/src/", "cleo")));
    export.is_of("class", &["bob.zip", "cleo.zip", "hw1-ada"]);
    export.is_of("class/hw1-ada", &["hw1-ada"]);
    // If the student's own file is missing, no other file with that name is judged instead.
    fs::remove_file(export.path("class/hw1-ada/assignments/ray_casting/handout/src/sphere.rs"))
        .expect("it was there");
    let intake = export.find("class/hw1-ada");
    assert_eq!(intake.entries[0].unusable, ["sphere.rs is missing"]);
}

#[test]
fn an_answer_of_an_earlier_assignment_is_read_from_the_folder_of_this_one() {
    let checkout = Checkout::at(&root());
    let assignment = Assignment::read(&checkout, "bounding_volumes").expect("it is committed");
    let export = Export::new();
    let folder = |name: &str| format!("assignments/{name}/handout/src/");
    let given = assignment.handout().join("src/triangle.rs");
    let given = fs::read(given).expect("it is committed");
    let mut clone = answers(&folder("ray_casting"), "ada");
    clone.push((
        folder("bounding_volumes") + "ray_box.rs",
        b"// box".to_vec(),
    ));
    clone.push((folder("bounding_volumes") + "triangle.rs", given));
    export.put_all("class/ada", clone);
    export.put("class/bob/ray_box.rs", b"// box");
    export.put("class/bob/triangle.rs", b"// by bob");
    let intake = super::find(&[export.path("class")], &assignment, None, None).expect("a class");
    let earlier = intake.entries.iter().map(|entry| {
        let submission = entry.submission.as_ref().expect("it was read");
        let answer = submission.answer("triangle");
        answer.and_then(|answer| answer.text.as_deref().ok())
    });
    assert_eq!(earlier.collect::<Vec<_>>(), [None, Some("// by bob")]);
    let doubts = |entry: &Entry| entry.doubts.clone();
    assert!(intake.entries.iter().flat_map(doubts).next().is_none());
}

#[test]
fn answers_are_questioned_if_other_files_may_be_meant() {
    let stub = |task: &str| {
        let file = format!("assignments/ray_casting/handout/src/{task}.rs");
        let text = fs::read(root().join(&file)).expect("it is committed");
        (file, text)
    };
    let export = Export::new();
    let mut clone: Files = TASKS.iter().map(|task| stub(task)).collect();
    clone.push(("src/shape/sphere.rs".into(), b"// the harness".to_vec()));
    export.put_all("class/ada", clone.clone());
    export.put_all("class/bob", clone);
    export.put("class/bob/src/sphere.rs", b"// by bob");
    export.put("class/cleo/plane.rs", &stub("plane").1);
    export.put("class/cleo/plane_final.rs", b"// by cleo");
    export.put("class/dan/plane_final.rs", b"// by dan");
    export.put("class/dan/sphere.rs", b"// by dan");
    // The handed-out repository has the stubs a second time.
    let handed_out = |(file, text): (String, Vec<u8>)| (file.replace("handout", "stubs"), text);
    export.put_all("class/eve", TASKS.map(stub).map(handed_out).into());
    export.put_all(
        "class/eve",
        answers("assignments/ray_casting/handout/src/", "eve"),
    );
    let intake = export.find("class");
    let doubts: Vec<_> = intake.entries.iter().map(|it| &it.doubts[..]).collect();
    let bob = "the files in `handout/src` were taken instead of `src/sphere.rs`".to_owned();
    let cleo = "`plane.rs` is the stub, unchanged; is `plane_final.rs` meant?".to_owned();
    let dan = "`plane.rs` is missing; is `plane_final.rs` meant?".to_owned();
    assert_eq!(doubts, [&[][..], &[bob], &[cleo], &[dan], &[]]);
}

#[test]
fn answers_in_deep_folders_are_found_and_duplicates_are_reported() {
    let export = Export::new();
    export.put_all(
        "class/ada",
        answers("My Documents/CG/homework 1/src/", "ada"),
    );
    export.put("class/bob.zip", &zip(&answers("a/b/c/", "bob")));
    export.is_of("class", &["ada", "bob.zip"]);
    export.put("class/cleo/one/sphere.rs", b"// one");
    export.put("class/cleo/two/sphere.rs", b"// two");
    export.put("class/cleo/plane.rs", b"// plane");
    export.put("class/cleo/old/plane.rs", b"// an older one");
    let intake = export.find("class");
    let cleo = &intake.entries[2];
    let told = &cleo.unusable[1];
    assert!(
        told.contains("2 files that could be `sphere.rs`"),
        "{cleo:#?}"
    );
    assert!(
        told.contains("`one/sphere.rs`, `two/sphere.rs`"),
        "{cleo:#?}"
    );
    assert_eq!(
        cleo.doubts,
        ["`plane.rs` was taken instead of `old/plane.rs`"]
    );
    assert_eq!(text(&intake, 2, "plane"), "// plane");
}

#[test]
fn files_with_changed_names_are_read_with_a_note() {
    let export = Export::new();
    let mut files = answers("", "ada");
    files[0].0 = "Viewing_Ray.rs".into();
    files[1].0 = "sphere (1).rs".into();
    files[2].0 = "plane.RS".into();
    export.put_all("class/ada", files);
    let intake = export.is_of("class", &["ada"]);
    let notes = &intake.entries[0].notes;
    assert_eq!(notes.len(), 3, "{notes:?}");
    assert_eq!(notes[1], "`sphere (1).rs` was taken as `sphere.rs`");
    assert!(intake.entries[0].doubts.is_empty());
    // If the right name is there too, the instructor should check which file is meant.
    export.put("class/ada/sphere.rs", b"// sphere by ada, again");
    let intake = export.find("class");
    assert_eq!(text(&intake, 0, "sphere"), "// sphere by ada, again");
    assert_eq!(intake.entries[0].doubts.len(), 1);
}

#[test]
fn the_whole_download_of_a_platform_is_unpacked() {
    let export = Export::new();
    let canvas = |wrapper: &str| {
        let mut all: Files = Vec::new();
        let own = zip(&answers("", "ada"));
        all.push((format!("{wrapper}lovelaceada_11_501_hw1.zip"), own));
        for (k, (name, bytes)) in answers("", "bob").into_iter().enumerate() {
            all.push((format!("{wrapper}bobsonbob_12_{}_{name}", 601 + k), bytes));
        }
        let own = tar_gz(&answers("hw1/src/", "cleo"));
        all.push((format!("{wrapper}cleocleo_13_701_hw1.tar.gz"), own));
        all
    };
    let all = ["bobsonbob_12", "cleocleo_13", "lovelaceada_11"];
    export.put("submissions.zip", &zip(&canvas("")));
    export.is_of("submissions.zip", &all);
    export.put("again.zip", &zip(&canvas("submissions/")));
    export.is_of("again.zip", &all);
    let mut typed = canvas("");
    typed.push(("dodandan_14_text.html".into(), Vec::new()));
    export.put("typed.zip", &zip(&typed));
    let intake = export.find("typed.zip");
    assert_eq!(intake.entries.len(), 4, "{intake:#?}");
    assert_eq!(
        intake.entries[2].doubts,
        ["no answer file was handed in, only `text.html`"]
    );
    let mut moodle = answers("Ada Lovelace_2001_assignsubmission_file/", "ada");
    moodle.extend(answers("Bob Bobson_2002_assignsubmission_file/", "bob"));
    export.put("CG-hw1-4711.zip", &zip(&moodle));
    export.is_of("CG-hw1-4711.zip", &["Ada Lovelace_2001", "Bob Bobson_2002"]);
    // One name that is not as expected doesn't make the class one submission.
    let other = "Default group_assignsubmission_file";
    moodle.extend(answers(&format!("{other}/"), "cleo"));
    export.put("CG-hw1-4712.zip", &zip(&moodle));
    let all = ["Ada Lovelace_2001", "Bob Bobson_2002", other];
    export.is_of("CG-hw1-4712.zip", &all);
}

#[test]
fn the_whole_download_of_brightspace_has_a_list_beside_folders_and_files() {
    let export = Export::new();
    for wrapper in ["", "Homework 1 Download Nov 24, 2026 900 AM/"] {
        let ada = format!("{wrapper}11-22 - Ada Lovelace - Nov 20, 2026 1158 PM");
        let bob = format!("{wrapper}12-22 - Bob Bobson - Nov 21, 2026 1205 AM");
        let all = [
            (format!("{wrapper}index.html"), b"<html>".to_vec()),
            (format!("{ada}/hw1.zip"), zip(&answers("", "ada"))),
            (format!("{bob} - hw1.zip"), zip(&answers("", "bob"))),
        ];
        export.put("Homework 1 Download.zip", &zip(&all));
        let names = [
            "11-22 - Ada Lovelace - Nov 20, 2026 1158 PM",
            "12-22 - Bob Bobson - Nov 21, 2026 1205 AM",
        ];
        let intake = export.is_of("Homework 1 Download.zip", &names);
        assert_eq!(intake.ignored, [""; 0]);
    }
}

#[test]
fn only_answers_count_against_the_limits_of_an_archive() {
    let export = Export::new();
    let mut files = answers("hw1/src/", "ada");
    let mut noise: u64 = 1;
    let big = std::iter::repeat_with(|| {
        noise = noise
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (noise >> 56) as u8
    });
    let big: Vec<u8> = big.take(20 << 20).collect();
    files.push(("hw1/target/debug/libray_casting.rlib".into(), big));
    export.put("class/ada.zip", &zip(&files));
    export.put("class/bob.tar.gz", &tar_gz(&files));
    let long = "very/deep/".repeat(20);
    let long = answers(&format!("{long}src/"), "cleo");
    export.put("class/cleo.tgz", &tar_gz(&long));
    export.is_of("class", &["ada.zip", "bob.tar.gz", "cleo.tgz"]);
}

#[test]
fn utf_16_is_read_and_other_encodings_are_reported() {
    let export = Export::new();
    let mut files = answers("", "ada");
    let text = String::from_utf8(files[1].1.clone()).expect("it is text");
    let units = text.encode_utf16().flat_map(u16::to_le_bytes);
    let units: Vec<u8> = units.collect();
    for mark in [b"\xff\xfe".as_slice(), b""] {
        files[1].1 = [mark, &units].concat();
        export.put_all("class/ada", files.clone());
        let intake = export.is_of("class", &["ada"]);
        assert_eq!(
            intake.entries[0].notes,
            ["`sphere.rs` was in UTF-16, and was converted to UTF-8"]
        );
    }
    export.put("class/ada/plane.rs", b"// caf\xe9");
    let intake = export.find("class");
    assert_eq!(
        intake.entries[0].unusable,
        ["plane.rs is refused: it is not UTF-8 text"]
    );
}

#[test]
fn files_that_cannot_be_opened_are_listed() {
    let export = Export::new();
    export.put("class/ada.rar", b"Rar!");
    export.put("class/bob.zip", b"PK no archive");
    export.put("class/empty.zip", &zip(&Vec::new()));
    export.put(
        "class/essay.zip",
        &zip(&[("essay.docx".into(), Vec::new())]),
    );
    export.put("class/notes.txt", b"mine");
    export.put("class/sphere.rs", b"// whose?");
    fs::create_dir_all(export.path("class/nothing")).expect("there is room");
    export.put_all("class/.hidden", answers("", "nobody"));
    export.put("class/.DS_Store", b"");
    export.put("class/.gitignore", b"");
    let intake = export.find("class");
    let told = |name: &str| {
        let entry = intake.entries.iter().find(|entry| entry.name == name);
        let entry = entry.unwrap_or_else(|| panic!("no {name}: {intake:#?}"));
        (entry.unusable.join("; "), entry.doubts.join("; "))
    };
    assert!(told("ada.rar").0.contains("ask for a ZIP file"));
    let bob = told("bob.zip").0;
    assert!(bob.contains("first_hit.rs are refused: "), "{bob}");
    assert_eq!(bob.matches("not a ZIP file").count(), 1, "{bob}");
    let all = "viewing_ray.rs, sphere.rs, plane.rs, triangle.rs, triangle_soup.rs, first_hit.rs";
    assert_eq!(told("empty.zip").0, format!("{all} are missing"));
    assert!(
        told("essay.zip").1.contains("only `essay.docx`"),
        "{intake:#?}"
    );
    assert_eq!(told("nothing").0, format!("{all} are missing"));
    assert_eq!(intake.ignored, [".hidden/", "notes.txt", "sphere.rs"]);
    assert_eq!(intake.entries.len(), 5);
}

#[test]
fn an_empty_archive_in_a_platforms_download_is_somebodys_submission() {
    let export = Export::new();
    let empty = |name: &str| (name.to_owned(), zip(&Vec::new()));
    let mut moodle = answers("Ada Lovelace_2001_assignsubmission_file/", "ada");
    moodle.push(empty("Bob Bobson_2002_assignsubmission_file/answers.zip"));
    export.put("CG-hw1-4711.zip", &zip(&moodle));
    let intake = export.find("CG-hw1-4711.zip");
    let names = intake.entries.iter().map(|entry| entry.name.as_str());
    assert_eq!(
        names.collect::<Vec<_>>(),
        ["Ada Lovelace_2001", "Bob Bobson_2002"]
    );
    assert_eq!(intake.entries[0].doubts, [""; 0]);
    assert_eq!(
        intake.entries[1].doubts,
        ["no answer file was handed in, only `answers.zip`"]
    );
}

#[cfg(unix)]
#[test]
fn a_link_is_no_submission() {
    let folder = tempfile::tempdir().expect("there is room");
    let [own, link] = ["1001", "1002"].map(|name| folder.path().join(name));
    fs::create_dir(&own).expect("there is room");
    fs::write(own.join("sphere.rs"), "").expect("there is room");
    std::os::unix::fs::symlink("1001", &link).expect("there is room");
    // Even if it becomes a link only while it is read.
    assert_eq!(name(&link), "1002");
    let linked = [link.clone(), link.join("")];
    for path in &linked {
        let refused = find(std::slice::from_ref(path), &assignment(), None, None);
        assert!(
            refused.is_err_and(|it| it.problem.contains("is a link")),
            "{path:?}"
        );
    }
    let [_, slash] = linked;
    let found = find(&[own, slash], &assignment(), None, None).expect("one is a folder");
    assert_eq!((found.entries.len(), found.ignored.len()), (1, 1));
}
