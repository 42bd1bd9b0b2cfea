//! A small assignment whose only task is about a shape that no other assignment uses.
//! Every command must work with it, although no source of the tools names it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use pinhole_testing::{RunResult, fresh, pinhole, program_of, root, trusted};
use serde_json::{Value, json};

const DISKS: &str = "tools/instructor/tests/fixture/assignments/disks";

/// Runs a command on the small assignment.
fn run(arguments: &[&str]) -> RunResult {
    pinhole(&[arguments, &["--assignment", DISKS]].concat())
}

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

/// The folder of a part of the assignment, as an argument.
fn part(name: &str) -> String {
    format!("{DISKS}/{name}")
}

#[test]
fn the_reference_gets_every_point_and_the_stub_is_unanswered() {
    run(&["check", &part("reference"), "--no-report"])
        .expect_code(0)
        .expect_out("20 / 20");
    run(&["check", &part("handout"), "--no-report"])
        .expect_code(1)
        .expect_out("0 / 12   unanswered")
        .expect_out("blocked by `disk`");
}

#[test]
fn a_mistake_fails_where_it_shows_and_its_rewrite_is_named() {
    let rewritten = part("mistakes/disk_ignores_min_t/rewrite");
    run(&["check", &rewritten, "--no-report"])
        .expect_code(1)
        .expect_out("10 / 12   4 of 5 groups pass")
        .expect_out("my caller can compare t with min_t")
        .expect_out("disk      c = (");
}

#[test]
fn a_pixel_is_explained_in_the_shapes_own_words() {
    run(&["explain", "coins", "32", "18"])
        .expect_code(0)
        .expect_out("disk c = (0.1, 0.4, −0.5), n = (0.3, 1, 2), r = 0.7")
        .expect_out("Mitsuba's  object 0 at t = 3.18863");
}

#[test]
fn the_report_shows_the_task() {
    let report = fresh(&trusted(), "fixture-report").join("report.html");
    let wrong = part("mistakes/disk_radius_not_squared");
    run(&["check", &wrong, "--report", plain(&report)]).expect_code(1);
    let page = fs::read_to_string(&report).expect("it was written");
    for words in ["Disks", "disk", "coins", "squared distance from the centre"] {
        assert!(page.contains(words), "no {words:?} in the report");
    }
}

#[test]
fn a_class_of_two_is_graded_by_fresh_questions_too() {
    let class = fresh(&trusted(), "fixture-class");
    let from = [
        ("ada", "reference/src"),
        ("bob", "mistakes/disk_ignores_min_t"),
    ];
    for (who, folder) in from {
        let to = class.join("answers").join(who);
        fs::create_dir_all(&to).expect("a folder can be made");
        let answer = root().join(part(folder)).join("disk.rs");
        fs::copy(answer, to.join("disk.rs")).expect("it can be copied");
    }
    let (answers, out) = (class.join("answers"), class.join("grades"));
    run(&[
        "grade",
        plain(&answers),
        "--out",
        plain(&out),
        "--seed",
        "7",
    ])
    .expect_code(0);
    let grades = fs::read_to_string(out.join("grades.csv")).expect("it was written");
    assert!(grades.contains(",ada,20,20,graded,,12,8,"), "{grades}");
    assert!(grades.contains(",bob,14,20,graded,,10,4,"), "{grades}");
    let fresh = out.join("fresh");
    let arguments = ["check", &part("reference"), "--no-report", "--golden"];
    run(&[&arguments[..], &[plain(&fresh)]].concat())
        .expect_code(0)
        .expect_out("random_0")
        .expect_out("20 / 20");
}

#[test]
fn an_answer_that_sleeps_holds_up_neither_the_others_nor_its_own_grade() {
    let class = fresh(&trusted(), "fixture-asleep");
    let answer = fs::read_to_string(root().join(part("reference/src/disk.rs")));
    let answer = answer.expect("it is there");
    let asleep = answer.replacen(
        "-> Option<Intersection> {",
        "-> Option<Intersection> { \
         std::thread::sleep(std::time::Duration::from_secs(3600));",
        1,
    );
    assert_ne!(asleep, answer, "the sleep went in");
    for (who, text) in [("asleep", &asleep), ("right", &answer)] {
        let to = class.join("answers").join(who);
        fs::create_dir_all(&to).expect("a folder can be made");
        fs::write(to.join("disk.rs"), text).expect("it can be written");
    }
    let out = class.join("grades");
    let folders = [plain(&class.join("answers")), "--out", plain(&out)].map(str::to_owned);
    let mut has_marks_early = false;
    let mut grading = Command::new(program_of("grade"))
        .current_dir(root())
        .args(["grade", "--no-fresh", "--jobs", "2", "--assignment", DISKS])
        .args(&folders)
        .spawn()
        .expect("it starts");
    let status = loop {
        let grades = fs::read_to_string(out.join("grades.csv")).unwrap_or_default();
        if let Some(status) = grading.try_wait().expect("it is ours") {
            break status;
        }
        has_marks_early |= grades.contains(",right,20,20,graded,") && grades.contains("not graded");
        std::thread::sleep(Duration::from_millis(10));
    };
    assert!(status.success(), "{status}");
    assert!(has_marks_early, "nobody had a mark before the end");
    let result = |who: &str| -> Value {
        let path = out.join("submissions").join(who).join("result.json");
        let text = fs::read_to_string(path).expect("it was written");
        serde_json::from_str(&text).expect("it is JSON")
    };
    assert_eq!(result("right")["points"], 20);
    let asleep = result("asleep");
    assert_eq!(
        (&asleep["outcome"], &asleep["points"]),
        (&"timed out".into(), &0.into())
    );
    // It is asked four times, and could be silent for 10 s each time.
    let seconds = asleep["timings"]["asking"].as_f64().expect("a number");
    assert!(seconds < 20.0, "{seconds} s");
}

