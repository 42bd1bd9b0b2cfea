//! The handout has none of the files that students must not get, and the search for them works.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{files, handed_out, plain, sha256};
use pinhole_testing::{RunResult, fresh, pinhole, root, trusted};

/// The lines of the `.rs` files in a folder and below, file by file, without blank ones.
fn sources(folder: &Path) -> Vec<Vec<String>> {
    let rust = files(folder)
        .into_iter()
        .filter(|(path, _)| path.ends_with(".rs"));
    rust.map(|(_, bytes)| lines(&bytes)).collect()
}

fn lines(bytes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().map(|line| line.trim().to_owned());
    lines.filter(|line| !line.is_empty()).collect()
}

#[test]
fn a_students_repository_holds_no_answer_no_mistake_no_variant_and_at_most_20_megabytes() {
    let out = handed_out("handout-leaks");
    let given = files(&out);
    let bytes: usize = given.values().map(Vec::len).sum();
    assert!(bytes <= 20_000_000, "{bytes} bytes");
    for path in given.keys() {
        let ours = [
            "reference",
            "mistakes/",
            "variants/",
            "tools/mitsuba/",
            "tools/instructor",
            "study",
            "benches",
            "tests/cli",
        ];
        let found = ours.iter().find(|word| path.contains(*word));
        assert!(found.is_none(), "{path}");
    }

    let secrets = Secrets::of_the_course(&out);
    let told = given.iter().find_map(|(path, bytes)| {
        let told = secrets.told_by(bytes)?;
        Some(format!("{path} tells {told}"))
    });
    assert_eq!(told, None);

    // The search works in any kind of file.
    let course = root().join("assignments/ray_casting");
    for leak in [
        "reference/src/sphere.rs",
        "mistakes/sphere_near_root_only/sphere.rs",
        "variants/triangle_qr/triangle.rs",
    ] {
        let source = fs::read(course.join(leak)).unwrap_or_else(|error| panic!("{leak}: {error}"));
        assert!(secrets.told_by(&source).is_some(), "{leak} is not found");
    }
    let picture = b"\x89PNG\xff\x00let discriminant = h * h - a * k;\x00IEND";
    assert!(secrets.told_by(picture).is_some(), "not found in a picture");
}

/// Texts that no file for students may contain.
struct Secrets {
    /// Lines that are part of an answer.
    lines: Vec<String>,
    /// Two consecutive lines of a wrong answer or another right one; sorted.
    pairs: Vec<(String, String)>,
}

impl Secrets {
    /// All secrets of the course, except lines that the stubs in a student's repository show
    /// anyway.
    fn of_the_course(students: &Path) -> Secrets {
        let course = root().join("assignments/ray_casting");
        let stubs: Vec<String> =
            sources(&students.join("assignments/ray_casting/handout")).concat();
        let is_secret = |line: &str| !stubs.iter().any(|stub| stub == line);
        // Single lines of the reference: `match camera.projection {` gives nothing away, but `let
        // h = …` is part of an answer.
        let answers: Vec<String> = sources(&course.join("reference")).concat();
        let telling = |line: &&String| {
            line.len() >= 24 && !line.ends_with('{') && !line.contains("ANCHOR") && is_secret(line)
        };
        let lines: Vec<String> = answers.iter().filter(telling).cloned().collect();
        assert!(lines.len() > 20, "the search knows too little");
        // Pairs of lines, from wrong answers and other right ones.
        let mut pairs = Vec::new();
        for kind in ["reference", "mistakes", "variants"] {
            for source in sources(&course.join(kind)) {
                let two = source
                    .windows(2)
                    .filter(|two| two.iter().all(|line| is_secret(line)))
                    // The stubs also say that there are two projections.
                    .filter(|two| !two.iter().all(|line| line.starts_with("Projection::")));
                let long = two.filter(|two| two.concat().len() >= 48);
                pairs.extend(long.map(|two| (two[0].clone(), two[1].clone())));
            }
        }
        assert!(pairs.len() > 1000, "the search knows too little");
        pairs.sort();
        Secrets { lines, pairs }
    }

    /// The text in a file of any kind.
    fn told_by(&self, bytes: &[u8]) -> Option<String> {
        let text = String::from_utf8_lossy(bytes);
        if let Some(line) = self.lines.iter().find(|line| text.contains(line.as_str())) {
            return Some(line.clone());
        }
        let lines = lines(bytes);
        let both = |two: &&[String]| {
            let two = (two[0].clone(), two[1].clone());
            self.pairs.binary_search(&two).is_ok()
        };
        lines.windows(2).find(both).map(|two| two.join(" / "))
    }
}

