//! `pinhole check`, as students meet it.

use pinhole_testing::{RunResult, TASKS, fresh, pinhole, pinhole_in, root, submission, trusted};
use serde_json::Value;

/// Runs `check --json` on a folder. Checks only the tasks, which is quick, unless `more` selects
/// something else.
pub fn check(folder: &std::path::Path, more: &[&str]) -> RunResult {
    let folder = folder.to_str().expect("test folders have plain names");
    let tasks = TASKS.iter().flat_map(|task| ["--task", task]);
    let tasks: Vec<&str> = if more.contains(&"--scene") {
        Vec::new()
    } else {
        tasks.collect()
    };
    pinhole(&[&["check", folder, "--json"], tasks.as_slice(), more].concat())
}

pub fn task<'a>(examination: &'a Value, name: &str) -> &'a Value {
    let tasks = examination["tasks"].as_array().expect("tasks are a list");
    tasks
        .iter()
        .find(|task| task["name"] == name)
        .expect("the task was asked")
}

pub fn lost(examination: &Value, name: &str) -> i64 {
    let task = task(examination, name);
    task["possible"].as_i64().expect("a number") - task["points"].as_i64().expect("a number")
}

#[test]
fn reference_earns_every_point_from_both_judges() {
    let ran = pinhole(&[
        "check",
        "assignments/ray_casting/reference",
        "--json",
        "--oiiotool",
    ]);
    let examination = ran.expect_code(0).json();
    assert_eq!(examination["points"], 100, "{examination:#}");
    assert_eq!(examination["possible"], 100);
    assert_eq!(examination["passes"], true);
}

#[test]
fn handout_is_unanswered_in_every_task_without_panic_messages() {
    let ran = pinhole(&["check"]).expect_code(1).expect_out(" 0 / 100");
    assert_eq!(ran.out.matches("unanswered").count(), 6, "{}", ran.out);
    assert!(
        !ran.out.contains("panicked") && !ran.err.contains("panicked"),
        "{}",
        ran.err
    );
    assert!(ran.out.lines().count() < 45, "{}", ran.out);
}

#[test]
fn current_folder_is_checked_when_it_is_a_submission() {
    let ran = pinhole_in(
        &root().join("assignments/ray_casting/reference"),
        &["check", "--task", "plane", "--json"],
    );
    assert_eq!(ran.expect_code(0).json()["submission"], ".");
}

#[test]
fn scenes_are_cast_with_an_answer_of_an_earlier_assignment_only_if_it_passes() {
    let read = |path: &str| std::fs::read_to_string(root().join(path)).expect("it is committed");
    // What it prints shows whether it casts the scene.
    let loud = |path: &str| {
        let text = read(path);
        let loud = text.replacen(
            "        let [",
            "        println!(\"theirs\");\n        let [",
            1,
        );
        assert_ne!(loud, text);
        loud
    };
    let right = loud("assignments/ray_casting/reference/src/triangle.rs");
    let wrong = loud("assignments/ray_casting/mistakes/triangle_parallelogram/triangle.rs");
    let folder = fresh(&trusted(), "earlier");
    let own = folder.to_str().expect("plain");
    for task in ["triangle_box", "ray_box", "build_tree", "nearest_hit"] {
        let file = format!("{task}.rs");
        let text = read(&format!(
            "assignments/bounding_volumes/reference/src/{file}"
        ));
        std::fs::write(folder.join(file), text).expect("it is ours");
    }
    let check_with = |code, text: &str| {
        std::fs::write(folder.join("triangle.rs"), text).expect("it is ours");
        let scene = ["--scene", "lone_triangle", "--no-report", "--json"];
        let line = [
            &["check", own, "--assignment", "bounding_volumes"][..],
            &scene,
        ]
        .concat();
        let examination = pinhole(&line).expect_code(code).json();
        let printed = examination["printed"].as_str().expect("a text");
        let is_theirs = printed.starts_with("theirs");
        (examination["earlier"]["problem"].clone(), is_theirs)
    };
    let check = |text: &str| check_with(0, text);
    assert_eq!(check(&right), (Value::Null, true));
    let fails = Value::from("it fails the group `back`");
    assert_eq!(check(&wrong), (fails.clone(), false));
    let broken = format!("{right} let");
    assert_eq!(check(&broken), ("it does not compile here".into(), false));
    let reset = ["reset", "triangle", own, "--assignment", "bounding_volumes"];
    pinhole(&reset).expect_code(0);
    let given = std::fs::read_to_string(folder.join("triangle.rs")).expect("it is there");
    assert_eq!(check(&given), (Value::Null, false));
    // Where another answer needs something that only theirs has, ours can't cast the scenes.
    let needing = std::fs::read_to_string(folder.join("nearest_hit.rs")).expect("it is there");
    let needing = needing.replacen("// ANCHOR: answer", "crate::triangle::help();", 1);
    std::fs::write(folder.join("nearest_hit.rs"), needing).expect("it is ours");
    let helpful = |text: &str| format!("{text} pub fn help() {{}}");
    assert_eq!(check(&helpful(&right)), (Value::Null, true));
    assert_eq!(check_with(1, &helpful(&wrong)), (fails, true));
}