#[test]
fn goldens_match_and_the_grading_meets_every_target() {
    run(&["golden", "verify"])
        .expect_code(0)
        .expect_out("films by Mitsuba");
    let document = run(&["validate", "--json"]).expect_code(0).json();
    assert_eq!(document["faults"], json!([]));
    assert_eq!(document["pristine"]["reference"], json!([20, 20]));
    for (part, count) in [("mistakes", 2), ("rewrites", 2), ("variants", 1)] {
        let judged = document[part]["judged"].as_array().map(Vec::len);
        assert_eq!(judged, Some(count), "{part}");
    }
}

#[test]
fn name_that_matches_nothing_is_an_error() {
    run(&["validate", "--named", "no_such_thing"])
        .expect_code(2)
        .expect_err("nothing to judge has \"no_such_thing\" in its name");
}

/// A copy of the assignment's folders that one test may change.
pub fn copy(test: &str) -> PathBuf {
    let course = fresh(&trusted(), test);
    let from = root().join("tools/instructor/tests/fixture");
    let mut folders = vec![from.clone()];
    while let Some(folder) = folders.pop() {
        let to = course.join(folder.strip_prefix(&from).expect("it is in that folder"));
        fs::create_dir_all(&to).expect("a folder can be made");
        for entry in fs::read_dir(folder).expect("it can be read").flatten() {
            match entry.path().is_dir() {
                true => folders.push(entry.path()),
                false => drop(fs::copy(entry.path(), to.join(entry.file_name()))),
            }
        }
    }
    course.join("assignments/disks")
}

#[test]
fn files_that_a_person_may_have_written_are_replaced_only_with_force() {
    let copy = copy("fixture-overwritten");
    let answer = copy.join("handout/src/disk.rs");
    let stub = fs::read_to_string(&answer).expect("it was copied");
    let mine = stub.replace("todo!(\"disk\")", "None // my answer");
    assert_ne!(mine, stub);
    fs::write(&answer, &mine).expect("it can be written");
    let line = ["handout", "--assignment", plain(&copy)];
    pinhole(&line)
        .expect_code(2)
        .expect_err("disk.rs would be overwritten");
    assert_eq!(fs::read_to_string(&answer).ok(), Some(mine));
    pinhole(&[&line[..], &["--force"]].concat()).expect_code(0);
    assert_eq!(fs::read_to_string(&answer).ok(), Some(stub));
    pinhole(&line).expect_code(0);

    for scenes in [&[][..], &["coins"]] {
        let line = [
            &["golden", "render"],
            scenes,
            &["--assignment", plain(&copy)],
        ]
        .concat();
        pinhole(&line)
            .expect_code(2)
            .expect_err("films that this command would replace")
            .expect_err("pass --force");
    }
}

#[test]
fn films_stay_as_they_are_until_all_new_ones_are_made() {
    let copy = copy("fixture-killed");
    let film = copy.join("../../golden/disks/coins.exr");
    let old = fs::read(&film).expect("it was copied");
    let scene = fs::read_to_string(copy.join("scenes/coins.toml")).expect("it was copied");
    let moved = fresh(&trusted(), "staging").join("coins.toml");
    fs::write(
        &moved,
        scene.replace("eye = [0.2, 0.9, 4.3]", "eye = [0.1, 0.7, 4.1]"),
    )
    .expect("it can be written");
    let folder = film.parent().expect("it has one").to_owned();
    let line = [
        "golden",
        "render",
        plain(&moved),
        "--out",
        plain(&folder),
        "--no-mistakes",
        "--assignment",
        plain(&copy),
        "--force",
    ];
    let mut killed = Command::new(program_of("golden"))
        .current_dir(root())
        .args(line)
        .spawn()
        .expect("it starts");
    while !folder.join(".rendering").exists() {
        assert!(matches!(killed.try_wait(), Ok(None)), "it is at work");
    }
    killed
        .kill()
        .and_then(|()| killed.wait())
        .expect("it can be killed");
    assert_eq!(fs::read(&film).ok(), Some(old.clone()));
    // What the killed process left behind does not interfere.
    fs::create_dir_all(folder.join(".rendering")).expect("a folder can be made");
    fs::write(folder.join(".rendering/coins.exr"), "half").expect("it can be written");
    pinhole(&line).expect_code(0);
    assert_ne!(fs::read(&film).ok(), Some(old));
    assert!(!folder.join(".rendering").exists());
}

