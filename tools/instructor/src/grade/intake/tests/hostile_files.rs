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
        let found = reader::read(&export.path("ada.zip"), &|name| name.ends_with(".rs"));
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
    assert!(names::platforms(&name).len() < 260);
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
        let found = reader::read(&path, &|name| name == "plane.rs")
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

/// A ZIP file of `count` files that share one member of 256 MiB of zeros.
fn shared_zeros(count: u16) -> Vec<u8> {
    use std::io::Write;
    let (mut packed, mut sum) = (
        flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::best()),
        flate2::Crc::new(),
    );
    let zeros = vec![0; 1 << 20];
    for _ in 0..256 {
        packed.write_all(&zeros).expect("memory can be written");
        sum.update(&zeros);
    }
    let packed = packed.finish().expect("it ends");
    let common = [
        &[20, 0, 0, 0, 8, 0, 0, 0, 0x21, 0][..],
        &sum.sum().to_le_bytes(),
        &(packed.len() as u32).to_le_bytes(),
        &(256u32 << 20).to_le_bytes(),
        &[9, 0, 0, 0],
    ]
    .concat();
    let mut file = [b"PK\x03\x04", &common[..], b"x0000.zip", &packed].concat();
    let start = file.len() as u32;
    for k in 0..count {
        let name = format!("x{k:04}.zip");
        file.extend([b"PK\x01\x02\x14\0", &common[..], &[0; 14], name.as_bytes()].concat());
    }
    let size = file.len() as u32 - start;
    file.extend(b"PK\x05\x06\0\0\0\0");
    file.extend([count, count].map(u16::to_le_bytes).concat());
    file.extend([size, start].map(u32::to_le_bytes).concat());
    file.extend([0, 0]);
    file
}

#[test]
fn files_that_share_their_bytes_are_limited_together() {
    let export = Export::new();
    export.put("class/mallory.zip", &shared_zeros(20));
    export.put("class/ada.zip", &zip(&answers("", "ada")));
    let intake = export.find("class");
    let told = intake.entries[1].unusable.join("; ");
    assert!(told.contains("unpacks to more than 1 GiB"), "{told}");
    assert_eq!(intake.entries[0].unusable, Vec::<String>::new());
}

#[test]
fn nobody_leaves_too_little_to_unpack_for_the_rest_of_a_class() {
    let export = Export::new();
    let own =
        |name: &str, file: &str| format!("{name}_200{}_assignsubmission_file/{file}", name.len());
    let ada = zip(&answers("", "ada"));
    let mut class = vec![(own("Zoe Ada", "hw1.zip"), ada)];
    // Each of these unpacks to a little less than 1 GiB, and all together to more than an archive may.
    for file in ["a.zip", "b.zip", "c.zip"] {
        class.push((own("Eve Mallory", file), shared_zeros(15)));
    }
    export.put("class.zip", &zip(&class));
    let intake = export.find("class.zip");
    let [eve, zoe] = &intake.entries[..] else {
        panic!("{:?}", intake.entries)
    };
    assert!(!eve.unusable.is_empty(), "{eve:?}");
    assert_eq!(zoe.unusable, Vec::<String>::new());
    assert!(zoe.submission.is_ok(), "{zoe:?}");
}

/// Many large answers: a quarter of what is kept of one submission.
fn many_answers(folder: &str) -> Files {
    let spaces = vec![b' '; 256 << 10];
    let copy = |k: usize| (format!("{folder}{k}/plane.rs"), spaces.clone());
    (0..4).map(copy).collect()
}

#[test]
fn many_archives_of_one_person_are_limited_together() {
    let export = Export::new();
    for k in 10..30 {
        for name in [
            format!("canvas/malleteve_13_6{k}_hw.zip"),
            // This can also be read as one of Blackboard's names.
            format!("canvas/malleteve_13_7{k}_x_attempt_2026-11-20-10-00-00.zip"),
            format!("blackboard/HW_eve_attempt_2026-11-20-10-{k}-00_hw.zip"),
            format!("brightspace/1-2 - Eve Mallet - Nov 20, 2026 11{k} PM - hw.zip"),
        ] {
            export.put(&name, &zip(&many_answers("")));
        }
    }
    for name in [
        "canvas/noycebob_12_501_hw.zip",
        "canvas/zornzed_14_502_hw.zip",
        "blackboard/HW_bob_attempt_2026-11-20-10-00-00_hw.zip",
        "brightspace/1-3 - Bob Noyce - Nov 20, 2026 1159 PM - hw.zip",
    ] {
        export.put(name, &zip(&answers("", "bob")));
    }
    for (class, most) in [("canvas", 9), ("blackboard", 5), ("brightspace", 5)] {
        let path = export.path(class);
        let found = reader::read(&path, &|name| name == "plane.rs").expect("it is there");
        let texts = found.files.iter().filter_map(|it| match &it.content {
            reader::Content::Answer { text: Ok(text), .. } => Some(text.len()),
            _ => None,
        });
        let kept: usize = texts.sum();
        assert!(kept < most << 20, "{class}: {kept}");
        let intake = export.find(class);
        let others = intake.entries.iter().filter(|it| !it.name.contains("ve"));
        let others: Vec<_> = others.map(|it| it.unusable.clone()).collect();
        assert!(
            !others.is_empty() && others.concat().is_empty(),
            "{others:?}"
        );
    }
}

