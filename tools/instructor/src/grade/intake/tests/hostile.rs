//! Attacks by uploaders: names, links and archives that target other people's marks.

use super::*;

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
    assert_eq!(intake.entries[0].signs[0].number.as_deref(), Some("13"));
}

#[test]
#[cfg(unix)]
fn two_names_that_are_not_utf_8_look_different() {
    use std::os::unix::ffi::OsStrExt;
    let export = Export::new();
    for byte in [0xe9, 0xe8] {
        let name = [b"ren".as_slice(), &[byte]].concat();
        let folder = export
            .path("class")
            .join(std::ffi::OsStr::from_bytes(&name));
        fs::create_dir_all(&folder).expect("this system allows it");
        fs::write(folder.join("sphere.rs"), "// mine").expect("there is room");
    }
    let intake = export.find("class");
    let names: Vec<&str> = intake
        .entries
        .iter()
        .map(|entry| entry.name.as_str())
        .collect();
    assert_eq!(names, ["ren\\xE8", "ren\\xE9"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_replaced_by_a_link_while_it_is_read_shows_nobody_elses_answers() {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use std::sync::atomic::{AtomicBool, Ordering};

    let export = Export::new();
    export.put_all("class/ada", answers("", "ada"));
    export.put_all("class/mallory/src", answers("", "mallory"));
    let (own, link) = (
        export.path("class/mallory/src"),
        export.path("class/mallory/other"),
    );
    std::os::unix::fs::symlink(export.path("class/ada"), &link).expect("links work here");
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                let swapped = renameat_with(CWD, &own, CWD, &link, RenameFlags::EXCHANGE);
                swapped.expect("this system exchanges");
            }
        });
        for _ in 0..300 {
            let intake = export.find("class");
            let mallory = intake.entries[1]
                .submission
                .as_ref()
                .expect("it can be read");
            for answer in &mallory.answers {
                let stolen = answer.text.as_ref().is_ok_and(|text| text.ends_with("ada"));
                assert!(!stolen, "{answer:?}");
            }
        }
        done.store(true, Ordering::Relaxed);
    });
}

#[test]
fn a_hostile_name_becomes_a_plain_folder_of_its_own() {
    for name in [
        "../../etc",
        "a/b",
        "..",
        "",
        "x\u{1b}[31m",
        "<script>",
        "-rf",
        "--trust",
        "-",
        "_-rf",
    ] {
        let id = plain(name);
        assert!(
            !id.contains(['/', '\\', '<', '\u{1b}']) && !id.starts_with(['.', '-']),
            "{id}"
        );
    }
    assert_ne!(plain("a b"), plain("a?b"));
    assert_ne!(plain("rf"), plain("-rf"));
    assert_eq!(plain("alice.zip"), "alice");
    assert_eq!(plain("alice.tar.gz"), "alice");
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

#[test]
fn no_name_harms_its_readers() {
    let words = [
        "_",
        "-",
        ".",
        " ",
        "/",
        "(1)",
        "12",
        "99999999999999999999",
        "LATE",
        "assignsubmission",
        "file",
        "attempt",
        "2026-11-20-23-59-01",
        "plane",
        "Copy of ",
        "copy",
        ".rs",
        ".txt",
        ".zip",
        ".tar.gz",
        "é",
        "e\u{301}",
        "İ",
        "\u{212a}",
        "ß",
        "\u{202e}",
        "\0",
        "\u{feff}",
    ];
    let assignment = assignment();
    let mut state = 4711_u64;
    let mut below = |end: usize| {
        // Knuth, The Art of Computer Programming, 3.3.4: the constants of MMIX.
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) as usize % end
    };
    for _ in 0..20_000 {
        let count = below(9);
        let name: String = (0..count).map(|_| words[below(words.len())]).collect();
        for meant in names::platforms(&name) {
            assert!(name.contains(meant.rest), "{name:?}");
        }
        names::task_of(&name, &assignment);
        assert!(name.starts_with(reader::stem(&name)), "{name:?}");
        let id = plain(&name);
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
        assert!(
            id.chars().all(is_plain) && !id.starts_with(['.', '-']),
            "{name:?}: {id}"
        );
    }
}