#[test]
fn a_scene_that_is_refused_leaves_all_goldens_in_the_manifest() {
    let copy = copy("fixture-refused");
    // The middle pixel's centre lies on the disk's edge.
    let scene = r#"
[camera]
projection = "perspective"
eye = [0, 0, 0]
view = [0, 0, -1]
up = [0, 1, 0]
focal_length = 1
width = 2
height = 2
resolution = [5, 5]

[[object]]
type = "disk"
center = [1, 0, -2]
normal = [0, 0, 1]
radius = 1
"#;
    fs::write(copy.join("scenes/coins.toml"), scene).expect("it can be written");
    let manifest = copy.join("../../golden/disks/manifest.toml");
    let old = fs::read(&manifest).expect("it was copied");
    let line = ["golden", "render", "--force", "--assignment", plain(&copy)];
    pinhole(&line).expect_code(2).expect_err("lie on edges");
    assert_eq!(fs::read(&manifest).ok(), Some(old));
}

#[test]
fn a_students_repository_has_the_assignment_in_its_usual_place() {
    let out: PathBuf = fresh(&trusted(), "fixture-handout").join("students");
    run(&["handout", "--check"]).expect_code(0);
    run(&["handout", "--out", plain(&out)]).expect_code(0);
    let stub = fs::read_to_string(out.join("assignments/disks/handout/src/disk.rs"));
    assert!(stub.is_ok_and(|stub| stub.contains("todo!(\"disk\")")));
    let readme = fs::read_to_string(out.join("README.md")).expect("it has one");
    assert!(readme.contains("assignments/disks/handout/src"), "{readme}");
    assert!(!readme.contains("assignments/ray_casting"), "{readme}");
    for gone in [
        "assignments/ray_casting",
        "assignments/disks/reference",
        "golden/disks/ties",
        "tools/instructor",
    ] {
        assert!(!out.join(gone).exists(), "{gone}");
    }

    let cargo = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--offline",
            "--locked",
            "--no-deps",
            "--format-version",
            "1",
        ])
        .current_dir(&out)
        .output()
        .expect("cargo starts");
    let said = String::from_utf8_lossy(&cargo.stderr);
    assert!(cargo.status.success(), "{said}");
    let metadata: Value = serde_json::from_slice(&cargo.stdout).expect("it is JSON");
    let packages = metadata["packages"].as_array().expect("a list");
    let names: Vec<&str> = packages
        .iter()
        .filter_map(|it| it["name"].as_str())
        .collect();
    assert!(
        names.contains(&"disks-handout") && names.contains(&"pinhole-cli"),
        "{names:?}"
    );
    let default = &metadata["metadata"]["pinhole"]["default-assignment"];
    assert_eq!(default, "disks");
    let goldens = out.join("golden/disks");
    run(&["golden", "verify", plain(&goldens)]).expect_code(0);
}

#[test]
fn a_film_of_an_instructors_own_scene_is_diagnosed_by_diff() {
    let folder = fresh(&trusted(), "own-scene");
    let scene = folder.join("coin.toml");
    let text = fs::read_to_string(root().join(part("scenes/coins.toml"))).expect("a scene");
    let text = text.replace("eye = [0.2, 0.9, 4.3]", "eye = [0.1, 0.7, 4.1]");
    fs::write(&scene, text).expect("it can be written");
    let (scene, mine, films) = (plain(&scene), folder.join("mine"), folder.join("films"));
    run(&["golden", "render", scene, "--out", plain(&mine)])
        .expect_code(0)
        .expect_out("known mistakes makes in 1 films");
    run(&["golden", "verify", plain(&mine)]).expect_code(0);
    run(&["golden", "mistakes", plain(&mine)]).expect_code(0);
    run(&["golden", "verify", plain(&mine)]).expect_code(0);

    let wrong = part("mistakes/disk_radius_not_squared/rewrite");
    let line = ["render", scene, "--submission", &wrong, "--out"];
    run(&[&line[..], &[plain(&films)]].concat()).expect_code(0);
    let (golden, film) = (mine.join("coin.exr"), films.join("film.exr"));
    let line = ["diff", plain(&golden), plain(&film)];
    let verdict = run(&[&line[..], &["--json"]].concat())
        .expect_code(1)
        .json();
    let named = &verdict["diagnosis"]["beliefs"][0]["mistake"];
    assert_eq!(named, "disk_radius_not_squared");
    run(&line).expect_code(1).expect_out("You may believe: “");
}