#[test]
fn too_many_archives_in_a_folder_stop_nobody_else() {
    let export = Export::new();
    for k in 0..100 {
        export.put(&format!("hw1-eve/{k}.zip"), &zip(&many_answers("")));
    }
    export.put_all("hw1-ada", answers("", "ada"));
    let paths = ["hw1-eve", "hw1-ada"].map(|name| export.path(name));
    let intake = find(&paths, &assignment(), None).expect("one can be read");
    assert_eq!(
        (intake.entries.len(), &*intake.entries[0].name),
        (1, "hw1-ada")
    );
    let why = "hw1-eve cannot be read as a whole";
    assert!(
        intake.ignored.iter().any(|it| it.contains(why)),
        "{:?}",
        intake.ignored
    );
}

#[test]
fn a_link_with_a_long_target_in_an_archive_hides_nobody() {
    let mut tar = tar::Builder::new(Vec::new());
    let own = |name: &str, file: &str| format!("hw1/{name}_1_assignsubmission_file/{file}");
    let mut header = tar::Header::new_gnu();
    header.set_entry_type(tar::EntryType::Symlink);
    header.set_size(0);
    let added = tar.append_link(&mut header, own("Eve", "link"), "x".repeat(200));
    added.expect("memory can be written");
    for (name, bytes) in [
        answers(&own("Eve", ""), "eve"),
        answers(&own("Zoe", ""), "zoe"),
    ]
    .concat()
    {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        let added = tar.append_data(&mut header, name, &bytes[..]);
        added.expect("memory can be written");
    }
    let export = Export::new();
    export.put("class.tar", &tar.into_inner().expect("it ends"));
    export.is_of("class.tar", &["Eve_1", "Zoe_1"]);
}

#[test]
fn nobody_exceeds_the_limits_of_a_whole_class_alone() {
    // The folder around everything is the instructor's, or nobody's.
    for around in ["", "hw1/"] {
        let export = Export::new();
        let own = |name: &str| format!("{around}{name}_1_assignsubmission_file/");
        let mut class = answers(&own("Ada"), "ada");
        for k in 0..20 {
            class.extend(many_answers(&format!("{}{k}/", own("Mallory"))));
        }
        class.extend(answers(&own("Zoe"), "zoe"));
        // Programs make these beside the folder.
        class.extend([".git/HEAD", "target/x"].map(|name| (name.into(), Vec::new())));
        for (name, bytes) in [("a.zip", zip(&class)), ("b.tar.gz", tar_gz(&class))] {
            export.put(name, &bytes);
            let intake = export.find(name);
            let [ada, mallory, zoe] = &intake.entries[..] else {
                panic!("{:?}", intake.entries)
            };
            assert!(!mallory.unusable.is_empty(), "{name}");
            for honest in [ada, zoe] {
                assert_eq!(honest.unusable, Vec::<String>::new(), "{name}");
            }
        }
    }
}

#[test]
fn what_comes_after_too_much_in_an_archive_is_not_taken_for_all_there_is() {
    let export = Export::new();
    let large = |k: usize| many_answers(&format!("mallory{k:02}/"));
    let mut all: Files = (0..6)
        .flat_map(|k| many_answers(&format!("eve/{k}/")))
        .collect();
    all.extend((0..90).flat_map(large));
    all.extend(answers("zoe/", "zoe"));
    export.put("a.tar.gz", &tar_gz(&all));
    export.put("ada.zip", &zip(&answers("", "ada")));
    let read = |names: &[&str]| {
        let paths: Vec<PathBuf> = names.iter().map(|name| export.path(name)).collect();
        find(&paths, &assignment(), None)
    };
    let error = read(&["a.tar.gz"]).expect_err("it contains too much");
    assert!(error.remedy.contains("unpack it"), "{error:?}");
    let why = error.to_string();
    assert!(why.contains("too much is in `eve`"), "{why}");
    // Others are graded.
    let intake = read(&["a.tar.gz", "ada.zip"]).expect("one can be read");
    assert_eq!(intake.entries.len(), 1);
    let why = "a.tar.gz cannot be read as a whole";
    assert!(
        intake.ignored.iter().any(|it| it.contains(why)),
        "{:?}",
        intake.ignored
    );
}

#[test]
fn two_files_with_one_path_in_an_archive_of_a_class_are_refused_alone() {
    let export = Export::new();
    let mut class = answers("hw1/Ada_1_assignsubmission_file/", "ada");
    for name in ["a/plane.rs", "a\\plane.rs"] {
        let name = format!("hw1/Mallory_2_assignsubmission_file/{name}");
        class.push((name, b"mine".to_vec()));
    }
    export.put("class.zip", &zip(&class));
    let intake = export.find("class.zip");
    let [ada, mallory] = &intake.entries[..] else {
        panic!("{:?}", intake.entries)
    };
    assert_eq!(ada.unusable, Vec::<String>::new());
    assert!(
        mallory.unusable.join("; ").contains("appears twice"),
        "{mallory:?}"
    );
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
        find(&paths, &assignment(), None)
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