#[test]
fn a_stub_in_place_of_one_answer_costs_that_task_alone() {
    for stubbed in TASKS {
        let file = format!("{stubbed}.rs");
        let handout = root()
            .join("assignments/ray_casting/handout/src")
            .join(&file);
        let stub = std::fs::read_to_string(handout).expect("the handout has every stub");
        let folder = submission(&trusted(), &format!("stub-{stubbed}"), &[(&file, &stub)]);
        let examination = check(&folder, &[]).expect_code(1).json();
        for name in TASKS {
            let all = task(&examination, name)["possible"]
                .as_i64()
                .expect("a number");
            let expected = if name == stubbed { all } else { 0 };
            assert_eq!(
                lost(&examination, name),
                expected,
                "{name} beside a stub of {stubbed}"
            );
        }
    }
}

/// The path of a file as it opens from the top of the checkout.
pub fn from_root(folder: &str, file: &str) -> String {
    let path = std::path::Path::new(folder).join(file);
    let path = path
        .strip_prefix(pinhole_testing::root())
        .expect("it is inside");
    path.display().to_string()
}

#[test]
fn output_of_the_worst_question_and_warnings_are_reported() {
    let text = with_body(
        "plane",
        "let unused = 1; println!(\"min_t is {min_t}\"); return None;",
    );
    let folder = submission(&trusted(), "prints-one", &[("plane.rs", &text)]);
    let ran = check(&folder, &["--task", "plane"]).expect_code(1);
    let outcome = ran.json();
    let task = task(&outcome, "plane");
    let worst = task["groups"][0]["worst"].as_array().expect("a list");
    let fact = |label: &str| {
        let fact = worst.iter().find(|fact| fact["label"] == label);
        fact.unwrap_or_else(|| panic!("no {label} in {worst:?}"))["text"].clone()
    };
    let printed = fact("printed").as_str().expect("a text").to_owned();
    assert_eq!(
        printed.lines().count(),
        1,
        "of this question alone: {printed}"
    );
    let asked = fact("ray").as_str().expect("a text").to_owned();
    let (_, asked) = asked.split_once("min_t = ").expect("it has one");
    assert_eq!(printed[..12], format!("min_t is {asked}")[..12]);
    let warnings = task["warnings"].as_str().expect("a text");
    assert!(warnings.contains("unused variable: `unused`"), "{warnings}");
}

