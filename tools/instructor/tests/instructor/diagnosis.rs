//! Diagnoses of wrong films: the belief that explains them, or none.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use pinhole_testing::{fresh, pinhole, root, submission, trusted};

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

/// A submission with the belief of `slug`, made from other code than the one whose films are
/// stored.
fn student(name: &str, slug: &str) -> PathBuf {
    let mistakes = root().join("assignments/ray_casting/mistakes");
    let rewrite = mistakes.join(slug).join("rewrite");
    let entries = fs::read_dir(rewrite).expect("the mistake has a rewrite");
    let files: Vec<(String, String)> = entries
        .flatten()
        .map(|entry| {
            let name = entry.file_name().into_string().expect("plain names");
            (
                name,
                fs::read_to_string(entry.path()).expect("answers are text"),
            )
        })
        .collect();
    let overlay: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (name.as_str(), text.as_str()))
        .collect();
    submission(&trusted(), name, &overlay)
}

fn named(diagnosis: &Value) -> Vec<&str> {
    let beliefs = diagnosis["beliefs"].as_array().into_iter().flatten();
    beliefs
        .map(|belief| belief["mistake"].as_str().expect("a name"))
        .collect()
}

/// The rows of `kind` that do not pass.
fn failing<'a>(examination: &'a Value, kind: &str) -> Vec<&'a Value> {
    let rows = examination[kind].as_array().expect("a list").iter();
    rows.filter(|row| row["points"] != row["possible"])
        .collect()
}

#[test]
fn a_belief_in_new_code_is_named_in_its_task_and_in_every_scene_it_spoils() {
    let folder = student("diagnosed", "sphere_near_root_only");
    let ran = pinhole(&["check", plain(&folder), "--json"]).expect_code(1);
    let examination = ran.json();
    let faults = crate::grade::faults("outcome.schema.json", &examination);
    assert!(faults.is_empty(), "{faults}");
    let [sphere] = failing(&examination, "tasks")[..] else {
        panic!("only the sphere is wrong: {examination:#}")
    };
    assert_eq!(named(&sphere["diagnosis"]), ["sphere_near_root_only"]);
    assert_eq!(sphere["diagnosis"]["beliefs"][0]["explained"], 1.0);
    let scenes = failing(&examination, "scenes");
    assert!(scenes.len() >= 3, "{examination:#}");
    for scene in scenes {
        assert_eq!(named(&scene["diagnosis"]), ["sphere_near_root_only"]);
    }
}

#[test]
fn table_shows_the_belief_and_the_first_hint_only() {
    let folder = student("told", "sphere_near_root_only");
    let sphere = ["check", plain(&folder), "--task", "sphere"];
    let hint = &pinhole(&[&sphere[..], &["--json"]].concat()).json()["tasks"][0]["diagnosis"]["beliefs"]
        [0]["hint"];
    let text = |depth: &str| hint[depth].as_str().expect("a text").to_owned();
    let ran = pinhole(&sphere)
        .expect_code(1)
        .expect_out("You may believe: “I only need the smaller root")
        .expect_out(&text("look"));
    assert!(!ran.out.contains(&text("think")), "{}", ran.out);
}

#[test]
fn scenes_asked_alone_are_diagnosed_together() {
    let folder = student("scenes", "sphere_near_root_only");
    let scenes = ["inside_a_sphere", "inside_a_box", "teapot_orthographic"];
    let mut line = vec!["check", plain(&folder), "--json"];
    for scene in scenes {
        line.extend(["--scene", scene]);
    }
    let examination = pinhole(&line).expect_code(1).json();
    for scene in examination["scenes"].as_array().expect("a list") {
        let names = named(&scene["diagnosis"]);
        assert!(names.contains(&"sphere_near_root_only"), "{scene:#}");
    }
}

#[test]
fn unknown_mistake_gets_no_name_but_is_measured() {
    let never = "use pinhole::{Intersection, Ray, Sphere};\nuse crate::intersect_ray::IntersectRay;\n\
                 impl IntersectRay for Sphere {\n    fn intersect_ray(&self, _: &Ray, _: f64) -> \
                 Option<Intersection> {\n        None\n    }\n}\n";
    let folder = submission(&trusted(), "never", &[("sphere.rs", never)]);
    let examination = pinhole(&["check", plain(&folder), "--json"])
        .expect_code(1)
        .json();
    for kind in ["tasks", "scenes"] {
        let failing = failing(&examination, kind);
        assert!(!failing.is_empty());
        for row in failing {
            assert_eq!(row["diagnosis"], Value::Null, "{row:#}");
        }
    }
    let says = &examination["tasks"][1]["measured"][0]["says"];
    let says = says.as_str().expect("a sentence");
    assert!(says.starts_with("You miss all"), "{says}");
    pinhole(&["check", plain(&folder), "--task", "sphere"]).expect_out(says);
}

#[test]
fn mistakes_that_changed_since_they_were_fingerprinted_are_noticed() {
    let folder = fresh(&trusted(), "stale-mistakes");
    let own = root().join("golden/ray_casting");
    let manifest = fs::read_to_string(own.join("manifest.toml")).expect("it is committed");
    let line = manifest
        .lines()
        .find(|line| line.contains("sphere_near_root_only/sphere.rs"))
        .expect("the mistakes are in the manifest");
    let (name, _hash) = line.split_once(" = ").expect("a key and a value");
    let stale = manifest.replace(line, &format!("{name} = \"0\""));
    fs::write(folder.join("manifest.toml"), stale).expect("it can be written");
    pinhole(&["golden", "verify", plain(&folder)])
        .expect_code(1)
        .expect_out("the mistakes have changed since the goldens were made");
}
