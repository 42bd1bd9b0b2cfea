//! The instructor's own goldens: what results show of them, and that changes are
//! noticed.

use std::fs;

use serde_json::Value;

use super::{Class, answers, on_small_assignment};
use pinhole_testing::{fresh, fresh_goldens, pinhole, root, small_assignment, trusted};

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
        let ended = if reveal == "points" {
            "graded"
        } else {
            "panicked"
        };
        assert_eq!(
            (&loud["scenes"][0]["outcome"]["ended"], &loud["printed"]),
            (&ended.into(), &"".into())
        );
        assert!(
            !loud["scenes"].to_string().contains("told by"),
            "{reveal}: {loud:#}"
        );
    }
}

#[test]
fn wrong_answers_to_public_questions_show_nothing_of_a_withheld_scene() {
    let class = Class::new("withheld-camera");
    let mine = goldens_of_one_scene(&class, "inside_a_sphere");
    let reference = fs::read_to_string(answers().join("viewing_ray.rs")).expect("it is there");
    // A scene asks about many more pixels of one camera than any public question. The answers to
    // public questions wait until a scene has been seen.
    let told = reference.replacen(
        "// ANCHOR: answer\n",
        "use std::sync::Mutex;
        static LAST: Mutex<(u64, u32)> = Mutex::new((0, 0));
        static SEEN: Mutex<Option<f64>> = Mutex::new(None);
        static BEGUN: std::sync::LazyLock<std::time::Instant> =
            std::sync::LazyLock::new(std::time::Instant::now);
        {
            let mut last = LAST.lock().unwrap();
            let key = camera.eye.x.to_bits() ^ camera.width.to_bits();
            *last = if last.0 == key { (key, last.1 + 1) } else { (key, 0) };
            if last.1 == 1000 {
                *SEEN.lock().unwrap() = Some(camera.width);
            }
        }
        while SEEN.lock().unwrap().is_none() && BEGUN.elapsed().as_millis() < 500 {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        if let Some(width) = *SEEN.lock().unwrap() {
            let told = glam::DVec3::new(4242.0, width, 0.0);
            return Ray { origin: told, direction: told };
        }
",
        1,
    );
    class.hand_in("mallory", &[("viewing_ray.rs", &told)]);
    let (mallory, out) = (class.path("class/mallory"), class.path("out"));
    let line = ["grade", &mallory, "--out", &out, "--no-fresh"];
    on_small_assignment(&[&line[..], &["--golden", &mine]].concat()).expect_code(0);
    let result = class.result("out", "mallory");
    let report = class.read("out/submissions/mallory/report.html");
    for shown in [result.to_string(), report] {
        assert!(!shown.contains("4242"), "{}", result["tasks"][0]);
    }
}

#[test]
fn fresh_tasks_are_asked_before_a_withheld_scene_and_fresh_scenes_after_it() {
    let class = Class::new("withheld-before-fresh");
    let mine = goldens_of_one_scene(&class, "inside_a_sphere");
    let reference = fs::read_to_string(answers().join("viewing_ray.rs")).expect("it is there");
    // Each process prints when it is asked first.
    let told = reference.replacen(
        "// ANCHOR: answer\n",
        "static ONCE: std::sync::Once = std::sync::Once::new();
        ONCE.call_once(|| {
            let now = std::time::SystemTime::UNIX_EPOCH.elapsed().unwrap();
            println!(\"{}\", now.as_micros());
        });
",
        1,
    );
    class.hand_in("mallory", &[("viewing_ray.rs", &told)]);
    let (mallory, out) = (class.path("class/mallory"), class.path("out"));
    let questions = fresh_goldens();
    let questions = questions.to_str().expect("a plain name");
    let line = ["grade", &mallory, "--out", &out, "--fresh", questions];
    pinhole(&[&line[..], &["--golden", &mine]].concat()).expect_code(0);
    let evidence: Value =
        serde_json::from_str(&class.read("out/evidence/mallory.json")).expect("JSON");
    let [public, fresh] = ["public", "fresh"].map(|part| {
        let printed = evidence[part]["printed"].as_str().expect("a text");
        let times = printed.lines().map(|line| line.parse::<u64>());
        times.collect::<Result<Vec<_>, _>>().expect("times")
    });
    // The last process of each part casts scenes.
    let [scene, fresh_scene] = [&public, &fresh].map(|times| times.last().expect("a scene"));
    assert!(fresh[0] > public[0], "{public:?} {fresh:?}");
    assert!(fresh[0] < *scene, "{public:?} {fresh:?}");
    assert!(scene < fresh_scene, "{public:?} {fresh:?}");
}

#[test]
fn films_of_public_scenes_show_nothing_of_a_withheld_scene() {
    let class = Class::new("withheld-among-public");
    let reference = fs::read_to_string(answers().join("viewing_ray.rs")).expect("it is there");
    // Once a pixel of `inside_a_sphere` was seen, the rays of other scenes go astray. They wait for
    // that.
    let told = reference.replacen(
        "// ANCHOR: answer\n",
        "use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
        static SEEN: AtomicBool = AtomicBool::new(false);
        static BEGUN: std::sync::LazyLock<std::time::Instant> =
            std::sync::LazyLock::new(std::time::Instant::now);
        if (resolution.n_x, resolution.n_y) == (140, 80) {
            SEEN.store(true, Relaxed);
        } else {
            while !SEEN.load(Relaxed) && BEGUN.elapsed().as_millis() < 500 {
                std::thread::sleep(std::time::Duration::from_millis(1));
            }
            if SEEN.load(Relaxed) {
                return Ray { origin: camera.eye, direction: camera.w };
            }
        }
",
        1,
    );
    class.hand_in("mallory", &[("viewing_ray.rs", &told)]);
    let assignment = small_assignment(&fresh(&trusted(), "withheld-among-public"));
    let file = assignment.join("assignment.toml");
    let text = fs::read_to_string(&file).expect("it is there");
    let passing = |out: &str| {
        let (mallory, to) = (class.path("class/mallory"), class.path(out));
        let assignment = assignment.to_str().expect("a plain name");
        let line = ["grade", &mallory, "--out", &to, "--no-fresh"];
        pinhole(&[&line[..], &["--assignment", assignment]].concat()).expect_code(0);
        let result = class.result(out, "mallory");
        let scenes = result["scenes"].as_array().expect("a list").clone();
        let passing = scenes.iter().filter(|it| it["points"] == it["possible"]);
        passing.map(|it| it["name"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(
        passing("public"),
        ["inside_a_sphere"],
        "one process casts all"
    );
    let row = "name = \"inside_a_sphere\"\n";
    fs::write(&file, text.replace(row, &format!("{row}public = false\n"))).expect("writable");
    assert_eq!(passing("withheld").len(), 3);
}

#[test]
fn a_result_says_nothing_of_a_withheld_scene_but_that_it_fails() {
    let class = Class::new("withheld-wrong");
    let reference = fs::read_to_string(answers().join("viewing_ray.rs")).expect("it is there");
    let mistaken = reference.replace("as f64 + 0.5)", "as f64)");
    // What the code does at some pixels of the withheld scene, and nowhere else.
    let there = "if (resolution.n_x, resolution.n_y) == (140, 80) && pixel.i % 3 == 1";
    let astray = "return Ray { origin: camera.eye, direction: camera.u };";
    for (name, code, does) in [
        ("plain", &mistaken, ""),
        ("noisy", &mistaken, astray),
        ("astray", &reference, astray),
        ("busy", &reference, "loop {}"),
        ("loud", &reference, "panic!();"),
    ] {
        let anchor = "// ANCHOR: answer\n";
        let code = code.replacen(anchor, &format!("{anchor}{there} {{ {does} }}\n"), 1);
        class.hand_in(name, &[("viewing_ray.rs", &code)]);
    }
    let assignment = small_assignment(&fresh(&trusted(), "withheld-wrong"));
    let file = assignment.join("assignment.toml");
    let text = fs::read_to_string(&file).expect("it is there");
    let row = "name = \"inside_a_sphere\"\n";
    fs::write(&file, text.replace(row, &format!("{row}public = false\n"))).expect("writable");
    let own = ["plain", "noisy", "astray", "busy", "loud"];
    let own = own.map(|name| class.path(&format!("class/{name}")));
    let own = own.each_ref().map(String::as_str);
    let out = class.path("out");
    let assignment = assignment.to_str().expect("a plain name");
    let rest = ["--out", &out, "--no-fresh", "--assignment", assignment];
    pinhole(&[&["grade"], &own[..], &rest].concat()).expect_code(0);
    let said = |name: &str| {
        let result = class.result("out", name);
        (result["tasks"].clone(), without_seconds(&result["scenes"]))
    };
    assert!(
        said("plain")
            .0
            .to_string()
            .contains("viewing_ray_half_pixel_missing")
    );
    for (one, other) in [("plain", "noisy"), ("astray", "busy"), ("astray", "loud")] {
        assert_eq!(said(one), said(other), "{other}");
    }
}

/// Scenes that say only whether it was measured how long casting them took.
fn without_seconds(scenes: &Value) -> Value {
    let mut scenes = scenes.clone();
    for scene in scenes.as_array_mut().expect("a list") {
        scene["seconds"] = scene["seconds"].is_null().into();
    }
    scenes
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
        .expect_err("inside_a_sphere.exr has changed since the goldens were made")
        .expect_err("other users can read or replace");
    let (ada, out) = (class.path("class/ada"), class.path("out"));
    on_small_assignment(&["grade", &ada, "--out", &out, "--fresh", &mine])
        .expect_code(2)
        .expect_err("other users can read or replace");
    // Somebody may still decide what a link to a missing folder leads to.
    let link = class.path("link");
    std::os::unix::fs::symlink(class.path("absent"), &link).expect("there is room");
    for option in ["--fresh", "--golden"] {
        on_small_assignment(&["grade", &ada, "--out", &out, option, &link])
            .expect_code(2)
            .expect_err(&format!("cannot read {link}"));
    }
    assert!(!class.folder.join("out/grades.csv").exists());
}

#[test]
fn goldens_that_the_reference_fails_are_refused_for_grading() {
    let class = Class::new("contradicted-goldens");
    let assignment = small_assignment(&fresh(&trusted(), "contradicted"));
    let plane = assignment.join("reference/src/plane.rs");
    let right = fs::read_to_string(&plane).expect("it is there");
    let wrong = right.replace("t >= min_t", "t >= 0.0");
    assert_ne!(right, wrong, "the reference compares as this test expects");
    fs::write(&plane, wrong).expect("writable");
    let assignment = assignment.to_str().expect("a plain name");
    let (ada, out) = (class.path("class/ada"), class.path("out"));
    let names = ["grade", &ada, "--out", &out, "--assignment", assignment];
    pinhole(&[&names[..], &["--no-fresh"]].concat())
        .expect_code(3)
        .expect_err("the reference does not match the golden of plane, min_t in ");
    assert!(!class.folder.join("out/grades.csv").exists());
}