#[test]
fn packed_answers_are_a_submission_and_a_reset_answer_is_kept() {
    let folder = submission(&trusted(), "pack", &[("plane.rs", "fn mine() {}")]);
    let name = folder.to_str().expect("a plain name");
    let zip = folder.join("answers.zip");
    let zip = zip.to_str().expect("a plain name");
    pinhole(&["check", name, "--task", "sphere", "--pack", zip])
        .expect_code(0)
        .expect_out("answers.zip holds 6 answers; hand it in\n");
    pinhole(&["check", zip, "--trust", "--task", "sphere"]).expect_code(0);
    pinhole(&["reset", "plane", name])
        .expect_code(0)
        .expect_out("plane.rs.old");
    let kept = std::fs::read_to_string(folder.join("plane.rs.old"));
    assert_eq!(kept.expect("it is kept"), "fn mine() {}");
    pinhole(&["check", name, "--task", "plane", "--pack", zip])
        .expect_code(1)
        .expect_out("unanswered")
        .expect_out("holds 6 answers; `plane` is still the stub\n")
        .expect_out(&format!("edit: {}:", from_root(name, "plane.rs")));
    pinhole(&["reset", "no_such_task", name])
        .expect_code(2)
        .expect_err("name one of: ");
}

#[test]
fn packed_answers_with_all_points_are_ready_to_hand_in() {
    let folder = submission(&trusted(), "pack-all", &[]);
    let zip = folder.join("answers.zip");
    let zip = zip.to_str().expect("a plain name");
    let folder = folder.to_str().expect("a plain name");
    pinhole(&["check", folder, "--no-report", "--pack", zip])
        .expect_code(0)
        .expect_out("All 100 points")
        .expect_out(&format!("to hand in: {zip}"));
}

#[test]
fn a_compile_error_shows_only_the_compilers_messages_about_that_file() {
    let folder = submission(
        &trusted(),
        "compile-error",
        &[("plane.rs", "fn fine() {}\nfn broken( {")],
    );
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["check", folder, "--task", "plane", "--task", "sphere"]).expect_code(1);
    let place = format!("{}:2", from_root(folder, "plane.rs"));
    let ran = ran
        .expect_out("does not compile")
        .expect_out(&format!("--> {place}:13"))
        .expect_out(&format!("edit: {place}\n"));
    let ran = ran.expect_out("✓ sphere").expect_out("✗ plane");
    for alien in ["main.rs", "aborting", "intersect_ray.rs"] {
        assert!(!ran.out.contains(alien), "{alien} in:\n{}", ran.out);
    }
}

#[test]
fn a_deleted_impl_is_blamed_on_its_own_file() {
    let folder = submission(&trusted(), "deleted-impl", &[("plane.rs", "")]);
    std::fs::remove_file(folder.join("intersect_ray.rs")).expect("the copy has it");
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(
        task(&examination, "plane")["file"]["state"],
        "does not compile"
    );
    let said = task(&examination, "plane")["file"].to_string();
    let ours = "--> src/intersect_ray.rs:";
    assert!(said.contains(ours), "the folder has no such file: {said}");
    for name in TASKS.into_iter().filter(|name| *name != "plane") {
        assert_eq!(lost(&examination, name), 0, "{name}");
    }
}

#[test]
fn a_missing_file_costs_its_own_task() {
    let folder = submission(&trusted(), "missing-file", &[]);
    std::fs::remove_file(folder.join("sphere.rs")).expect("the copy has it");
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(task(&examination, "sphere")["file"]["state"], "missing");
    assert_eq!(lost(&examination, "plane"), 0);
}

#[test]
fn a_panic_is_reported_with_file_and_line() {
    let text = with_body(
        "plane",
        "let none: Vec<f64> = Vec::new();\n        let _ = none[3];",
    );
    let folder = submission(&trusted(), "panic", &[("plane.rs", &text)]);
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["check", folder, "--task", "plane"]).expect_code(1);
    let line = text
        .lines()
        .position(|line| line.contains("none[3]"))
        .expect("it is there")
        + 1;
    let place = format!("{}:{line}", from_root(folder, "plane.rs"));
    ran.expect_out(&format!(
        "your code panicked at {place}: index out of bounds"
    ))
    .expect_out(&format!("edit: {place}\n"));
}

/// Bodies that give no usable answer: their names, and code.
const STOPS: [(&str, &str); 4] = [
    ("panic", "let none: Vec<f64> = Vec::new(); let _ = none[3];"),
    (
        "loop",
        "while self.normal != ray.origin { std::hint::black_box(0); }",
    ),
    (
        "recursion",
        "return self.intersect_ray(ray, min_t).map(|at| Intersection { t: at.t + 1.0, ..at });",
    ),
    (
        "nan",
        "return Some(Intersection { t: f64::NAN, normal: self.normal });",
    ),
];

