//! Archives and folders that contain too much, or that would hide other people's submissions.

use super::*;
use crate::grade::intake::reader;

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
pub fn many_answers(folder: &str) -> Files {
    let spaces = vec![b' '; 256 << 10];
    let copy = |k: usize| (format!("{folder}{k}/plane.rs"), spaces.clone());
    (0..4).map(copy).collect()
}

#[test]
fn one_person_does_not_fill_a_class_by_long_names() {
    let export = Export::new();
    // Canvas allows names of 255 characters.
    let long = "\u{20000}".repeat(248);
    let many = zip(&(0..5)
        .flat_map(|k| many_answers(&format!("{k}")))
        .collect::<Vec<_>>());
    let upload = |k: usize| (format!("malleteve_13_{}_{long}.zip", 600 + k), many.clone());
    let mut all: Vec<_> = (0..36).map(upload).collect();
    all.push(("noycebob_12_501_hw.zip".into(), zip(&answers("", "bob"))));
    all.push(("zornzed_14_502_hw.zip".into(), zip(&answers("", "bob"))));
    export.put("class.zip", &zip(&all));
    let intake = export.find("class.zip");
    let names: Vec<&str> = intake.entries.iter().map(|it| &*it.name).collect();
    assert_eq!(names, ["malleteve_13", "noycebob_12", "zornzed_14"]);
    assert_eq!(text(&intake, 1, "sphere"), "// sphere by bob");
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
        let found = reader::read(&path, &|name| name == "plane.rs", &NamePattern::default())
            .expect("it is there");
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
fn a_limit_shared_by_names_that_begin_alike_costs_nobody_points() {
    let export = Export::new();
    let many: Files = (0..5)
        .flat_map(|k| many_answers(&format!("{k}/")))
        .collect();
    // Eve calls herself `lovelaceada_77`, and the name of Ada's file contains a date.
    export.put("class/lovelaceada_77_13_501_hw.zip", &zip(&many));
    for name in ["lovelaceada_77_502_hw_2026_11_20", "noycebob_12_503_hw"] {
        let file = format!("class/{name}.zip");
        export.put(&file, &zip(&answers("", "somebody")));
    }
    let entries = export.find("class").entries;
    let is_graded: Vec<bool> = entries.iter().map(|it| it.submission.is_ok()).collect();
    assert_eq!(is_graded, [false, false, true], "{entries:?}");
}

#[test]
fn too_many_archives_in_a_folder_stop_nobody_else() {
    let export = Export::new();
    let many = zip(&many_answers(""));
    for k in 0..200 {
        export.put(&format!("hw1-eve/{k}.zip"), &many);
    }
    export.put_all("hw1-ada", answers("", "ada"));
    let paths = ["hw1-eve", "hw1-ada"].map(|name| export.path(name));
    let intake = find(&paths, &assignment(), None, None).expect("one can be read");
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
    all.extend((0..150).flat_map(large));
    all.extend(answers("zoe/", "zoe"));
    export.put("a.tar.gz", &tar_gz(&all));
    export.put("ada.zip", &zip(&answers("", "ada")));
    let read = |names: &[&str]| {
        let paths: Vec<PathBuf> = names.iter().map(|name| export.path(name)).collect();
        find(&paths, &assignment(), None, None)
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
    for name in ["a/plane.rs", "a\\plane.rs", "a/plane.RS"] {
        let name = format!("hw1/Mallory_2_assignsubmission_file/{name}");
        class.push((name, b"mine".to_vec()));
    }
    let mut bytes = zip(&class);
    for forged in [false, true] {
        if forged {
            // The library that writes archives refuses equal names.
            while let Some(at) = bytes.windows(8).position(|it| it == b"plane.RS") {
                bytes[at..at + 8].copy_from_slice(b"plane.rs");
            }
        }
        export.put("class.zip", &bytes);
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
}

#[test]
fn a_class_that_was_cut_between_two_files_or_put_together_is_refused() {
    let mut tar = tar::Builder::new(Vec::new());
    for name in ["Ada_1", "Eve_2"] {
        for (path, bytes) in answers(&format!("hw1/{name}_assignsubmission_file/"), name) {
            let mut header = tar::Header::new_ustar();
            header.set_size(bytes.len() as u64);
            let added = tar.append_data(&mut header, path, &bytes[..]);
            added.expect("memory can be written");
        }
    }
    let whole = tar.into_inner().expect("it ends");
    let export = Export::new();
    export.put("class.tar", &whole);
    export.is_of("class.tar", &["Ada_1", "Eve_2"]);
    export.put("class.tar", &whole[..whole.len() - 1024]);
    let said = format!("{:?}", export.find("class.tar").entries);
    assert!(said.contains("it ends too early"), "{said}");
    export.put("class.tar", &whole.repeat(2));
    let said = format!("{:?}", export.find("class.tar").entries);
    assert!(said.contains("comes after its end"), "{said}");
}

#[test]
fn a_folder_that_an_archive_lists_twice_refuses_nothing() {
    let mut class = answers("hw1/Ada_1_assignsubmission_file/", "ada");
    for name in ["empty/", "emptY/"] {
        class.push((
            format!("hw1/Ada_1_assignsubmission_file/{name}"),
            Vec::new(),
        ));
    }
    let mut bytes = zip(&class);
    while let Some(at) = bytes.windows(6).position(|it| it == b"emptY/") {
        bytes[at..at + 6].copy_from_slice(b"empty/");
    }
    let export = Export::new();
    export.put("class.zip", &bytes);
    let intake = export.find("class.zip");
    assert_eq!(intake.entries[0].unusable, Vec::<String>::new());
    assert_eq!(intake.entries[0].doubts, Vec::<String>::new());
}

#[test]
fn a_line_break_in_a_folders_name_hands_in_nothing_for_others() {
    let mut tar = tar::Builder::new(Vec::new());
    let mut add = |path: &str, bytes: &[u8]| {
        let path = [("path", path.as_bytes())];
        tar.append_pax_extensions(path)
            .expect("memory can be written");
        let mut header = tar::Header::new_ustar();
        header.set_size(bytes.len() as u64);
        let added = tar.append_data(&mut header, "cut", bytes);
        added.expect("memory can be written");
    };
    let [ada, eve] = ["Ada", "Eve"].map(|name| format!("hw1/{name}_1_assignsubmission_file/"));
    for (path, bytes) in [answers(&ada, "ada"), answers(&eve, "eve")].concat() {
        add(&path, &bytes);
    }
    for (theirs, bytes) in answers(&ada, "eve") {
        let record = format!(" path={theirs}");
        add(&format!("{eve}x\n{}{record}", record.len() + 3), &bytes);
    }
    let export = Export::new();
    export.put("class.tar", &tar.into_inner().expect("it ends"));
    export.is_of("class.tar", &["Ada_1", "Eve_1"]);
}
