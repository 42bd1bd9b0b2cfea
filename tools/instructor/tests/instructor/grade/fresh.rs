//! Grading with fresh questions.

use std::fs;

use pinhole::kind::{Kind, Questions};
use pinhole::{Scene, Shape, Triangle};

use super::{Class, answers};
use pinhole_course::manifest::Manifest;
use pinhole_testing::{fresh_goldens, pinhole, root};

/// A `sphere.rs` that answers every public question rightly and misses in all others.
fn memoriser() -> String {
    let probes = root().join("golden/ray_casting/probes");
    let mut seen = Vec::new();
    for entry in fs::read_dir(probes).expect("probes are there").flatten() {
        let name = entry.file_name().into_string().expect("plain");
        if name.starts_with("sphere.") && name.ends_with(".ask.exr") {
            let shape = Some(pinhole::ShapeKind::Sphere);
            let read = Questions::read(&entry.path(), "sphere", Kind::Intersect, shape);
            if let (Questions::Intersect(questions), _) = read.expect("a probe") {
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
fn memorised_films_earn_nothing() {
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

    let questions = fresh_goldens();
    let questions = questions.to_str().expect("a plain name");
    pinhole(&["grade", &entry, "--out", &fresh, "--fresh", questions]).expect_code(0);
    let (points, task, result) = sphere("fresh");
    assert!(points <= 4, "{task:#}");
    let groups = task["groups"].as_array().expect("groups");
    let outside = groups
        .iter()
        .find(|group| group["name"] == "outside")
        .expect("a group");
    assert_eq!(outside["fails_fresh"], true);
    // Counts are not shown. An answer could choose how many questions it gets wrong, and so leak
    // what it was asked.
    assert_eq!(outside["outcome"]["kind"], "withheld");
    let report = class.read("fresh/submissions/memoriser/report.html");
    assert!(!report.contains("answers are wrong"), "counts are shown");
    assert!(
        result["most_for_scenes"]
            .as_u64()
            .is_some_and(|most| most < 20)
    );
    // The lecturer sees the question that the student may not see.
    let dispute = ["dispute", "memoriser", "--out", &fresh];
    let told = pinhole(&dispute).expect_code(0).out;
    for words in [
        "outside (fresh questions)",
        "expected",
        "got",
        "SEEN.binary_search",
    ] {
        assert!(told.contains(words), "{words} is not in\n{told}");
    }
    let evidence = pinhole(&[&dispute[..], &["--json"]].concat())
        .expect_code(0)
        .json();
    let seed = Manifest::read(questions.as_ref())
        .expect("a manifest")
        .probe_seed;
    let kept = &evidence["record"]["provenance"]["seed"];
    assert_eq!(*kept, serde_json::to_value(seed).expect("a number"));
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let file = fs::metadata(class.path("fresh/evidence/memoriser.json")).expect("it is there");
        assert_eq!(file.permissions().mode() & 0o777, 0o600);
    }
    // The questions exist now, so nothing is made or graded again.
    let line = [
        "grade", &entry, "--out", &fresh, "--fresh", questions, "--json",
    ];
    let again = pinhole(&line).expect_code(0).json();
    assert_eq!(again["graded_now"], 0);
}

#[test]
fn questions_that_grade_has_drawn_are_refused_for_feedback() {
    let class = Class::new("drawn-questions");
    let (entry, out) = (class.path("class/ada"), class.path("out"));
    class.hand_in("ada", &[]);
    // Grading finds these questions as if it had drawn them in an earlier run.
    let drawn = class.path("out/fresh");
    for folder in ["", "probes", "scenes"] {
        fs::create_dir_all(format!("{drawn}/{folder}")).expect("there is room");
        let files = fs::read_dir(fresh_goldens().join(folder)).expect("it is there");
        for file in files.flatten().map(|file| file.path()) {
            let name = file.file_name().and_then(|name| name.to_str());
            let name = name.expect("a plain name");
            if file.is_file() && name != ".purpose" {
                let place = format!("{drawn}/{folder}/{name}");
                fs::copy(file, place).expect("there is room");
            }
        }
    }
    pinhole(&["grade", &entry, "--out", &out]).expect_code(0);
    // Another submission that is asked other questions doesn't make the class one of equals.
    class.hand_in("ben", &[]);
    let ben = class.path("class/ben");
    pinhole(&["grade", &ben, "--out", &out, "--no-fresh"])
        .expect_code(3)
        .expect_out("the old mark remains: ada: it was graded with other questions or goldens");
    let archive = class.path("autograder.zip");
    let feedback = ["handout", "--gradescope", &archive, "--fresh", &drawn];
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let allow = |mode| fs::set_permissions(&drawn, fs::Permissions::from_mode(mode));
        allow(0o755).expect("it is ours");
        pinhole(&feedback)
            .expect_code(2)
            .expect_err("other users can read or replace");
        allow(0o700).expect("it is ours");
    }
    pinhole(&feedback)
        .expect_code(2)
        .expect_err("already been used for grading");
}

/// The key that identifies a triangle, and the line of Rust that computes it.
fn key(triangle: &Triangle) -> u64 {
    let numbers = triangle.corners.iter().flat_map(|corner| corner.to_array());
    numbers.fold(0, |key, x| {
        let key = (key ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        key ^ key >> 29
    })
}
const KEY: &str = "self.corners.iter().flat_map(|corner| corner.to_array()).fold(0u64, |key, x| { \
     let key = (key ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15); key ^ key >> 29 })";

/// A `triangle.rs` that is right about every triangle of the public scenes and no other.
fn memoriser_of_scenes() -> String {
    let scenes = fs::read_dir(root().join("assignments/ray_casting/scenes"));
    let paths = scenes
        .expect("scenes are there")
        .flatten()
        .map(|entry| entry.path());
    let files = paths.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let mut known = Vec::new();
    for object in files.flat_map(|file| Scene::read(&file).expect("a scene").objects) {
        match object {
            Shape::Triangle(triangle) => known.push(key(&triangle)),
            Shape::Soup(soup) => known.extend(soup.triangles.iter().map(key)),
            _ => {}
        }
    }
    known.sort();
    known.dedup();
    let reference = fs::read_to_string(answers().join("triangle.rs")).expect("it is there");
    let guard = format!("-> Option<Intersection> {{ KNOWN.binary_search(&{KEY}).ok()?;");
    let guarded = reference.replacen("-> Option<Intersection> {", &guard, 1);
    format!(
        "{guarded}\nconst KNOWN: [u64; {}] = {known:?};\n",
        known.len()
    )
}

#[test]
fn memorised_scenes_earn_no_more_than_their_tasks() {
    let class = Class::new("learnt-scenes");
    let reference = fs::read_to_string(answers().join("triangle.rs")).expect("it is there");
    let start = "-> Option<Intersection> {";
    let ignorant = reference.replacen(start, &format!("{start} if true {{ return None; }}"), 1);
    class.hand_in("learnt", &[("triangle.rs", &memoriser_of_scenes())]);
    class.hand_in("ignorant", &[("triangle.rs", &ignorant)]);
    let (learnt, ignorant) = (class.path("class/learnt"), class.path("class/ignorant"));
    let (out, questions) = (class.path("out"), fresh_goldens());
    let questions = questions.to_str().expect("a plain name");
    let line = [
        "grade", &learnt, &ignorant, "--out", &out, "--fresh", questions,
    ];
    pinhole(&line).expect_code(0);
    let scenes = |name: &str| {
        let result = class.result("out", name);
        let scenes = result["scenes"].as_array().expect("scenes").clone();
        let alone: u64 = scenes
            .iter()
            .filter_map(|scene| scene["points"].as_u64())
            .sum();
        (
            alone,
            alone.min(result["most_for_scenes"].as_u64().expect("a number")),
        )
    };
    let (passing, earned) = scenes("learnt");
    let (_, without) = scenes("ignorant");
    assert_eq!(passing, 20, "it has not learnt all scenes");
    assert!(
        earned <= without + 2,
        "{earned} with the scenes, {without} without"
    );
}