#[test]
fn pixel_that_stops_a_scene_is_shown() {
    for (name, body) in STOPS {
        // The scene is cast from its top row down, and only rays below the horizon stop.
        let text = with_body(
            "plane",
            &format!("if ray.direction.y < 0.0 && min_t == 1.0 {{ {body} }}"),
        );
        let folder = format!("stops-scene-{name}");
        let folder = submission(&trusted(), &folder, &[("plane.rs", &text)]);
        let folder = folder.to_str().expect("a plain name");
        let scene = "sphere_and_plane";
        let ran = pinhole(&["check", folder, "--scene", scene, "--timeout", "2"]).expect_code(1);
        let before = format!("no usable answer at this pixel: cargo pinhole explain {scene} ");
        let (_, pixel) = ran
            .out
            .split_once(&before)
            .unwrap_or_else(|| panic!("{}", ran.out));
        let row = pixel
            .split(' ')
            .nth(1)
            .and_then(|row| row.parse::<u32>().ok());
        assert!(row.expect("a number") < 80, "{name}: {}", ran.out);
    }
}

#[test]
fn question_that_stops_an_answer_is_shown() {
    for (name, body) in STOPS {
        let text = with_body("plane", &format!("if min_t > 0.4 {{ {body} }}"));
        let folder = submission(&trusted(), &format!("stops-{name}"), &[("plane.rs", &text)]);
        let folder = folder.to_str().expect("a plain name");
        let plane = [
            "check",
            folder,
            "--task",
            "plane",
            "--timeout",
            "2",
            "--json",
        ];
        let examination = pinhole(&plane).expect_code(1).json();
        let groups = task(&examination, "plane")["groups"].as_array();
        let facts = |group: &Value| group["worst"].as_array().cloned().unwrap_or_default();
        let shown: Vec<Value> = groups.expect("a list").iter().flat_map(facts).collect();
        let labels: Vec<_> = shown.iter().map(|fact| &fact["label"]).collect();
        assert_eq!(labels[..2], ["ray", "plane"], "{name}: {examination:#}");
        let note = labels.iter().any(|label| **label == "note");
        assert_eq!(note, name != "recursion", "{name}: {labels:?}");
        for ray in shown.iter().filter(|fact| fact["label"] == "ray") {
            let min_t = ray["text"]
                .as_str()
                .and_then(|text| text.split(" = ").last());
            assert!(
                min_t.expect("it is last").parse::<f64>().expect("a number") > 0.4,
                "{name}: {ray}"
            );
        }
    }
}

#[test]
fn exiting_early_or_printing_points_earns_nothing_and_harms_no_other_task() {
    let text = with_body(
        "plane",
        "println!(\"all tests passed\"); std::process::exit(0);",
    );
    let folder = submission(&trusted(), "exit", &[("plane.rs", &text)]);
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(task(&examination, "plane")["points"], 0);
    assert_eq!(lost(&examination, "sphere"), 0);
}

#[test]
fn answers_that_compute_nothing_earn_nothing() {
    let at_once = "Some(pinhole::Intersection { t: min_t, normal: glam::DVec3::Z })";
    let all_in_one = "Tree::Leaf((0..boxes.len()).collect())";
    let none = ["sphere", "plane", "triangle", "triangle_soup", "first_hit"].map(|it| (it, "None"));
    let hit = ["sphere", "plane", "triangle", "triangle_soup"].map(|it| (it, at_once));
    let none_of_boxes = [
        ("ray_box", "None"),
        ("build_tree", all_in_one),
        ("nearest_hit", "None"),
    ];
    for (assignment, answers) in [
        ("ray_casting", &none[..]),
        ("ray_casting", &hit),
        ("bounding_volumes", &none_of_boxes),
        ("bounding_volumes", &[("ray_box", "Some(min_t)")]),
    ] {
        let folder = fresh(&trusted(), "constant");
        for (task, answer) in answers {
            let file = format!("{task}.rs");
            let stub = root().join(format!("assignments/{assignment}/handout/src/{file}"));
            let stub = std::fs::read_to_string(stub).expect("the handout has it");
            let text = stub.replace(&format!("todo!({task:?})"), answer);
            assert_ne!(text, stub);
            std::fs::write(folder.join(file), text).expect("it can be written");
        }
        let folder = folder.to_str().expect("a plain name");
        let ran = pinhole(&["check", folder, "--assignment", assignment, "--json"]);
        let examination = ran.expect_code(1).json();
        for (task, answer) in answers {
            // It compiled and ran.
            let outcome = &self::task(&examination, task)["groups"][0]["outcome"];
            assert_eq!(outcome["kind"], "judged", "{task}: {answer}");
        }
        assert_eq!(examination["points"], 0, "{answers:?}");
    }
}

