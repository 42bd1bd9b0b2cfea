//! The real command grades a small class. Marks must not depend on how it is run.

mod exports;
mod fresh;
mod merge;
mod resume;
mod withheld;

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

use pinhole_testing::{
    RunResult, fresh, pinhole, program_of, ran, root, small_assignment, submission, trusted,
};

const BROKEN: &str = "fn oops( {";

/// Runs a command on an assignment without large scenes, because no test here needs them.
fn on_small_assignment(arguments: &[&str]) -> RunResult {
    pinhole(&[arguments, &["--assignment", assignment()]].concat())
}

/// The folder of that assignment.
fn assignment() -> &'static str {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| small_assignment(&fresh(&trusted(), "small")));
    folder.to_str().expect("a plain name")
}

/// Submissions in a folder outside the checkout: one right, two wrong, one that does not
/// compile, one that panics, one incomplete, and a disguised copy.
struct Class {
    folder: PathBuf,
}

impl Class {
    fn new(name: &str) -> Class {
        let folder = fresh(&std::env::temp_dir(), &format!("class-{name}"));
        let class = Class { folder };
        let (sphere, plane) = (mistake("sphere_near_root_only", "sphere"), wrong_plane());
        let noisy = format!("// mine, all mine\n\n{sphere}");
        let reference = fs::read_to_string(answers().join("triangle.rs")).expect("it is there");
        let panicking = reference.replacen(
            "-> Option<Intersection> {",
            "-> Option<Intersection> { panic!(\"</pre><script>alert(1)</script>\");",
            1,
        );
        assert_ne!(panicking, reference, "the panic went in");
        class.hand_in("ada", &[]);
        class.hand_in("bob", &[("sphere.rs", &sphere)]);
        class.hand_in("copy", &[("sphere.rs", &noisy)]);
        class.hand_in("dora", &[("plane.rs", &plane)]);
        class.hand_in("emil", &[("plane.rs", BROKEN)]);
        class.hand_in("=frida<b>", &[("triangle.rs", &panicking)]);
        class.hand_in("gus", &[]);
        fs::remove_file(class.folder.join("class/gus/plane.rs")).expect("it was there");
        fs::write(class.folder.join("class/notes.txt"), "not a submission").expect("writable");
        class
    }

    fn hand_in(&self, name: &str, overlay: &[(&str, &str)]) {
        let made = submission(&self.folder, "one", overlay);
        let to = self.folder.join("class").join(name);
        fs::create_dir_all(self.folder.join("class")).expect("a folder can be made");
        let _replaced = fs::remove_dir_all(&to);
        fs::rename(made, to).expect("a folder can be moved");
    }

    fn path(&self, name: &str) -> String {
        self.folder.join(name).to_str().expect("plain").to_owned()
    }

    fn grade(&self, out: &str, more: &[&str]) -> RunResult {
        let (class, out) = (self.path("class"), self.path(out));
        let fixed = ["grade", &class, "--out", &out, "--no-fresh"];
        on_small_assignment(&[&fixed[..], more].concat())
    }

    fn read(&self, path: &str) -> String {
        let path = self.folder.join(path);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    fn result(&self, out: &str, id: &str) -> Value {
        let text = self.read(&format!("{out}/submissions/{id}/result.json"));
        serde_json::from_str(&text).expect("a result is JSON")
    }
}

impl Drop for Class {
    fn drop(&mut self) {
        let _left_for_the_system = fs::remove_dir_all(&self.folder);
    }
}

fn answers() -> PathBuf {
    root().join("assignments/ray_casting/reference/src")
}

fn mistake(slug: &str, task: &str) -> String {
    let folder = root().join("assignments/ray_casting/mistakes").join(slug);
    fs::read_to_string(folder.join(task).with_extension("rs")).expect("the mistake is there")
}

/// The first mistake in `plane` alone.
fn wrong_plane() -> String {
    let folder = root().join("assignments/ray_casting/mistakes");
    let entries = fs::read_dir(folder).expect("it is there").flatten();
    let mut slugs: Vec<String> = entries
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    slugs.sort();
    let slug = slugs
        .iter()
        .find(|slug| slug.starts_with("plane_"))
        .expect("there are some");
    mistake(slug, "plane")
}

/// Lines of `grades.csv` by submission: points and outcome.
fn marks(csv: &str) -> Vec<(String, String, String)> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows = reader.records().map(|row| row.expect("it is CSV"));
    rows.map(|row| (row[3].to_owned(), row[4].to_owned(), row[6].to_owned()))
        .collect()
}

