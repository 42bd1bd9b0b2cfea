//! Runs the real programs on the real course, for the tests of every package.

pub mod documented_commands;

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, PoisonError};

use serde_json::Value;

/// The six tasks, in the assignment's order.
pub const TASKS: [&str; 6] = [
    "viewing_ray",
    "sphere",
    "plane",
    "triangle",
    "triangle_soup",
    "first_hit",
];

/// The top of the checkout.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()
        .expect("the checkout exists")
}

/// The result of a run of a program.
pub struct RunResult {
    /// The exit code.
    pub code: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

/// Runs `pinhole` at the top of the checkout.
pub fn pinhole(arguments: &[&str]) -> RunResult {
    pinhole_in(&root(), arguments)
}

/// Subcommands whose program is started directly and not through `pinhole`.
const OF_INSTRUCTORS: [&str; 5] = ["golden", "grade", "handout", "merge", "validate"];

/// The program with this subcommand.
pub fn program_of(subcommand: &str) -> PathBuf {
    match OF_INSTRUCTORS.contains(&subcommand) {
        true => built("pinhole-instructor", "pinhole-instructor"),
        false => built("pinhole-cli", "pinhole"),
    }
}

/// A program of the course, built as users build it, or with the tests' profile if that has debug
/// assertions.
fn built(package: &str, name: &str) -> PathBuf {
    let (options, folder): (&[&str], _) = match cfg!(debug_assertions) {
        true => (&[], "debug"),
        false => (&["--release"], "release"),
    };
    static BUILT: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if built.insert(package.into()) {
        let status = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()))
            .args(["build", "--quiet", "--package", package])
            .args(options)
            .current_dir(root())
            .status()
            .expect("cargo starts");
        assert!(status.success(), "{package} does not build");
    }
    let test = std::env::current_exe().expect("a test is a file");
    let target = test.ancestors().nth(3).expect("it lies in `PROFILE/deps`");
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    target.join(folder).join(file)
}

/// Runs `pinhole` in a folder.
pub fn pinhole_in(folder: &Path, arguments: &[&str]) -> RunResult {
    let mut command = Command::new(program_of(arguments[0]));
    ran(command
        .current_dir(folder)
        .args(arguments)
        .output()
        .expect("pinhole starts"))
}

/// Runs `pinhole` at the top of the checkout with additional environment variables.
pub fn pinhole_with(environment: &[(&str, &str)], arguments: &[&str]) -> RunResult {
    let mut command = Command::new(program_of(arguments[0]));
    command
        .current_dir(root())
        .envs(environment.iter().copied());
    ran(command.args(arguments).output().expect("pinhole starts"))
}

/// The result of a program that has ended.
pub fn ran(output: Output) -> RunResult {
    RunResult {
        code: output.status.code().expect("pinhole is not killed"),
        out: String::from_utf8(output.stdout).expect("standard output is text"),
        err: String::from_utf8(output.stderr).expect("standard error is text"),
    }
}

impl RunResult {
    /// Its standard output as one JSON document.
    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out)
            .unwrap_or_else(|error| panic!("{error}\n{}\n{}", self.out, self.err))
    }

    /// Checks the exit code; if it is wrong, shows all output.
    #[track_caller]
    pub fn expect_code(self, code: i32) -> RunResult {
        assert_eq!(self.code, code, "exit code\n{}\n{}", self.out, self.err);
        self
    }

    /// Checks that standard output contains `text`.
    #[track_caller]
    pub fn expect_out(self, text: &str) -> RunResult {
        assert!(
            self.out.contains(text),
            "no {text:?} in:\n{}\n{}",
            self.out,
            self.err
        );
        self
    }

    /// Checks that standard error contains `text`.
    #[track_caller]
    pub fn expect_err(self, text: &str) -> RunResult {
        assert!(
            self.err.contains(text),
            "no {text:?} in:\n{}\n{}",
            self.err,
            self.out
        );
        self
    }
}

