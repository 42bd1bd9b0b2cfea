//! Attacks by uploaders: archives, links and names that would harm the people or programs that read
//! them.

use super::hostile::placed;
use super::*;
use crate::grade::intake::reader;

#[test]
fn damaged_archives_do_not_harm_the_reader() {
    let export = Export::new();
    bolero::check!().for_each(|bytes| {
        export.put("ada.zip", bytes);
        let found = reader::read(
            &export.path("ada.zip"),
            &|name| name.ends_with(".rs"),
            &NamePattern::default(),
        );
        for file in found.expect("it is there").files {
            let is_plain = |part: &String| !["", ".", ".."].contains(&part.as_str());
            assert!(file.path.iter().all(is_plain), "{file:?}");
        }
    });
}

#[test]
#[cfg(unix)]
fn two_names_that_are_not_utf_8_look_different() {
    use std::os::unix::ffi::OsStrExt;
    let export = Export::new();
    // The third looks like one of the first two as it is shown.
    for end in [&[0xe9][..], &[0xe8], b"%E8"] {
        let name = [b"ren".as_slice(), end].concat();
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
    assert_eq!(names, ["ren%25E8", "ren%E8", "ren%E9"]);
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
                swapped.expect("this system can exchange files");
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
    // On Windows, these are devices, whatever follows the first dot.
    for name in [
        "CON",
        "nul",
        "Prn.txt",
        "aux.tar.gz",
        "com1.zip",
        "LPT9.rs.txt",
        "-con",
    ] {
        let id = plain(name);
        assert!(id.starts_with('_'), "{name}: {id}");
    }
    assert_ne!(plain("con"), plain("_con"));
    assert_eq!(plain("connie.zip"), "connie");
    assert_ne!(plain("a b"), plain("a?b"));
    assert_ne!(plain("rf"), plain("-rf"));
    assert_eq!(plain("alice.zip"), "alice");
    assert_eq!(plain("alice.tar.gz"), "alice");
}

#[test]
fn a_name_that_is_another_names_id_keeps_its_own_folder() {
    let export = Export::new();
    let names = ["=ada".to_owned(), plain("=ada")];
    for name in &names {
        export.put_all(&format!("class/{name}"), answers("", "somebody"));
    }
    let entries = export.find("class").entries;
    let entry = entries.iter().find(|it| it.name == names[1]);
    assert_eq!(entry.map(|it| &it.id), Some(&names[1]), "{entries:?}");
}

#[test]
fn a_name_of_thousands_of_words_is_compared_quickly() {
    let export = Export::new();
    let words = vec!["a"; 2000].join("-");
    export.put(
        "mallory.zip",
        &zip(&answers(&format!("{words}/"), "mallory")),
    );
    let people = (0..300).map(|k| format!("{k},First{k} Last{k}\n"));
    let list = format!("id,name\n{}", people.collect::<String>());
    let start = std::time::Instant::now();
    let found = placed(&export, &["mallory.zip"], &list);
    let took = start.elapsed();
    assert_eq!(found.0.entries.len(), 1);
    assert!(took < std::time::Duration::from_secs(20), "{took:?}");
}

#[test]
fn a_long_name_is_not_read_in_thousands_of_ways() {
    let name = format!("mallet_13_1_{}.rs", "1_".repeat(2000));
    assert!(names::platforms(&name).len() < 400);
    // Nor is each reading compared with the names of the answers.
    let copies = |count| format!("sphere{}.rs", " (1)".repeat(count));
    let file = |count| task_names::file_of(&copies(count), &assignment());
    assert_eq!(file(50), Some(("sphere.rs".into(), false)));
    assert_eq!(file(70), None);
}

#[test]
fn thousands_of_files_for_one_answer_make_a_short_message() {
    let export = Export::new();
    let long = "y".repeat(200);
    let file = |k: usize| (format!("{k}{long}/plane.rs"), k.to_string().into_bytes());
    let deep = |k: usize| (format!("{k}/{long}/sphere.rs"), k.to_string().into_bytes());
    let mut files: Files = (0..2000).flat_map(|k| [file(k), deep(k)]).collect();
    files.push(("x/sphere.rs".into(), b"mine".to_vec()));
    export.put("class/mallory.zip", &zip(&files));
    export.put("class/ada.zip", &zip(&answers("", "ada")));
    let intake = export.find("class");
    let mallory = &intake.entries[1];
    let told = [&mallory.unusable[..], &mallory.doubts].concat().join("; ");
    assert!(told.contains("there are 2000 files"), "{told}");
    assert!(
        told.contains("was taken as `sphere.rs` instead of"),
        "{told}"
    );
    assert!(told.len() < 4000, "{} bytes", told.len());
    files.push(("plane.rs".into(), b"mine".to_vec()));
    export.put("mallory.zip", &zip(&files));
    let doubts = export.find("mallory.zip").entries[0].doubts.join("; ");
    assert!(
        doubts.contains("other submissions may be in it"),
        "{doubts}"
    );
    assert!(doubts.len() < 4000, "{} bytes", doubts.len());
}

#[test]
fn long_names_in_an_archive_take_little_memory() {
    let export = Export::new();
    let name = format!("{}plane.rs", "a/".repeat(32_000));
    let files: Files = (0..100).map(|_| (name.clone(), Vec::new())).collect();
    let short: Files = (0..90_000)
        .map(|_| ("x/plane.rs".into(), Vec::new()))
        .collect();
    for files in [files, short] {
        export.put("class/mallory.tar.gz", &tar_gz(&files));
        let path = export.path("class");
        let found = reader::read(&path, &|name| name == "plane.rs", &NamePattern::default())
            .expect("it is there")
            .files;
        let parts: usize = found.iter().map(|it| 64 * it.path.len()).sum();
        assert!(parts < 5 << 20, "{parts}");
        let intake = export.find("class");
        assert_eq!(intake.entries.len(), 1);
        let one = &intake.entries[0];
        let told = [&one.unusable[..], &one.doubts].concat().join("; ");
        assert!(told.contains("it contains"), "{told}");
    }
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
    bolero::check!().for_each(|bytes: &[u8]| {
        let chosen = bytes
            .iter()
            .map(|byte| words[usize::from(*byte) % words.len()]);
        let name: String = chosen.collect();
        for meant in names::platforms(&name) {
            assert!(name.contains(meant.rest), "{name:?}");
        }
        task_names::file_of(&name, &assignment);
        assert!(name.starts_with(file_names::stem(&name)), "{name:?}");
        let id = plain(&name);
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
        assert!(
            id.chars().all(is_plain) && !id.starts_with(['.', '-']),
            "{name:?}: {id}"
        );
    });
}

#[cfg(target_os = "linux")]
#[test]
fn a_path_that_cannot_be_read_stops_nobody_else() {
    let export = Export::new();
    export.put_all("ada", answers("", "ada"));
    std::os::unix::fs::symlink("nowhere", export.path("bob")).expect("links work here");
    let pipe = std::process::Command::new("mkfifo")
        .arg(export.path("eve"))
        .status();
    assert!(pipe.is_ok_and(|status| status.success()));
    std::os::unix::net::UnixListener::bind(export.path("mallory")).expect("there is room");
    let find_all = move |names: &[&str]| {
        let paths: Vec<PathBuf> = names.iter().map(|name| export.path(name)).collect();
        find(&paths, &assignment(), None, None)
    };
    let (sender, results) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        for names in [
            &["bob", "ada", "eve", "mallory"][..],
            &["bob"],
            &["eve"],
            &["mallory"],
            &["ada", "zoe"],
        ] {
            let sent = sender.send(find_all(names).map_err(|error| error.problem));
            sent.expect("somebody waits for it");
        }
    });
    let next = || {
        let next = results.recv_timeout(std::time::Duration::from_secs(60));
        next.expect("it is not waited for")
    };
    let all = next().expect("one can be read");
    assert_eq!((all.entries.len(), &*all.entries[0].name), (1, "ada"));
    let reasons = [
        "bob is a link",
        "eve is neither a folder nor a regular file",
        "cannot read ",
    ];
    for why in reasons {
        let count = all.ignored.iter().filter(|it| it.contains(why)).count();
        assert_eq!(count, 1, "{why}: {:?}", all.ignored);
        assert!(next().is_err_and(|it| it.contains(why)), "{why}");
    }
    // It may be mistyped, and the path of a class.
    assert!(next().is_err_and(|it| it.contains("zoe: No such file")));
}
