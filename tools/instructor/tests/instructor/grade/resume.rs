//! No grade is lost when graders are killed, locked out, stopped by faults or run in
//! parts.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use super::{BROKEN, Class, answers, assignment, on_small_assignment, wrong_plane};
use pinhole_testing::{pinhole, program_of, root};

impl Class {
    /// Starts a grader that grades one submission at a time, and kills it as soon as `has_come`
    /// returns true.
    fn kill_grader(&self, out: &str, has_come: impl Fn() -> bool) {
        let (class, out) = (self.path("class"), self.path(out));
        let mut grader = Command::new(program_of("grade"))
            .current_dir(root())
            .args(["grade", &class, "--out", &out, "--no-fresh", "--jobs", "1"])
            .args(["--assignment", assignment()])
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .expect("pinhole starts");
        let end = Instant::now() + Duration::from_secs(120);
        while !has_come() && Instant::now() < end {
            std::thread::sleep(Duration::from_millis(5));
        }
        grader.kill().expect("it can be killed");
        grader.wait().expect("it is gone");
    }
}

#[test]
fn killed_grader_resumes_without_losing_a_grade() {
    let class = Class::new("killed");
    let undisturbed = class.grade("whole", &[]).expect_code(1);
    drop(undisturbed);
    let out = class.path("killed");
    let mut graded = 0;
    for least in [1, 3] {
        class.kill_grader("killed", || finished(Path::new(&out)).len() >= least);
        let now = finished(Path::new(&out)).len();
        assert!(now >= graded.max(least) && now < 7, "{now} were graded");
        graded = now;
    }
    let before = finished(Path::new(&out));
    let told = class.grade("killed", &["--json"]).expect_code(1).json();
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

/// The results, and when they were written.
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
    class.grade("out", &[]).expect_code(1);
    class.hand_in("emil", &[]);
    class.hand_in("ada", &[("plane.rs", BROKEN)]);
    let ran = class.grade("out", &["--json"]).expect_code(1);
    let told = ran.json();
    assert_eq!(told["graded_now"], 2);
    let why = "to be graded again: 2 (last graded with other answers)";
    assert!(ran.err.contains(why), "{}", ran.err);
    let changes = told["changes"].as_array().expect("a list");
    assert_eq!(
        (&changes[0]["id"], &changes[1]["id"]),
        (&"ada".into(), &"emil".into())
    );
    let again = class
        .grade("out", &["--json", "--regrade"])
        .expect_code(1)
        .json();
    assert_eq!(
        (&again["graded_now"], &again["changes"]),
        (&7.into(), &serde_json::json!([]))
    );
}

#[test]
fn shards_merge_to_the_grades_of_one_run() {
    let class = Class::new("shards");
    class.grade("whole", &[]).expect_code(1);
    for shard in ["1/2", "2/2"] {
        class
            .grade(&shard.replace('/', "-"), &["--shard", shard])
            // In the second part, no submission lacks a file.
            .expect_code(i32::from(shard == "1/2"));
    }
    let (one, two, merged) = (class.path("1-2"), class.path("2-2"), class.path("merged"));
    let never = class.path("3-3");
    on_small_assignment(&["merge", &one, &never, "--out", &merged])
        .expect_code(3)
        .expect_err("3-3 has no results yet: its submissions are listed as not graded")
        .expect_out("not graded");
    on_small_assignment(&["merge", &two, &one, "--out", &one])
        .expect_code(2)
        .expect_err("can't be merged into itself");
    let other = ["--assignment", "bounding_volumes"];
    pinhole(&[&["merge", &two, &one, "--out", &merged], &other[..]].concat())
        .expect_code(2)
        .expect_err("graded for the assignment");
    on_small_assignment(&["merge", &two, &one, "--out", &merged]).expect_code(1);
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

    // A new submission moves all later ones into the other part. The part that had dora before
    // still has the mark of her older answers.
    assert!(class.result("1-2", "dora")["points"].as_u64() < Some(100));
    class.hand_in("dora", &[]);
    class.hand_in("aaron", &[]);
    for shard in ["1/2", "2/2"] {
        let out = shard.replace('/', "-");
        class
            .grade(&out, &["--shard", shard])
            .expect_code(i32::from(shard == "2/2"));
    }
    let merge = ["merge", &one, &two, "--out", &merged, "--json"];
    let told = on_small_assignment(&merge).expect_code(1).json();
    assert_eq!(told["points"]["dora"], 100, "{told}");

    // The same submission may have different marks in two parts.
    class.hand_in("dora", &[("plane.rs", &wrong_plane())]);
    class.grade("wrong", &["--shard", "2/2"]).expect_code(1);
    let wrong = class.path("wrong");
    on_small_assignment(&["merge", &one, &two, &wrong, "--out", &merged])
        .expect_code(3)
        .expect_out("the old mark remains: dora: it may be for earlier answers")
        .expect_out("changed: dora: ");

    // A merged mark replaces the fault of an earlier attempt to grade again, and the evidence for an
    // earlier mark.
    let fault = class.folder.join("merged/submissions/dora/fault.json");
    let evidence = |out: &str| class.folder.join(out).join("evidence/dora.json");
    fs::remove_file(evidence("2-2")).expect("it was graded");
    fs::write(&fault, "{}").expect("writable");
    on_small_assignment(&["merge", &one, &two, &wrong, "--out", &merged]).expect_code(3);
    assert!(!fault.exists());

    // A merge does not replace another class.
    class.hand_in("zed", &[]);
    class.grade("other", &["--shard", "1/9"]);
    let (other, out) = (class.path("other"), class.path("merged-other"));
    on_small_assignment(&["merge", &other, "--out", &out]).expect_code(3);
    on_small_assignment(&["merge", &one, &two, "--out", &out])
        .expect_code(2)
        .expect_err("that is now missing: zed");

    // Another user may have written this part.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let results = class.folder.join("1-2/submissions");
        fs::set_permissions(&results, fs::Permissions::from_mode(0o777)).expect("it is ours");
        on_small_assignment(&["merge", &one, &two, "--out", &class.path("merged-foreign")])
            .expect_code(2)
            .expect_err("another user may have written");
    }
}

