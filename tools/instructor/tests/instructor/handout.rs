//! The students' repository has everything they need and nothing they must not have, and works on
//! a machine with only Rust.

mod beside;
mod book;
#[cfg(target_os = "linux")]
mod fresh_machine;
mod secrets;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use pinhole_testing::{fresh, pinhole, root, trusted};

/// Every file of a folder, by path inside it.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).expect("it can be read").flatten() {
            let path = entry.path();
            match path.is_dir() {
                true => folders.push(path),
                false => {
                    let name = path.strip_prefix(folder).expect("it lies inside");
                    let bytes = fs::read(&path).expect("it can be read");
                    files.insert(name.to_string_lossy().into_owned(), bytes);
                }
            }
        }
    }
    files
}

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

fn handed_out(name: &str) -> PathBuf {
    handed_out_with(name, &[])
}

fn handed_out_with(name: &str, flags: &[&str]) -> PathBuf {
    let around = fresh(&trusted(), name);
    // Settings that another user may have put there. If cargo read them, it would fail.
    let settings = around.join(".cargo");
    fs::create_dir(&settings).expect("there is room");
    fs::write(settings.join("config.toml"), "[").expect("there is room");
    let out = around.join("students");
    let arguments = [&["handout", "ray_casting", "--out", plain(&out)], flags].concat();
    pinhole(&arguments).expect_code(0).expect_out("files, ");
    fs::remove_dir_all(settings).expect("it is there");
    out
}

fn sha256(bytes: &[u8]) -> String {
    use hmac_sha256::Hash;

    hex::encode(Hash::hash(bytes))
}

#[test]
fn the_answer_of_an_earlier_assignment_can_be_judged() {
    let out = fresh(&trusted(), "handout-earlier").join("students");
    let line = ["handout", "bounding_volumes", "--out", plain(&out)];
    pinhole(&line).expect_code(0);
    let folder = "golden/ray_casting";
    let here = files(&out.join(folder));
    let mut all = files(&root().join(folder));
    all.retain(|path, _| path.starts_with("probes/triangle."));
    assert!(all.len() > 10);
    assert!(
        here == all,
        "the questions about one task, and nothing else"
    );
}

#[test]
fn files_of_students_are_not_overwritten() {
    let out = handed_out("handout-force");
    let again = |force: &[&str]| {
        let arguments = [&["handout", "--out", plain(&out)], force].concat();
        pinhole(&arguments)
    };
    again(&[]).expect_code(2).expect_err("not empty");
    // Files that don't belong to the handout stay, and missing files of the handout are restored.
    fs::write(out.join("notes.txt"), "mine").expect("it can be written");
    fs::remove_file(out.join("src/lib.rs")).expect("it was written");
    again(&["--force"]).expect_code(0);
    assert_eq!(
        fs::read_to_string(out.join("notes.txt")).expect("it stays"),
        "mine"
    );
    assert!(out.join("src/lib.rs").is_file());

    let before = files(&out);
    let answer = "assignments/ray_casting/handout/src/sphere.rs";
    fs::write(out.join(answer), "// my answer").expect("it can be written");
    fs::remove_file(out.join("src/lib.rs")).expect("it was written");
    again(&["--force"]).expect_code(2).expect_err(answer);
    assert_eq!(
        fs::read(out.join(answer)).expect("it stays"),
        b"// my answer"
    );
    assert!(!out.join("src/lib.rs").is_file(), "half of it was replaced");
    assert_eq!(
        files(&out).len(),
        before.len() - 1,
        "something was left behind"
    );

    let foreign = fresh(&trusted(), "handout-foreign");
    fs::write(foreign.join("thesis.tex"), "mine").expect("it can be written");
    pinhole(&["handout", "--out", plain(&foreign), "--force"])
        .expect_code(2)
        .expect_err("is not an earlier handout of this assignment");
    let parent = out.parent().expect("it has one");
    let beside = fs::read_dir(parent).expect("it can be read").count();
    assert_eq!(beside, 1, "a folder was left beside");
}

#[test]
fn a_record_that_names_files_elsewhere_is_refused() {
    let out = handed_out("handout-record");
    let outside = out.with_file_name("precious");
    fs::write(&outside, "mine").expect("it can be written");
    let record = out.join("handout.toml");
    let text = fs::read_to_string(&record).expect("it was written");
    let hash = sha256(b"mine");
    fs::write(&record, format!("{text}\"../precious\" = \"{hash}\"\n")).expect("it can be written");
    pinhole(&["handout", "--out", plain(&out), "--force"])
        .expect_code(2)
        .expect_err("../precious lies outside the repository");
    assert!(outside.is_file());
}