#[test]
fn endless_recursion_aborts_and_its_last_words_are_shown_as_its_own() {
    let text = with_body(
        "plane",
        "return self.intersect_ray(ray, min_t).map(|at| Intersection { t: at.t + 1.0, ..at });",
    );
    let folder = submission(&trusted(), "recursion", &[("plane.rs", &text)]);
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["check", folder, "--task", "plane"]).expect_code(1);
    ran.expect_out("it aborted, which happens when a function calls itself without end")
        .expect_out("the last line that it printed is “fatal runtime error: stack overflow");
}

#[test]
fn an_answer_that_needs_too_much_stack_costs_no_other_task() {
    let body = "std::hint::black_box([ray.origin.x; 1 << 19]); return None;";
    let text = with_body("plane", body);
    let folder = submission(&trusted(), "stack", &[("plane.rs", &text)]);
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["check", folder, "--json"]);
    let examination = ran.expect_code(1).json();
    for name in ["sphere", "triangle", "triangle_soup", "first_hit"] {
        assert_eq!(lost(&examination, name), 0, "{name}");
    }
    assert!(lost(&examination, "plane") > 0);
}

#[test]
fn wrong_arguments_are_errors_with_a_remedy() {
    pinhole(&["check", "--task", "cube"])
        .expect_code(2)
        .expect_err("name one of: viewing_ray");
    pinhole(&["check", "--scene", "moon"])
        .expect_code(2)
        .expect_err("sphere_and_plane");
    pinhole(&["check", "nowhere"])
        .expect_code(2)
        .expect_err("there is no folder nowhere");
    let empty = fresh(&trusted(), "empty");
    let empty = empty.to_str().expect("a plain name");
    pinhole(&["check", empty])
        .expect_code(2)
        .expect_err("viewing_ray.rs");
}

#[test]
fn a_wrong_scene_names_the_worst_pixel_and_how_to_look_at_it() {
    let folder = submission(
        &trusted(),
        "wrong-scene",
        &[(
            "plane.rs",
            &with_body("plane", "if min_t == 1.0 { return None; }"),
        )],
    );
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["check", folder, "--scene", "sphere_and_plane"]).expect_code(1);
    ran.expect_out("expected object 1")
        .expect_out("explain sphere_and_plane ");
}

/// What `check` says about one task if the reference's answer has `is` instead of `was`.
fn said_of(task: &str, was: &str, is: &str) -> String {
    let right = with_body(task, "");
    let wrong = right.replacen(was, is, 1);
    assert_ne!(wrong, right);
    let file = format!("{task}.rs");
    let folder = submission(&trusted(), "said-of", &[(&file, &wrong)]);
    let folder = folder.to_str().expect("a plain name");
    pinhole(&["check", folder, "--task", task])
        .expect_code(1)
        .out
}