#[test]
fn a_merge_does_not_use_old_marks_for_answers_that_a_stopped_part_did_not_grade() {
    let class = Class::new("stopped");
    class.grade("out", &[]).expect_code(1);
    let reference = fs::read_to_string(answers().join("plane.rs")).expect("it is there");
    let endless = "-> Option<Intersection> { while std::hint::black_box(true) {}";
    let endless = reference.replacen("-> Option<Intersection> {", endless, 1);
    class.hand_in("ada", &[("plane.rs", &endless)]);
    class.hand_in("dora", &[]);
    let out = class.path("out");
    let roll = class.read("out/roll.json");
    class.kill_grader("out", || class.read("out/roll.json") != roll);

    let merged = class.path("merged");
    let told = on_small_assignment(&["merge", &out, "--out", &merged, "--json"]).expect_code(3);
    let told = told.json();
    assert_eq!(told["points"]["dora"], Value::Null, "of other answers");
    assert_eq!(told["points"]["gus"], class.result("out", "gus")["points"]);
    assert!(
        told["not_graded"].to_string().contains("for other answers"),
        "{told}"
    );

    class.hand_in("ada", &[]);
    class.grade("out", &[]).expect_code(1);
    let told = on_small_assignment(&["merge", &out, "--out", &merged, "--json"]).expect_code(1);
    assert_eq!(told.json()["points"]["dora"], 100);
}

#[test]
fn two_graders_do_not_write_into_one_folder() {
    let class = Class::new("locked");
    fs::create_dir_all(class.folder.join("out")).expect("a folder can be made");
    let lock = fs::File::create(class.folder.join("out/.lock")).expect("writable");
    lock.lock().expect("the lock is free");
    class
        .grade("out", &[])
        .expect_code(2)
        .expect_err("another grader is writing to");
    drop(lock);
    class.grade("out", &[]).expect_code(1);
}

#[test]
fn grader_fault_is_not_a_zero_and_keeps_the_finished_grade() {
    let class = Class::new("fault");
    // The first run may rebuild this program. Then the program differs, and the second run grades
    // everything again.
    for _ in 0..2 {
        class.grade("out", &[]).expect_code(1);
    }
    let before = class.read("out/submissions/ada/result.json");
    let marks = class.read("out/grades.csv");
    // The report can't be written, because a folder has its name.
    let report = class.folder.join("out/submissions/ada/report.html");
    fs::remove_file(&report).expect("it was there");
    fs::create_dir(&report).expect("a folder can be made");
    // A run that was stopped has changed this grade.
    let listed = class.folder.join("out/submissions/ada/listed.json");
    fs::write(&listed, &before).expect("writable");
    let told = class
        .grade("out", &["--regrade", "--json"])
        .expect_code(3)
        .json();
    assert_eq!(told["faults"][0][0], "ada");
    assert_eq!(told["points"]["ada"], 100, "the old mark remains");
    assert_eq!(class.read("out/submissions/ada/result.json"), before);
    assert_eq!(class.read("out/grades.csv"), marks);
    assert!(listed.exists(), "the change was not listed");

    // The old mark is not valid for other answers.
    class.hand_in("ada", &[("plane.rs", &wrong_plane())]);
    let told = class.grade("out", &["--json"]).expect_code(3).json();
    assert_eq!(told["not_graded"][0][0], "ada");
    assert_eq!(told["points"]["ada"], Value::Null);
    let (out, merged) = (class.path("out"), class.path("merged"));
    on_small_assignment(&["merge", &out, "--out", &merged])
        .expect_code(3)
        .expect_out("not graded: ada: cannot write");
}

