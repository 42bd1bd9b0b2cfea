//! A small class, graded by the real command: the same marks whatever happens meanwhile.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::course::{Ran, fresh, pinhole, root, submission};

const BROKEN: &str = "fn oops( {";

/// Submissions in a folder outside the checkout: right, wrong twice, not compiling,
/// panicking, incomplete, and a copy with noise.
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

    fn grade(&self, out: &str, more: &[&str]) -> Ran {
        let (class, out) = (self.path("class"), self.path(out));
        let fixed = ["grade", &class, "--out", &out, "--no-fresh"];
        pinhole(&[&fixed[..], more].concat())
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
fn a_class_is_graded_alike_at_any_number_of_jobs_and_everything_in_it_is_told() {
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
    let told = class.grade("one", &options).expect_code(0).json();
    class
        .grade("two", &["--roster", &roster, "--jobs", "2"])
        .expect_code(0);
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
    let frida = frida.expect("she is there").clone();
    let report = class.read(&format!("one/submissions/{frida}/report.html"));
    assert!(report.contains("alert(1)") && !report.contains("<script>alert"));

    for id in ["ada", "emil", "gus", &frida] {
        every_format_is_valid(&class, id);
    }
}

/// Each file against its schema, or read by a parser of others.
#[track_caller]
fn every_format_is_valid(class: &Class, id: &str) {
    let schemas = root().join("tools/schema");
    let documents = [
        ("result.json", "result.schema.json"),
        ("gradescope.json", "gradescope.schema.json"),
        ("prairielearn.json", "prairielearn.schema.json"),
    ];
    let result = class.result("one", id);
    for (file, schema) in documents {
        let schema = fs::read_to_string(schemas.join(schema)).expect("the schema is there");
        let schema: Value = serde_json::from_str(&schema).expect("it is JSON");
        let document = class.read(&format!("one/submissions/{id}/{file}"));
        let document: Value = serde_json::from_str(&document).expect("it is JSON");
        let validator = jsonschema::validator_for(&schema).expect("it is a schema");
        let errors: Vec<String> = validator
            .iter_errors(&document)
            .map(|error| error.to_string())
            .collect();
        assert!(errors.is_empty(), "{id}/{file}: {errors:?}");
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
fn killed_grader_resumes_without_losing_a_grade() {
    let class = Class::new("killed");
    let undisturbed = class.grade("whole", &[]).expect_code(0);
    drop(undisturbed);
    let (folder, out) = (class.path("class"), class.path("killed"));
    let mut graded = 0;
    for least in [1, 3] {
        let mut grader = Command::new(env!("CARGO_BIN_EXE_pinhole"))
            .current_dir(root())
            .args(["grade", &folder, "--out", &out, "--no-fresh", "--jobs", "1"])
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .expect("pinhole starts");
        let end = Instant::now() + Duration::from_secs(120);
        while finished(Path::new(&out)).len() < least && Instant::now() < end {
            std::thread::sleep(Duration::from_millis(5));
        }
        grader.kill().expect("it can be killed");
        grader.wait().expect("it is gone");
        let now = finished(Path::new(&out)).len();
        assert!(now >= graded.max(least) && now < 7, "{now} were graded");
        graded = now;
    }
    let before = finished(Path::new(&out));
    let told = class.grade("killed", &["--json"]).expect_code(0).json();
    assert_eq!(told["graded_now"], 7 - graded);
    assert_eq!(
        class.read("killed/grades.csv"),
        class.read("whole/grades.csv")
    );
    for (path, modified) in before {
        let now = path
            .metadata()
            .and_then(|metadata| metadata.modified())
            .expect("it is there");
        assert_eq!(now, modified, "{} was not touched", path.display());
    }
}

/// Results and when they were written.
fn finished(out: &Path) -> Vec<(PathBuf, std::time::SystemTime)> {
    let entries = fs::read_dir(out.join("submissions"))
        .into_iter()
        .flatten()
        .flatten();
    let results = entries.map(|entry| entry.path().join("result.json"));
    results
        .filter_map(|path| {
            let modified = path
                .metadata()
                .and_then(|metadata| metadata.modified())
                .ok()?;
            Some((path, modified))
        })
        .collect()
}

#[test]
fn only_what_changed_is_graded_again_and_drops_are_listed_first() {
    let class = Class::new("changed");
    class.grade("out", &[]).expect_code(0);
    class.hand_in("emil", &[]);
    class.hand_in("ada", &[("plane.rs", BROKEN)]);
    let told = class.grade("out", &["--json"]).expect_code(0).json();
    assert_eq!(told["graded_now"], 2);
    let changes = told["changes"].as_array().expect("a list");
    assert_eq!(
        (&changes[0]["id"], &changes[1]["id"]),
        (&"ada".into(), &"emil".into())
    );
    let again = class
        .grade("out", &["--json", "--regrade"])
        .expect_code(0)
        .json();
    assert_eq!(
        (&again["graded_now"], &again["changes"]),
        (&7.into(), &serde_json::json!([]))
    );
}

#[test]
fn shards_merge_to_the_grades_of_one_run() {
    let class = Class::new("shards");
    class.grade("whole", &[]).expect_code(0);
    for shard in ["1/2", "2/2"] {
        class
            .grade(&shard.replace('/', "-"), &["--shard", shard])
            .expect_code(0);
    }
    let (one, two, merged) = (class.path("1-2"), class.path("2-2"), class.path("merged"));
    pinhole(&["merge", &one, "--out", &merged])
        .expect_code(3)
        .expect_out("not graded");
    pinhole(&["merge", &two, &one, "--out", &merged]).expect_code(0);
    assert_eq!(
        class.read("merged/grades.csv"),
        class.read("whole/grades.csv")
    );
    assert!(
        class
            .folder
            .join("merged/submissions/ada/report.html")
            .is_file()
    );
}

#[test]
fn two_graders_do_not_write_into_one_folder() {
    let class = Class::new("locked");
    fs::create_dir_all(class.folder.join("out")).expect("a folder can be made");
    let lock = fs::File::create(class.folder.join("out/.lock")).expect("writable");
    lock.lock().expect("nobody else has it");
    class
        .grade("out", &[])
        .expect_code(2)
        .expect_err("somebody else is grading");
    drop(lock);
    class.grade("out", &[]).expect_code(0);
}

#[test]
fn a_fault_of_the_graders_is_no_zero_and_spares_the_finished_grade() {
    let class = Class::new("fault");
    class.grade("out", &[]).expect_code(0);
    let before = class.read("out/submissions/ada/result.json");
    let marks = class.read("out/grades.csv");
    // Nobody can write a report where a folder lies.
    let report = class.folder.join("out/submissions/ada/report.html");
    fs::remove_file(&report).expect("it was there");
    fs::create_dir(&report).expect("a folder can be made");
    let told = class
        .grade("out", &["--regrade", "--json"])
        .expect_code(3)
        .json();
    assert_eq!(told["faults"][0][0], "ada");
    assert_eq!(told["points"]["ada"], 100, "the old mark stands");
    assert_eq!(class.read("out/submissions/ada/result.json"), before);
    assert_eq!(class.read("out/grades.csv"), marks);

    // Of other answers the old mark says nothing.
    class.hand_in("ada", &[("plane.rs", &wrong_plane())]);
    let told = class.grade("out", &["--json"]).expect_code(3).json();
    assert_eq!(told["not_graded"][0][0], "ada");
    assert_eq!(told["points"]["ada"], Value::Null);
}

/// A folder of goldens as `golden render SCENE --out` makes it: films and a manifest, and
/// no probes.
fn goldens_of_one_scene(class: &Class, scene: &str) -> String {
    let folder = class.folder.join("mine");
    fs::create_dir_all(&folder).expect("a folder can be made");
    for end in ["exr", "tol.exr", "rays.exr", "rays.tol.exr"] {
        let name = format!("{scene}.{end}");
        let film = root().join("golden/ray_casting").join(&name);
        fs::copy(film, folder.join(name)).expect("the film is there");
    }
    let manifest = fs::read_to_string(root().join("golden/ray_casting/manifest.toml"));
    let mut manifest: toml::Table = manifest.expect("it is there").parse().expect("TOML");
    manifest.remove("probe_seed");
    manifest.remove("mistakes");
    for (table, part) in [
        ("films", format!("{scene}.")),
        ("sources", format!("/{scene}.toml")),
    ] {
        let entries = manifest[table].as_table_mut().expect("a table");
        entries.retain(|name, _| name.contains(&part) && !name.contains("mistakes"));
    }
    fs::write(folder.join("manifest.toml"), manifest.to_string()).expect("writable");
    class.path("mine")
}

#[test]
fn withheld_scenes_show_no_more_than_the_instructor_chooses() {
    let class = Class::new("withheld");
    let mine = goldens_of_one_scene(&class, "inside_a_sphere");
    let reference = fs::read_to_string(answers().join("first_hit.rs")).expect("it is there");
    let loud = reference.replacen(
        "-> Option<Hit> {",
        "-> Option<Hit> { if min_t == 1.0 && !objects.is_empty() { panic!(\"told by {}\", ray.origin.x); }",
        1,
    );
    class.hand_in("loud", &[("first_hit.rs", &loud)]);
    for reveal in ["points", "message", "picture", "full"] {
        class
            .grade(reveal, &["--golden", &mine, "--reveal", reveal])
            .expect_code(0);
        let report = class.read(&format!("{reveal}/submissions/bob/report.html"));
        let shows = |text: &str| report.contains(text);
        assert_eq!(
            shows("data:image"),
            ["picture", "full"].contains(&reveal),
            "{reveal}"
        );
        assert_eq!(shows("class=\"viewer\""), reveal == "full", "{reveal}");
        let bob = class.result(reveal, "bob");
        let said = bob["scenes"][0]["said"].as_str().expect("words");
        assert_eq!(
            said.contains("pixels are wrong"),
            reveal != "points",
            "{reveal}: {said}"
        );
        assert_eq!(
            (&bob["scenes"][0]["points"], &bob["possible"]),
            (&0.into(), &100.into())
        );
        let loud = class.result(reveal, "loud");
        assert_eq!(
            (&loud["scenes"][0]["outcome"], &loud["printed"]),
            (&"panicked".into(), &"".into())
        );
        assert!(
            !loud["scenes"].to_string().contains("told by"),
            "{reveal}: {loud:#}"
        );
    }
}

#[test]
fn goldens_that_have_changed_since_they_were_made_judge_nobody() {
    let class = Class::new("changed-goldens");
    let mine = goldens_of_one_scene(&class, "inside_a_sphere");
    let film = class.folder.join("mine/inside_a_sphere.exr");
    let mut bytes = fs::read(&film).expect("it is there");
    *bytes.last_mut().expect("it is not empty") ^= 1;
    fs::write(&film, bytes).expect("writable");
    class
        .grade("out", &["--golden", &mine])
        .expect_code(2)
        .expect_err("inside_a_sphere.exr has changed since the goldens were made");
    assert!(!class.folder.join("out/grades.csv").exists());
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
    pinhole(&[&["grade", &entry, "--out", &out][..], &more].concat()).expect_code(0);
    let result = class.result("out", "endless");
    assert_eq!(result["outcome"], "timed out");
    assert_eq!(result["timings"]["second_runs"], 1);
    for task in result["tasks"].as_array().expect("tasks") {
        let lost = task["points"] != task["possible"];
        assert_eq!(lost, task["name"] == "plane", "{task:#}");
    }
}

#[test]
fn nobody_is_graded_without_walls_unless_the_instructor_says_so() {
    let class = Class::new("trusted");
    let (entry, out) = (class.path("class/ada"), class.path("out"));
    let fixed = ["grade", &entry, "--out", &out, "--no-fresh"];
    pinhole(&[&fixed[..], &["--trust"]].concat()).expect_code(0);
    let result = class.result("out", "ada");
    assert_eq!(result["provenance"]["sandbox"], "none");
    assert!(
        class
            .read("out/submissions/ada/report.html")
            .contains("none")
    );
    // That mark does not pass for one made behind walls.
    let again = pinhole(&[&fixed[..], &["--json"]].concat())
        .expect_code(0)
        .json();
    assert_eq!(again["graded_now"], 1);
    assert_eq!(
        class.result("out", "ada")["provenance"]["sandbox"],
        "bubblewrap"
    );
}

/// `sphere.rs` that is right about every public question and says no to all others.
fn memoriser() -> String {
    let probes = root().join("golden/ray_casting/probes");
    let mut seen = Vec::new();
    for entry in fs::read_dir(probes).expect("probes are there").flatten() {
        let name = entry.file_name().into_string().expect("plain");
        if name.starts_with("sphere.") && name.ends_with(".ask.exr") {
            let (job, _) = pinhole::probe::read(&entry.path(), "sphere").expect("a probe");
            if let pinhole::job::Job::Intersect(questions) = job {
                seen.extend(questions.iter().map(|asked| asked.ray.origin.x.to_bits()));
            }
        }
    }
    seen.sort();
    seen.dedup();
    let reference = fs::read_to_string(answers().join("sphere.rs")).expect("it is there");
    let guarded = reference.replacen(
        "-> Option<Intersection> {",
        "-> Option<Intersection> { SEEN.binary_search(&ray.origin.x.to_bits()).ok()?;",
        1,
    );
    format!("{guarded}\nconst SEEN: [u64; {}] = {seen:?};\n", seen.len())
}

#[test]
fn a_memoriser_gets_nothing_for_what_it_has_memorised() {
    let class = Class::new("memoriser");
    let entry = class.path("class/memoriser");
    class.hand_in("memoriser", &[("sphere.rs", &memoriser())]);
    let sphere = |out: &str| {
        let result = class.result(out, "memoriser");
        let tasks = result["tasks"].as_array().expect("tasks").clone();
        let sphere = tasks
            .into_iter()
            .find(|task| task["name"] == "sphere")
            .expect("sphere");
        (sphere["points"].as_u64().expect("points"), sphere, result)
    };
    let (known, fresh) = (class.path("known"), class.path("fresh"));
    pinhole(&["grade", &entry, "--out", &known, "--no-fresh"]).expect_code(0);
    let (points, _, result) = sphere("known");
    assert_eq!(points, 18);
    assert_eq!(result["provenance"]["judged_on"], "public goldens only");

    pinhole(&["grade", &entry, "--out", &fresh, "--seed", "7"]).expect_code(0);
    let (points, task, result) = sphere("fresh");
    assert!(points <= 4, "{task:#}");
    let groups = task["groups"].as_array().expect("groups");
    let outside = groups
        .iter()
        .find(|group| group["name"] == "outside")
        .expect("a group");
    assert_eq!(outside["fails_fresh"], true);
    assert!(
        result["most_for_scenes"]
            .as_u64()
            .is_some_and(|most| most < 20)
    );
    // The questions are there now: nothing is made or graded again.
    let again = pinhole(&["grade", &entry, "--out", &fresh, "--json"])
        .expect_code(0)
        .json();
    assert_eq!(again["graded_now"], 0);
}