#[test]
fn an_unknown_mistake_is_described_by_what_is_measured() {
    let said = said_of("plane", "(t >= min_t)", "(t >= min_t && t < 1000.0)");
    let limit = "exactly those where t is more than 1000.";
    assert!(said.contains(limit), "{said}");
    // The opposite comparison misses every hit, as many known mistakes do.
    let said = said_of("plane", "(t >= min_t)", "(t < min_t)");
    assert!(
        said.contains("In each of them, your t is below min_t."),
        "{said}"
    );
    assert!(!said.contains("You may believe"), "{said}");
    let said = said_of(
        "first_hit",
        "shape.intersect_ray(ray, min_t)",
        "shape.intersect_ray(&Ray { direction: ray.direction.normalize(), ..*ray }, min_t)",
    );
    let place = "first_hit.rs:";
    let why = "an object was asked about a ray other than the one given";
    assert!(said.contains(place) && said.contains(why), "{said}");
}

#[test]
fn a_known_mistake_in_t_is_named_whatever_formula_the_normal_has() {
    // The reference divides by the radius, which is right only if t is. The known mistake scales
    // its normal to unit length.
    let said = said_of("sphere", "ray.direction.length_squared()", "1.0");
    assert!(said.contains("A direction is a unit vector"), "{said}");
}

#[test]
fn no_scene_is_explained_by_a_belief_about_a_task_that_passes() {
    // No question has more than six objects. In scenes with more, the last one that is met wins,
    // as in a known mistake that fails the questions.
    let last = "if objects.len() > 6 { return objects.iter().enumerate().rev().find_map(|(object, \
                shape)| { let intersection = shape.intersect_ray(ray, min_t)?; Some(Hit { object, \
                intersection }) }); }";
    let text = with_body("first_hit", last);
    let folder = submission(&trusted(), "many-objects", &[("first_hit.rs", &text)]);
    let folder = folder.to_str().expect("a plain name");
    let said = pinhole(&["check", folder, "--no-report"])
        .expect_code(1)
        .out;
    assert!(
        said.contains("✓ first_hit") && said.contains("✗ sphere_packing"),
        "{said}"
    );
    assert!(!said.contains("You may believe"), "{said}");
}

/// The reference's answer, with some statements before its own.
pub fn with_body(task: &str, statements: &str) -> String {
    let path = root()
        .join("assignments/ray_casting/reference/src")
        .join(format!("{task}.rs"));
    let text = std::fs::read_to_string(path).expect("the reference has it");
    text.replace("// ANCHOR: answer\n", &format!("{statements}\n"))
}

#[test]
fn a_broken_file_in_the_handout_itself_costs_its_own_task() {
    // The stubs come from the reference, not from the folder that students edit.
    let handout = root().join("assignments/ray_casting/handout/src");
    let folder = fresh(&trusted(), "handout");
    for entry in std::fs::read_dir(handout)
        .expect("the handout is there")
        .flatten()
    {
        std::fs::copy(entry.path(), folder.join(entry.file_name())).expect("it can be copied");
    }
    std::fs::write(folder.join("sphere.rs"), "fn broken( {").expect("it can be written");
    std::fs::write(folder.join("main.rs"), "not ours").expect("it can be written");
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(
        task(&examination, "sphere")["file"]["state"],
        "does not compile"
    );
    assert_eq!(
        task(&examination, "plane")["groups"][0]["outcome"]["kind"],
        "unanswered"
    );
}

#[test]
fn simultaneous_checks_of_the_same_answers_do_not_disturb_each_other() {
    let text = with_body("plane", &format!("let _ = {};", std::process::id()));
    let folder = submission(&trusted(), "at-once", &[("plane.rs", &text)]);
    let run = || check(&folder, &["--task", "plane"]).expect_code(0);
    std::thread::scope(|scope| {
        let runs: Vec<_> = (0..6).map(|_| scope.spawn(run)).collect();
        for run in runs {
            run.join().expect("every check ends well");
        }
    });
}

#[test]
fn file_that_crashes_the_compiler_costs_its_own_task() {
    let text = format!("const N: i32 = {}1;", "-".repeat(120_000));
    let folder = submission(&trusted(), "dead-compiler", &[("plane.rs", &text)]);
    let examination = check(&folder, &[]).expect_code(1).json();
    assert_eq!(
        task(&examination, "plane")["file"]["state"],
        "does not compile"
    );
    assert_eq!(lost(&examination, "sphere"), 0);
}