#[test]
fn a_groups_submission_stays_its_members_when_another_is_added_or_a_class_is_merged() {
    let class = Class::new("added-with-groups");
    let put = |name: &str, text: &str| {
        let path = class.folder.join(name);
        fs::create_dir_all(path.parent().expect("it is below")).expect("there is room");
        fs::write(path, text).expect("there is room");
        class.path(name)
    };
    put("few/Team B/plane.rs", "// ours");
    put("few/cleo/plane.rs", "// mine");
    put("cleo/plane.rs", "// mine");
    let roster = put(
        "roster.csv",
        "id,name\nada,Ada Ash\nbob,Bob Boole\ncleo,Cleo Clark\n",
    );
    put("groups.csv", "id,group\nada,B\nbob,B\n");
    let policy = put("policy.toml", "groups = 'groups.csv'\n");
    let (few, one, out) = (class.path("few"), class.path("cleo"), class.path("out"));
    let line = ["grade", "--no-fresh", "--roster", &roster, "--out"];
    let named = ["--named", "Team {group}"];
    on_small_assignment(&[&line[..], &[&out, &few, "--policy", &policy], &named].concat())
        .expect_code(1)
        .expect_out("0 handed in nothing");
    on_small_assignment(&[&line[..], &[&out, &one]].concat())
        .expect_code(1)
        .expect_out("0 handed in nothing");
    // Neither another roster nor a part drops the others.
    let fewer = put("fewer.csv", "id,name\ncleo,Cleo Clark\n");
    let refused = |more: &[&str], why: &str| {
        let line = ["grade", "--no-fresh", "--out", &out, &one];
        let run = on_small_assignment(&[&line[..], more].concat());
        run.expect_code(2).expect_err(why);
    };
    refused(&["--roster", &fewer], "graded with another --roster");
    let other = ["--roster", &roster, "--named", "{id}_hw1"];
    refused(&other, "graded with another --named");
    refused(
        &["--policy", &policy, "--shard", "1/1"],
        "now missing: Team",
    );
    let (bare, merged) = (class.path("bare"), class.path("merged"));
    on_small_assignment(&[&line[..], &[&bare, &few], &named].concat())
        .expect_code(1)
        .expect_out("2 handed in nothing");
    on_small_assignment(&["merge", &bare, "--policy", &policy, "--out", &merged])
        .expect_code(1)
        .expect_out("0 handed in nothing");
    on_small_assignment(&["merge", &bare, "--out", &merged])
        .expect_code(2)
        .expect_err("graded with another --policy");
}

#[test]
fn the_pattern_stays_when_one_submission_is_graded_again() {
    let class = Class::new("pattern-stays");
    let put = |name: &str, text: &str| {
        let path = class.folder.join(name);
        fs::create_dir_all(path.parent().expect("it is below")).expect("there is room");
        fs::write(path, text).expect("there is room");
        class.path(name)
    };
    // Without the pattern, this could be an upload to Canvas.
    put("clones/cs_101_2026_hw1-bob/plane.rs", "// mine");
    put("clones/cs_101_2026_hw1-ada/plane.rs", "// mine");
    let list = "id,name,github,number\n1,Ada Ash,ada,101\n2,Bob Boole,bob,102\n";
    let roster = put("roster.csv", list);
    let (clones, out) = (class.path("clones"), class.path("out"));
    let named = ["--roster", &roster, "--named", "cs_101_2026_hw1-{github}"];
    let line = ["grade", "--no-fresh", "--out", &out];
    on_small_assignment(&[&line[..], &[&clones], &named].concat())
        .expect_code(1)
        .expect_out("0 handed in nothing");
    put("clones/cs_101_2026_hw1-bob/plane.rs", "// newer");
    let again = class.path("clones/cs_101_2026_hw1-bob");
    on_small_assignment(&[&line[..], &[&again]].concat())
        .expect_code(1)
        .expect_out("of 2 people on the roster, 2 are graded; 0 handed in nothing")
        .expect_out("2 submissions, 1 graded now");
}

#[test]
fn one_persons_upload_that_looks_like_the_class_does_not_replace_it() {
    let class = Class::new("like-class");
    let put = |path: &str| {
        let folder = class.folder.join(path);
        fs::create_dir_all(&folder).expect("there is room");
        fs::write(folder.join("sphere.rs"), BROKEN).expect("there is room");
        class.path(path)
    };
    let paths = [put("few/ada"), put("few/bob"), put("few/mal")];
    fs::remove_file(class.folder.join("few/mal/sphere.rs")).expect("it was made");
    let out = class.path("out");
    let grade = |paths: &[&str]| {
        on_small_assignment(&[&["grade", "--no-fresh", "--out", &out], paths].concat())
    };
    grade(&[&paths[0], &paths[1], &paths[2]]).expect_code(1);
    for inside in ["ada", "bob", "mal"] {
        put(&format!("late/mal/{inside}"));
    }
    grade(&[&class.path("late/mal")])
        .expect_code(2)
        .expect_err("which was not passed now");
    let inside = class.path("few/ada/out");
    on_small_assignment(&["grade", &paths[0], "--no-fresh", "--out", &inside])
        .expect_code(2)
        .expect_err("which is to be graded");
}