#[test]
fn a_class_gets_the_same_grades_with_any_number_of_jobs_and_a_full_report() {
    let class = Class::new("jobs");
    let roster = "id,name,section\nada,Ada Lovelace,A\nbob,Bob,B\nzoe,\"Zoe, =1+1\",B\n";
    fs::write(class.folder.join("roster.csv"), roster).expect("writable");
    let roster = class.path("roster.csv");
    let formats = ["gradescope", "junit", "prairielearn", "csv"];
    let formats: Vec<&str> = formats.iter().flat_map(|name| ["--format", name]).collect();
    let options = [
        &["--roster", &roster, "--json", "--jobs", "1"][..],
        &formats,
    ]
    .concat();
    // One submission lacks a file, five are not on the roster, and one file belongs to no
    // submission.
    let told = class.grade("one", &options).expect_code(1).json();
    class
        .grade("two", &["--roster", &roster, "--jobs", "2"])
        .expect_code(1)
        .expect_out("of 3 people on the roster, 2 are graded; 1 handed in nothing")
        .expect_out("! 1 not part of any submission\n      notes.txt")
        .expect_out("gus: plane.rs is missing")
        .expect_out("emil: plane does not compile");
    pinhole(&["dispute", "emil", "--out", &class.path("two")])
        .expect_code(0)
        .expect_out("unclosed delimiter");
    let csv = class.read("one/grades.csv");
    assert_eq!(csv, class.read("two/grades.csv"));

    let marks = marks(&csv);
    let of = |name: &str| marks.iter().find(|(who, ..)| who == name).expect("a line");
    assert_eq!(of("ada").1, "100");
    assert_eq!(of("bob").1, of("copy").1);
    assert_eq!(of("emil").2, "does not compile");
    assert_eq!(of("'=frida<b>").2, "panicked");
    assert_eq!(of("gus").2, "missing file");
    assert!(
        of("gus").1.parse::<u32>().is_ok_and(|points| points > 50),
        "{csv}"
    );

    assert_eq!(told["roster"]["missing"][0]["id"], "zoe");
    assert_eq!(told["roster"]["unknown"].as_array().map(Vec::len), Some(5));
    assert_eq!(told["ignored"][0], "notes.txt");
    let same = told["alike"].as_array().expect("a list");
    let copied = same
        .iter()
        .find(|same| same["task"] == "sphere" && same["to"] == "each other");
    assert_eq!(
        copied.expect("copies are seen")["who"],
        serde_json::json!(["bob", "copy"])
    );
    assert!(
        told["mistakes"][0]["who"]
            .as_array()
            .is_some_and(|who| who.len() == 2),
        "{told:#}"
    );

    let page = class.read("one/class.html");
    assert!(page.contains("frida&lt;b&gt;") && !page.contains("frida<b>"));
    let frida = told["points"]
        .as_object()
        .expect("by id")
        .keys()
        .find(|id| id.contains("frida"));
    let frida = frida.expect("she is in the list").clone();
    let report = class.read(&format!("one/submissions/{frida}/report.html"));
    assert!(report.contains("alert(1)") && !report.contains("<script>alert"));

    for id in ["ada", "emil", "gus", &frida] {
        every_format_is_valid(&class, id);
    }
}

/// A validator from the Python package index, with the schema of GitHub's workflows. A validator in
/// Rust would need some of our dependencies with other features, so cargo would build them twice.
pub fn check_jsonschema() -> Command {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    Command::new(PROGRAM.get_or_init(|| {
        let environment = trusted().join("check-jsonschema");
        let program = environment.join("bin").join("check-jsonschema");
        if !program.is_file() {
            let python = Command::new("python3")
                .args(["-m", "venv"])
                .arg(&environment)
                .status();
            assert!(python.expect("python3 starts").success());
            let pip = Command::new(environment.join("bin").join("pip"))
                .args(["install", "--quiet", "check-jsonschema==0.39.0"])
                .status();
            assert!(pip.expect("pip starts").success());
        }
        program
    }))
}

