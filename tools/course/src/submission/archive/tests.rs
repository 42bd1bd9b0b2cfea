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
    match Archive::open(path) {
        Ok(_) => panic!("it was accepted"),
        Err(error) => error.problem,
    }
}

/// The text of sphere.rs in the first place that has one.
fn sphere(path: &Path) -> std::result::Result<String, Unusable> {
    let mut archive = Archive::open(path).expect("a good archive");
    let places = archive.places().into_iter();
    let place = places
        .clone()
        .find(|place| archive.holds(place, "sphere.rs"));
    archive.text(&place.unwrap_or_default(), "sphere.rs")
}

/// Overwrites every occurrence of some bytes: what an attacker writes by hand.
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
        Err(Unusable::Missing),
        "which of two is anyone's guess"
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
        // What writes archives is too well behaved to make them.
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
    assert!(
        refusal(&path).contains("two files of one name"),
        "{}",
        refusal(&path)
    );
    let (_folder, path) = archive(&[("src/sphere.rs", b"// one"), ("src\\sphere.rs", b"// two")]);
    assert!(refusal(&path).contains("twice"), "{}", refusal(&path));
}

#[test]
fn names_that_differ_in_capitals_only_refuse_that_answer() {
    let (_folder, path) = archive(&[("sphere.rs", b"// one"), ("Sphere.rs", b"// two")]);
    assert!(matches!(sphere(&path), Err(Unusable::Refused(why)) if why.contains("capitals")));
}

#[test]
fn a_bomb_is_not_unpacked() {
    let zeros = vec![b' '; 64 << 20];
    let (_folder, path) = archive(&[("sphere.rs", &zeros)]);
    assert!(
        fs::metadata(&path).expect("it is there").len() < 1 << 20,
        "it is no bomb"
    );
    assert!(matches!(sphere(&path), Err(Unusable::Refused(why)) if why.contains("256 KiB")));
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
        // The mode stands in the upper half of four bytes.
        let mode = |mode: u32| (mode << 16).to_le_bytes();
        let packed = fs::read(&path).expect("it is there");
        let link = mode(0o120_777);
        if packed.windows(4).any(|window| window == link) {
            forge(&path, &link, &mode(kind));
        }
        let refused = sphere(&path);
        assert!(
            matches!(&refused, Err(Unusable::Refused(why)) if why.contains("regular")),
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
        matches!(&refused, Err(Unusable::Refused(why)) if why.contains("encrypted")),
        "{refused:?}"
    );
}

#[test]
fn what_is_no_archive_is_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.zip");
    for bytes in [&b""[..], b"PK\x05\x06", b"no archive at all", &[0; 70_000]] {
        fs::write(&path, bytes).expect("it can be written");
        assert!(refusal(&path).contains("no ZIP file"), "{}", refusal(&path));
    }
    let names: Vec<String> = (0..5001).map(|n| format!("f{n}")).collect();
    let entries: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &b""[..])).collect();
    let (_folder, path) = archive(&entries);
    assert!(
        refusal(&path).contains("more than 5000"),
        "{}",
        refusal(&path)
    );
}

/// Numbers that nobody chose (xorshift, Marsaglia 2003).
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}

#[test]
fn no_spoilt_archive_harms_its_reader() {
    let seconds = std::env::var("PINHOLE_FUZZ_SECONDS").map(|text| text.parse::<u64>());
    let seconds = seconds.map_or(1, |seconds| seconds.expect("a number of seconds"));
    let long = "let a = 1;\n".repeat(2000);
    let (folder, path) = archive(&[
        ("src/sphere.rs", b"// here"),
        ("src/plane.rs", long.as_bytes()),
        ("__MACOSX/._plane.rs", b"\0\0"),
    ]);
    let seed = fs::read(&path).expect("it is there");
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    let mut dice = Dice(now.expect("later than 1970").as_nanos() as u64 | 1);
    let start = std::time::Instant::now();
    let mut tried = 0;
    while start.elapsed().as_secs() < seconds {
        let mut bytes = seed.clone();
        for _ in 0..1 + dice.below(6) {
            let at = dice.below(bytes.len() + 1);
            match dice.below(5) {
                0 if at < bytes.len() => bytes[at] ^= 1 << dice.below(8),
                1 if at < bytes.len() => bytes[at] = dice.below(256) as u8,
                // Lengths, counts and offsets are of two and four bytes.
                2 => bytes[at..].iter_mut().take(4).for_each(|byte| *byte = 255),
                3 => drop(bytes.drain(at..(at + dice.below(32)).min(bytes.len()))),
                _ => bytes.truncate(at),
            }
        }
        fs::write(&path, &bytes).expect("it can be written");
        // What harms is found again in this file.
        if let Ok(mut archive) = Archive::open(&path) {
            for place in archive.places() {
                let text = archive.text(&place, "plane.rs");
                assert!(text.is_err() || text.is_ok_and(|text| text.len() as u64 <= MOST_BYTES));
            }
        }
        tried += 1;
    }
    println!("archive: {tried} inputs in {seconds} s");
    drop(folder);
}

#[test]
fn no_text_harms_who_looks_for_flags() {
    let mut dice = Dice(4711);
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
    for _ in 0..3000 {
        let text: String = (0..dice.below(60))
            .map(|_| words[dice.below(words.len())])
            .collect();
        super::super::flags::of_text("plane", &text);
    }
}
