//! Questions that nobody has seen.

use std::fs;

use pinhole::kind::{Kind, Questions};

use super::{Class, answers};
use pinhole_testing::{fresh_goldens, pinhole, root};

/// `sphere.rs` that is right about every public question and says no to all others.
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
    assert!(
        result["most_for_scenes"]
            .as_u64()
            .is_some_and(|most| most < 20)
    );
    // The questions are there now: nothing is made or graded again.
    let line = [
        "grade", &entry, "--out", &fresh, "--fresh", questions, "--json",
    ];
    let again = pinhole(&line).expect_code(0).json();
    assert_eq!(again["graded_now"], 0);
}