/// A file that holds something students must not get, and the reason for its refusal.
#[test]
#[cfg(target_os = "linux")]
fn every_file_that_would_give_something_away_is_refused() {
    let folder = fresh(&trusted(), "handout-refused");
    let answer = "let discriminant = h * h - a * k;";
    let own = root().join("assignments/ray_casting/assignment.toml");
    let own = fs::read_to_string(own).expect("it is there");
    let row = "name = \"sphere_packing\"\n";
    let assignment = folder.join("assignment.toml");
    let text = own.replace(row, &format!("{row}public = false\n"));
    fs::write(&assignment, text).expect("it can be written");
    let golden = root().join("golden/ray_casting/sphere_packing.exr");
    let golden = fs::read(golden).expect("it is there");
    let hash = sha256(&golden);
    let with = |path: &str, more: &str| {
        let mut bytes = fs::read(root().join(path)).expect("it is there");
        bytes.extend_from_slice(more.as_bytes());
        bytes
    };
    let readme = "assignments/ray_casting/README.md";
    let line = "would give away a line of the reference";
    let cases: [(&str, Vec<u8>, &str); 5] = [
        (
            "src/ray.rs",
            with("src/ray.rs", &format!("// {answer}\n")),
            line,
        ),
        (
            "book/figures/id.png",
            with("book/figures/id.png", answer),
            line,
        ),
        (
            readme,
            with(readme, "\nSee `sphere_packing`.\n"),
            "the name of the withheld scene",
        ),
        (
            "book/figures/id.png",
            with("book/figures/id.png", &hash),
            "the hash of a withheld",
        ),
        ("book/figures/id.png", golden, "a file of a withheld scene"),
    ];
    for (path, bytes, why) in cases {
        let instead = folder.join("instead");
        fs::write(&instead, bytes).expect("it can be written");
        let files = [
            (
                "assignments/ray_casting/assignment.toml",
                assignment.as_path(),
            ),
            (path, instead.as_path()),
        ];
        let out = folder.join("students");
        pinhole_where(&files, &["handout", "--out", plain(&out)])
            .expect_code(2)
            .expect_err(path.rsplit('/').next().unwrap_or(path))
            .expect_err(why);
        assert!(!out.exists(), "{path}");
    }
}

/// Runs `pinhole` where some files of the checkout are replaced, without touching the
/// checkout.
#[cfg(target_os = "linux")]
fn pinhole_where(files: &[(&str, &Path)], arguments: &[&str]) -> RunResult {
    let mut walled = Command::new("bwrap");
    walled.args(["--dev-bind", "/", "/"]);
    for (path, instead) in files {
        walled.arg("--ro-bind").arg(instead).arg(root().join(path));
    }
    let output = walled
        .arg(pinhole_testing::program_of(arguments[0]))
        .args(arguments)
        .current_dir(root())
        .output()
        .expect("bubblewrap is installed");
    pinhole_testing::ran(output)
}

#[test]
#[cfg(target_os = "linux")]
fn a_handout_holds_nothing_of_a_withheld_scene_but_its_points() {
    let folder = fresh(&trusted(), "handout-withheld");
    let own = root().join("assignments/ray_casting/assignment.toml");
    let text = fs::read_to_string(own).expect("it is there");
    let row = "name = \"sphere_packing\"\n";
    assert!(text.contains(row));
    let withheld = folder.join("assignment.toml");
    let text = text.replace(row, &format!("{row}public = false\n"));
    fs::write(&withheld, text).expect("it can be written");
    let out = folder.join("students");
    let path = "assignments/ray_casting/assignment.toml";
    let ran = pinhole_where(
        &[(path, &withheld)],
        &["handout", "--out", plain(&out), "--json"],
    );
    let document = ran.expect_code(0).json();
    assert_eq!(document["withheld"], serde_json::json!(["sphere_packing"]));

    let hashes: Vec<String> = files(&root().join("golden/ray_casting"))
        .into_iter()
        .filter(|(path, _)| path.starts_with("sphere_packing"))
        .map(|(_, bytes)| sha256(&bytes))
        .collect();
    assert!(hashes.len() >= 6, "{hashes:?}");
    for (path, bytes) in files(&out) {
        assert!(!path.contains("sphere_packing"), "{path}");
        let text = String::from_utf8_lossy(&bytes);
        let is_ours = path.starts_with("src/") || path.starts_with("tools/");
        assert!(
            is_ours || !text.contains("sphere_packing"),
            "{path} names it"
        );
        let told = hashes.iter().find(|hash| text.contains(hash.as_str()));
        assert!(
            told.is_none() && !hashes.contains(&sha256(&bytes)),
            "{path} holds its hash"
        );
    }
    // Everything public is there, and up to date.
    let given = out.join(path);
    pinhole_where(
        &[(path, &given)],
        &["check", "assignments/ray_casting/reference", "--no-report"],
    )
    .expect_code(0)
    .expect_out("99 of 100 points can be earned here");
    pinhole(&["golden", "verify", plain(&out.join("golden/ray_casting"))]).expect_code(0);
}