/// A new, empty folder for one test, in `place`.
pub fn fresh(place: &Path, name: &str) -> PathBuf {
    let folder = place.join(format!("pinhole-{name}-{}", std::process::id()));
    let _absent = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// A folder for temporary files in the checkout, where code is trusted.
pub fn trusted() -> PathBuf {
    let folder = root().join("target/tmp");
    fs::create_dir_all(&folder).expect("there is room");
    folder
}

/// Goldens of fresh questions and scenes. Mitsuba makes them when a test first asks for them,
/// which takes a minute. They are kept for other tests, and for other runs until they are stale.
pub fn fresh_goldens() -> PathBuf {
    let folder = trusted().join("fresh-goldens");
    let lock = File::create(trusted().join("fresh-goldens.lock")).expect("there is room");
    lock.lock().expect("locks work here");
    let name = folder.to_str().expect("a plain name");
    if pinhole(&["golden", "verify", name]).code != 0 {
        let _absent = fs::remove_dir_all(&folder);
        let seed = ["golden", "render", "--seed", "7", "--no-mistakes", "--out"];
        pinhole(&[&seed[..], &[name]].concat()).expect_code(0);
    }
    folder
}

/// A copy of the assignment and its goldens in a folder, without mistakes, variants and listed
/// mutants, and with three small scenes that carry all scenes' points. The other scenes take most
/// of the time of a check.
pub fn small_assignment(course: &Path) -> PathBuf {
    let own = "assignments/ray_casting";
    for folder in [
        own,
        "assignments/ray_casting/reference",
        "assignments/ray_casting/reference/src",
        "assignments/ray_casting/scenes",
        "assignments/ray_casting/scenes/meshes",
        "golden/ray_casting",
        "golden/ray_casting/probes",
        "golden/ray_casting/ties",
    ] {
        let copy = course.join(folder);
        fs::create_dir_all(&copy).expect("a folder can be made");
        let entries = fs::read_dir(root().join(folder)).expect("it can be read");
        let paths = entries.flatten().map(|entry| entry.path());
        for file in paths.filter(|path| path.is_file()) {
            let name = file.file_name().expect("a file has a name");
            fs::copy(&file, copy.join(name)).expect("it can be copied");
        }
    }
    let assignment = course.join(own);
    for list in ["equivalent.toml", "pairs.toml"] {
        let _had_none = fs::remove_file(assignment.join(list));
    }
    let file = assignment.join("assignment.toml");
    let text = fs::read_to_string(&file).expect("it was copied");
    let (tasks, _) = text.split_once("[[scene]]").expect("it has scenes");
    let mut text = tasks.to_owned();
    for (scene, points) in [
        ("sphere_and_plane", 8),
        ("inside_a_sphere", 8),
        ("in_front_of_the_image_plane", 4),
    ] {
        text += &format!("[[scene]]\nname = {scene:?}\npoints = {points}\n");
    }
    fs::write(file, text).expect("it can be written");
    assignment
}

/// The answers of the reference with some files replaced, in a folder of `place`.
pub fn submission(place: &Path, name: &str, overlay: &[(&str, &str)]) -> PathBuf {
    let folder = fresh(place, name);
    let reference = root().join("assignments/ray_casting/reference/src");
    for entry in fs::read_dir(reference)
        .expect("the reference can be read")
        .flatten()
    {
        fs::copy(entry.path(), folder.join(entry.file_name())).expect("an answer can be copied");
    }
    for (file, text) in overlay {
        fs::write(folder.join(file), text).expect("an answer can be written");
    }
    folder
}

/// A zip archive of files, by name.
pub fn zip(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, bytes) in files {
        let options = zip::write::SimpleFileOptions::default();
        zip.start_file(name, options).expect("an entry");
        zip.write_all(bytes).expect("memory can be written");
    }
    zip.finish().expect("it ends").into_inner()
}