/// Where a document differs from its schema in `tools/schema`; empty if it does not.
pub fn faults(schema: &str, document: &Value) -> String {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("document.json");
    fs::write(&file, document.to_string()).expect("there is room");
    let output = check_jsonschema()
        .arg("--schemafile")
        .arg(root().join("tools/schema").join(schema))
        .arg(file)
        .output()
        .expect("it starts");
    match output.status.success() {
        true => String::new(),
        false => String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned(),
    }
}

/// Checks each file against its schema, or reads it with another project's parser.
#[track_caller]
fn every_format_is_valid(class: &Class, id: &str) {
    let documents = [
        ("result.json", "result.schema.json"),
        ("gradescope.json", "gradescope.schema.json"),
        ("prairielearn.json", "prairielearn.schema.json"),
    ];
    let result = class.result("one", id);
    for (file, schema) in documents {
        let document = class.read(&format!("one/submissions/{id}/{file}"));
        let document: Value = serde_json::from_str(&document).expect("it is JSON");
        let faults = faults(schema, &document);
        assert!(faults.is_empty(), "{id}/{file}: {faults}");
        if file == "gradescope.json" {
            let tests = document["tests"].as_array().expect("tests");
            let sum: u64 = tests.iter().filter_map(|test| test["score"].as_u64()).sum();
            assert_eq!(
                Some(sum),
                result["points"].as_u64(),
                "the tests' scores add up"
            );
        }
    }
    let xml = class.read(&format!("one/submissions/{id}/junit.xml"));
    let suites = junit_parser::from_reader(xml.as_bytes()).expect("it is JUnit's XML");
    let cases: usize = suites.suites.iter().map(|suite| suite.cases.len()).sum();
    assert_eq!(cases as u64, suites.tests, "{id}");
}

#[test]
fn empty_archive_misses_its_answers_and_a_broken_one_is_refused() {
    let class = Class::new("archives");
    let folder = class.folder.join("archives");
    fs::create_dir_all(folder.join("empty")).expect("a folder can be made");
    let archive = fs::File::create(folder.join("without.zip")).expect("writable");
    let mut archive = zip::ZipWriter::new(archive);
    let options = zip::write::SimpleFileOptions::default();
    archive.start_file("notes.txt", options).expect("writable");
    archive.finish().expect("writable");
    fs::write(folder.join("broken.zip"), "PK no archive").expect("writable");
    let (folder, out) = (class.path("archives"), class.path("out"));
    on_small_assignment(&["grade", &folder, "--out", &out, "--no-fresh"]).expect_code(1);
    for (id, outcome) in [
        ("without", "missing file"),
        ("broken", "refused file"),
        ("empty", "missing file"),
    ] {
        let result = class.result("out", id);
        assert_eq!(
            (&result["outcome"], &result["points"]),
            (&outcome.into(), &0.into()),
            "{id}"
        );
    }
}

#[test]
fn an_endless_answer_is_asked_again_alone_and_costs_its_own_points_only() {
    let class = Class::new("endless");
    let entry = class.path("class/endless");
    let reference = fs::read_to_string(answers().join("plane.rs")).expect("it is there");
    let endless = reference.replacen(
        "-> Option<Intersection> {",
        "-> Option<Intersection> { while std::hint::black_box(true) {}",
        1,
    );
    class.hand_in("endless", &[("plane.rs", &endless)]);
    let out = class.path("out");
    let more = ["--no-fresh", "--timeout", "1"];
    on_small_assignment(&[&["grade", &entry, "--out", &out][..], &more].concat()).expect_code(0);
    let result = class.result("out", "endless");
    assert_eq!(result["outcome"], "timed out");
    assert_eq!(result["timings"]["second_runs"], 1);
    for task in result["tasks"].as_array().expect("tasks") {
        let lost = task["points"] != task["possible"];
        assert_eq!(lost, task["name"] == "plane", "{task:#}");
    }
}

#[test]
fn a_folder_that_was_entered_through_a_link_is_not_graded_under_the_name_behind_it() {
    let class = Class::new("entered");
    let (theirs, link) = (
        class.folder.join("late/.x/ada"),
        class.folder.join("late/bob"),
    );
    fs::create_dir_all(&theirs).expect("there is room");
    fs::write(theirs.join("sphere.rs"), BROKEN).expect("there is room");
    std::os::unix::fs::symlink(&theirs, &link).expect("there is room");
    for path in [".", "../ada"] {
        for (typed, code) in [(Some(&link), 2), (None, 2), (Some(&theirs), 1)] {
            let grade = ["grade", path, "--dry-run", "--assignment", assignment()];
            let mut command = Command::new(program_of("grade"));
            command.args(grade).current_dir(&theirs).env_remove("PWD");
            command.envs(typed.map(|typed| ("PWD", typed)));
            ran(command.output().expect("it starts")).expect_code(code);
        }
    }
}

