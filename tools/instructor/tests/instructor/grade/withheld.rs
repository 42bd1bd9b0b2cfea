//! The instructor's own goldens: what results show of them, and that changes are
//! noticed.

use std::fs;

use serde_json::Value;

use super::{Class, answers, on_small_assignment};
use pinhole_testing::root;

/// A folder of goldens as `golden render SCENE --out` makes it, with films and a manifest but no
/// questions.
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
    let (bob, loud) = (class.path("class/bob"), class.path("class/loud"));
    for reveal in ["points", "message", "picture", "full"] {
        let out = class.path(reveal);
        let shown = ["--golden", &mine, "--reveal", reveal];
        let line = ["grade", &bob, &loud, "--out", &out, "--no-fresh"];
        on_small_assignment(&[&line[..], &shown].concat()).expect_code(0);
        let report = class.read(&format!("{reveal}/submissions/bob/report.html"));
        let shows = |text: &str| report.contains(text);
        assert_eq!(
            shows("data:image"),
            ["picture", "full"].contains(&reveal),
            "{reveal}"
        );
        assert_eq!(shows("class=\"viewer\""), reveal == "full", "{reveal}");
        let bob = class.result(reveal, "bob");
        let outcome = &bob["scenes"][0]["outcome"];
        let (kind, failing) = match reveal {
            "points" | "message" => ("withheld", None),
            _ => ("judged", Some(true)),
        };
        assert_eq!(outcome["kind"], kind, "{reveal}: {outcome}");
        let is_wrong = outcome["failing"].as_u64().map(|failing| failing > 0);
        assert_eq!(is_wrong, failing, "{reveal}: {outcome}");
        assert_eq!(bob["scenes"][0]["seconds"], Value::Null);
        assert_eq!(
            bob["scenes"].to_string().contains("worst"),
            reveal == "full",
            "{reveal}: {outcome}"
        );
        assert_eq!(
            (&bob["scenes"][0]["points"], &bob["possible"]),
            (&0.into(), &100.into())
        );
        let loud = class.result(reveal, "loud");
        assert_eq!(
            (&loud["scenes"][0]["outcome"]["ended"], &loud["printed"]),
            (&"panicked".into(), &"".into())
        );
        assert!(
            !loud["scenes"].to_string().contains("told by"),
            "{reveal}: {loud:#}"
        );
    }
}

#[test]
fn changed_goldens_are_refused_for_grading() {
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
