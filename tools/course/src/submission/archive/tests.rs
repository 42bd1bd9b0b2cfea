use std::fs;
use std::io::Write;
use std::path::PathBuf;

use zip::write::{SimpleFileOptions, ZipWriter};

use super::*;

fn archive(entries: &[(&str, &[u8])]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.zip");
    let mut zip = ZipWriter::new(fs::File::create(&path).expect("a file"));
    for (name, bytes) in entries {
        zip.start_file(*name, SimpleFileOptions::default())
            .expect("an entry");
        zip.write_all(bytes).expect("it is written");
    }
    zip.finish().expect("it ends");
    (folder, path)
}

fn refusal(path: &Path) -> String {
    match open(path) {
        Ok(_) => panic!("it was accepted"),
        Err(error) => error.problem,
    }
}

/// The text of sphere.rs in the first place that has one.
fn sphere(path: &Path) -> std::result::Result<String, AnswerFileProblem> {
    let mut archive = open(path).expect("a good archive");
    let places = archive.places().into_iter();
    let place = places
        .clone()
        .find(|place| archive.holds(&format!("{place}sphere.rs")));
    archive.text(&format!("{}sphere.rs", place.unwrap_or_default()))
}

/// Overwrites every occurrence of some bytes, as an attacker might.
fn forge(path: &Path, from: &[u8], to: &[u8]) {
    assert_eq!(from.len(), to.len());
    let mut bytes = fs::read(path).expect("it is there");
    let places: Vec<usize> = bytes
        .windows(from.len())
        .enumerate()
        .filter(|(_, window)| *window == from)
        .map(|(at, _)| at)
        .collect();
    assert!(!places.is_empty(), "nothing to forge");
    for at in places {
        bytes[at..at + to.len()].copy_from_slice(to);
    }
    fs::write(path, bytes).expect("it can be written");
}

#[test]
fn answers_are_found_in_the_same_places_as_in_a_folder() {
    for name in [
        "sphere.rs",
        "src/sphere.rs",
        "mine/sphere.rs",
        "mine/src/sphere.rs",
        "mine\\src\\sphere.rs",
    ] {
        let (_folder, path) = archive(&[(name, b"// here"), ("__MACOSX/x", b""), (".git/x", b"")]);
        assert_eq!(sphere(&path), Ok("// here".into()), "{name}");
    }
    let (_folder, path) = archive(&[("a/sphere.rs", b""), ("b/sphere.rs", b"")]);
    assert_eq!(
        sphere(&path),
        Err(AnswerFileProblem::Missing),
        "with two folders, the right one is unknown"
    );
}

#[test]
fn paths_that_lead_elsewhere_refuse_the_whole_archive() {
    for (name, why) in [
        ("/sphere.rs", "absolute"),
        ("\\sphere.rs", "absolute"),
        ("C:/sphere.rs", "absolute"),
        ("../sphere.rs", "leads out"),
        ("src/../../sphere.rs", "leads out"),
        ("src\\..\\..\\sphere.rs", "leads out"),
    ] {
        // The library that writes archives refuses such names, so we forge them afterwards.
        let plain: String = name.chars().map(|_| 'x').collect();
        let (_folder, path) = archive(&[(&plain, b"")]);
        forge(&path, plain.as_bytes(), name.as_bytes());
        assert!(refusal(&path).contains(why), "{name}: {}", refusal(&path));
    }
    let (_folder, path) = archive(&[("sphereXrs", b"")]);
    forge(&path, b"sphereXrs", b"sphere\0rs");
    assert!(refusal(&path).contains("NUL"), "{}", refusal(&path));
}

#[test]
fn two_files_of_one_name_refuse_the_whole_archive() {
    let (_folder, path) = archive(&[("sphere.rs", b"// one"), ("spherX.rs", b"// two")]);
    forge(&path, b"spherX.rs", b"sphere.rs");
    assert!(refusal(&path).contains("twice"), "{}", refusal(&path));
    let (_folder, path) = archive(&[("src/sphere.rs", b"// one"), ("src\\sphere.rs", b"// two")]);
    assert!(refusal(&path).contains("twice"), "{}", refusal(&path));
}

#[test]
fn an_archive_at_the_end_of_another_file_is_refused() {
    let (_folder, path) = archive(&[("sphere.rs", b"// one")]);
    assert!(sphere(&path).is_ok());
    let bytes = fs::read(&path).expect("it is there");
    fs::write(&path, [b"the rest of a class", &bytes[..]].concat()).expect("there is room");
    assert!(
        refusal(&path).contains("comes before"),
        "{}",
        refusal(&path)
    );
}

#[test]
fn names_that_differ_in_capitals_only_refuse_that_answer() {
    let (_folder, path) = archive(&[("sphere.rs", b"// one"), ("Sphere.rs", b"// two")]);
    assert!(
        matches!(sphere(&path), Err(AnswerFileProblem::Refused(why)) if why.contains("upper and lower case"))
    );
}

#[test]
fn zip_bomb_is_not_unpacked() {
    let zeros = vec![b' '; 64 << 20];
    let (_folder, path) = archive(&[("sphere.rs", &zeros)]);
    assert!(
        fs::metadata(&path).expect("it is there").len() < 1 << 20,
        "it is not a bomb"
    );
    assert!(
        matches!(sphere(&path), Err(AnswerFileProblem::Refused(why)) if why.contains("256 KiB"))
    );
}