#[test]
fn no_file_of_a_student_is_taken_for_an_option() {
    let class = Class::new("options");
    let grade = |name: &str| {
        fs::write(class.folder.join(name), "").expect("there is room");
        let mut command = Command::new(program_of("grade"));
        command.args(["grade", "class", "--trust", "--assignment", assignment()]);
        command.args(["--dry-run"]).current_dir(&class.folder);
        ran(command.output().expect("it starts"))
    };
    grade("trust").expect_code(1);
    grade("--trust").expect_code(2).expect_err("write `./*`");
}

#[test]
fn grading_without_a_sandbox_needs_an_option() {
    let class = Class::new("trusted");
    let (entry, out) = (class.path("class/ada"), class.path("out"));
    let fixed = ["grade", &entry, "--out", &out, "--no-fresh"];
    let formats = ["gradescope", "prairielearn", "junit"].map(|name| ["--format", name]);
    let trusting = [&fixed[..], &["--trust"], &formats.concat()].concat();
    pinhole(&trusting)
        .expect_code(0)
        .expect_out("without a sandbox");
    let result = class.result("out", "ada");
    assert_eq!(result["provenance"]["sandbox"], "none");
    for view in [
        "submissions/ada/report.html",
        "submissions/ada/gradescope.json",
        "submissions/ada/prairielearn.json",
        "submissions/ada/junit.xml",
        "class.html",
        "grades.csv",
    ] {
        let text = class.read(&format!("out/{view}"));
        assert!(text.contains("without a sandbox"), "{view}:\n{text}");
    }
    // A mark given without a sandbox is not valid for a run with one.
    let again = pinhole(&[&fixed[..], &["--json"]].concat())
        .expect_code(0)
        .json();
    assert_eq!(again["graded_now"], 1);
    // All other views of the old mark are removed too.
    for gone in ["gradescope.json", "prairielearn.json", "junit.xml"] {
        let path = class.folder.join("out/submissions/ada").join(gone);
        assert!(!path.exists(), "{gone}");
    }
    assert_eq!(
        class.result("out", "ada")["provenance"]["sandbox"],
        "bubblewrap"
    );
}

#[test]
fn nothing_whose_tests_are_counted_is_asked_twice() {
    let folder = fresh(&trusted(), "asked-twice");
    let own = folder.join("class/ada");
    fs::create_dir_all(&own).expect("there is room");
    let reference = root().join("assignments/bounding_volumes/reference/src");
    for answer in fs::read_dir(reference).expect("it is there").flatten() {
        fs::copy(answer.path(), own.join(answer.file_name())).expect("there is room");
    }
    // In the first process, it could do all tests and leave the answers behind.
    let mark = folder.join("mark");
    let first = format!(
        "if !std::path::Path::new({mark:?}).exists() {{
             std::fs::write({mark:?}, \"\").unwrap();
             panic!(\"the first process ends\");
         }}\n"
    );
    let search = own.join("nearest_hit.rs");
    let text = fs::read_to_string(&search).expect("it is there");
    let text = text.replace("// ANCHOR: answer\n", &first);
    fs::write(search, text).expect("there is room");
    let [class, out] = ["class", "out"].map(|name| folder.join(name));
    let [class, out] = [&class, &out].map(|it| it.to_str().expect("a plain name"));
    let course = ["--assignment", "bounding_volumes", "--trust", "--no-fresh"];
    pinhole(&[&["grade", class, "--out", out], &course[..]].concat()).expect_code(0);
    let result = fs::read_to_string(folder.join("out/submissions/ada/result.json"));
    let result: Value = serde_json::from_str(&result.expect("it is there")).expect("it is JSON");
    let tasks = result["tasks"].as_array().expect("tasks");
    let search = tasks.iter().find(|it| it["name"] == "nearest_hit");
    let points = search.and_then(|it| it["points"].as_u64());
    let points = points.expect("it was graded");
    assert!(0 < points && points < 25, "{points}: {result:#}");
}