#[test]
fn links_devices_and_passwords_are_refused() {
    for kind in [0o120_777, 0o020_666, 0o010_666, 0o060_666] {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.zip");
        let mut zip = ZipWriter::new(fs::File::create(&path).expect("a file"));
        zip.add_symlink("sphere.rs", "/etc/passwd", SimpleFileOptions::default())
            .expect("an entry");
        zip.finish().expect("it ends");
        // The mode is in the upper half of four bytes.
        let mode = |mode: u32| (mode << 16).to_le_bytes();
        let packed = fs::read(&path).expect("it is there");
        let link = mode(0o120_777);
        if packed.windows(4).any(|window| window == link) {
            forge(&path, &link, &mode(kind));
        }
        let refused = sphere(&path);
        assert!(
            matches!(&refused, Err(AnswerFileProblem::Refused(why)) if why.contains("regular")),
            "{refused:?}"
        );
    }
    let (_folder, path) = archive(&[("sphere.rs", b"// here")]);
    // The flags follow the signature of an entry of the central directory by eight bytes.
    let mut bytes = fs::read(&path).expect("it is there");
    let central = bytes
        .windows(4)
        .position(|window| window == b"PK\x01\x02")
        .expect("a directory");
    bytes[central + 8] |= 1;
    fs::write(&path, bytes).expect("it can be written");
    let refused = sphere(&path);
    assert!(
        matches!(&refused, Err(AnswerFileProblem::Refused(why)) if why.contains("encrypted")),
        "{refused:?}"
    );
}

#[test]
fn file_that_is_not_an_archive_is_refused_with_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.zip");
    fs::write(&path, "").expect("it can be written");
    assert!(refusal(&path).ends_with("it is empty"));
    for bytes in [&b"PK\x05\x06"[..], b"no archive at all", &[0; 70_000]] {
        fs::write(&path, bytes).expect("it can be written");
        assert!(
            refusal(&path).contains("not a ZIP file"),
            "{}",
            refusal(&path)
        );
    }
}

/// An archive with nothing but a list of contents: one local entry, and an entry for each of
/// `names` that points at it.
fn listing(names: impl Iterator<Item = Vec<u8>>) -> Vec<u8> {
    let (mut bytes, mut list, mut count) = (Vec::new(), Vec::new(), 0_u16);
    for name in names {
        let length = (name.len() as u16).to_le_bytes();
        if count == 0 {
            bytes.extend(b"PK\x03\x04\x14\0");
            bytes.extend([0; 20]);
            bytes.extend(length);
            bytes.extend([0; 2]);
            bytes.extend(&name);
        }
        list.extend(b"PK\x01\x02\x14\0\x14\0");
        list.extend([0; 20]);
        list.extend(length);
        list.extend([0; 16]);
        list.extend(name);
        count += 1;
    }
    let start = (bytes.len() as u32).to_le_bytes();
    bytes.extend(&list);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
    bytes.extend((list.len() as u32).to_le_bytes());
    bytes.extend(start);
    bytes.extend([0; 2]);
    bytes
}

/// The most memory that this process has used so far, in KiB.
#[cfg(target_os = "linux")]
fn peak_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").expect("Linux has it");
    let line = status.lines().find(|line| line.starts_with("VmHWM"));
    let number = line.and_then(|line| line.split_whitespace().nth(1));
    number.and_then(|text| text.parse().ok()).expect("a number")
}

#[test]
#[cfg(target_os = "linux")]
fn names_of_thousands_of_folders_do_not_fill_the_memory() {
    let names = (0..4990).map(|k| [b"a/".repeat(1640), k.to_string().into_bytes()].concat());
    let bytes = listing(names);
    let before = peak_memory();
    let archive = Archive::new(Cursor::new(bytes), MOST_READ).map_err(drop);
    assert_eq!(archive.map(|archive| archive.files().count()), Ok(4990));
    let grown = (peak_memory() - before) / 1024;
    assert!(grown < 250, "{grown} MiB more");
}

#[test]
fn damaged_archives_do_not_harm_the_reader() {
    bolero::check!().for_each(|bytes| {
        let Ok(mut archive) = Archive::new(Cursor::new(bytes), MOST_READ) else {
            return;
        };
        for place in archive.places() {
            let text = archive.text(&format!("{place}plane.rs"));
            assert!(text.is_err() || text.is_ok_and(|text| text.len() as u64 <= MOST_BYTES));
        }
    });
}

#[test]
fn no_text_harms_the_search_for_flags() {
    let words = [
        "unsafe",
        "use",
        "std",
        "::",
        "fs",
        "{",
        "}",
        "(",
        ")",
        "include_str",
        "!",
        "\"",
        "'",
        "r#",
        "/*",
        "*/",
        "//",
        "\n",
        "#",
        "[",
        "]",
        "b\"",
        "\\",
        "1e9",
        "é",
        "\u{feff}",
        "mod",
        ";",
        "*",
    ];
    bolero::check!().for_each(|bytes: &[u8]| {
        let chosen = bytes
            .iter()
            .map(|byte| words[usize::from(*byte) % words.len()]);
        super::super::flags::of_text("plane", &chosen.collect::<String>());
    });
}

#[test]
fn accents_are_read_as_windows_writes_them_and_as_others_do() {
    for (plain, bytes) in [
        ("Zo_ M_ller", &b"Zo\x89 M\x81ller"[..]),
        ("Zo__ M__ller", "Zoë Müller".as_bytes()),
    ] {
        let (_folder, path) = archive(&[(&format!("{plain}/sphere.rs"), b"// mine")]);
        forge(&path, plain.as_bytes(), bytes);
        let archive = open(&path).expect("a good archive");
        assert!(archive.holds("Zoë Müller/sphere.rs"), "{plain}");
    }
}
