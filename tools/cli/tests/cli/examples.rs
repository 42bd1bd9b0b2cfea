//! `pinhole examples`, on the real questions.

use std::fs;

use pinhole_testing::{RunResult, fresh, pinhole, pinhole_in, trusted};

/// Judges a file with these examples of `sphere`, and prints JSON if `more` says so.
fn examples(name: &str, entries: &str, more: &[&str]) -> RunResult {
    let file = fresh(&trusted(), name).join("mine.toml");
    // Some editors begin a file with a byte order mark.
    fs::write(&file, format!("\u{feff}task = \"sphere\"\n{entries}")).expect("there is room");
    let file = file.to_str().expect("a plain name");
    pinhole(&[&["examples", file], more].concat())
}

/// Worked out by hand from what `examples` shows, to three digits.
const INSIDE: &str = "
[[example]]
group = \"inside\"
question = 0
t = 7.62
normal = [-0.297, 0.865, -0.405]
";

#[test]
fn right_examples_catch_mistakes_and_wrong_ones_do_not() {
    let others = "
[[example]]
group = \"behind\"
question = 0
hit = true
[[example]]
group = \"outside\"
question = 0
t = 2.95
[[example]]
group = \"min_t\"
question = 0
";
    let ran = examples("examples-mixed", &format!("{INSIDE}{others}"), &[]).expect_code(1);
    let shown = "\
✓ inside 0
✗ behind 0    Mitsuba disagrees about whether there is a hit
      ray       e = (0.99518716, 1.6437857, 0.85127211), d = (1.1432894, 0.035873603, 2.0181653), min_t = 0
      sphere    c = (0.17737678, 1.5563229, −0.55288345), r = 0.77948415
✗ outside 0    Mitsuba gives a different t
      ray       e = (2.9058902, −0.22460437, −2.3258781), d = (−1.7707222, 0, 1.2376672), min_t = 0.18596716
      sphere    c = (1.7242051, −0.446877, −1.2657056), r = 0.3055605
? min_t 0    has no answer yet
      ray       e = (−0.052457377, 1.8813487, −0.72609383), d = (840808.62, −762077.44, −131153.53), min_t = 2.7579256e−6
      sphere    c = (2.0707569, −1.7611471, −1.1132345), r = 1.7984911
Your correct example catches 19 of 25 mistakes that people make in this task.
";
    assert_eq!(ran.out, shown);
}

#[test]
fn each_answer_catches_what_it_tells_apart() {
    let caught = |name, entries: &str| {
        let judged = examples(name, entries, &["--json"]).expect_code(0).json();
        judged["caught"].as_u64().expect("a number")
    };
    let whole = caught("examples-whole", INSIDE);
    let hit = "[[example]]\ngroup = \"inside\"\nquestion = 0\nhit = true\n";
    let only_hit = caught("examples-hit", hit);
    let only_t = caught("examples-t", &format!("{hit}t = 7.62\n"));
    assert!(0 < only_hit && only_hit < only_t && only_t < whole);
    let none = caught("examples-none", &hit.replace("hit = true", ""));
    assert_eq!(none, 0);
}

#[test]
fn examples_begin_with_a_file_of_questions() {
    let folder = fresh(&trusted(), "examples-new");
    let file = folder.join("sphere.toml");
    let file = file.to_str().expect("a plain name");
    let new = ["examples", "--new", "sphere", file];
    pinhole(&new).expect_code(0);
    let text = fs::read_to_string(file).expect("it was written");
    let ran = pinhole(&["examples", file]).expect_code(0);
    assert_eq!(ran.out.matches("has no answer yet").count(), 9);
    ran.expect_out("No example is correct yet. Correct ones can catch 25 mistakes");
    pinhole(&new)
        .expect_code(2)
        .expect_err("does not exist yet");
    // Each answer needs only its # removed.
    let filled = text.replace("# hit = false", "hit = true");
    let filled = filled
        .replace("# t =", "t =")
        .replace("# normal =", "normal =");
    fs::write(file, filled).expect("there is room");
    pinhole(&["examples", file]).expect_code(1);
    pinhole(&["examples"])
        .expect_code(0)
        .expect_out("examples --new sphere");
}

/// A ray towards the origin of space, from 4 away, and a sphere around it.
const OWN_RAY: &str = "ray = { e = [0, 0, 4], d = [0, 0, -2], min_t = 0 }";
const OWN_SHAPE: &str = "shape = { center = [0, 0, 0], radius = 1 }";

#[test]
fn rays_of_ones_own_are_judged_by_mitsuba_and_catch_mistakes() {
    let own = format!("[[example]]\n{OWN_RAY}\n{OWN_SHAPE}\n");
    let near = format!("{own}t = 1.5\nnormal = [0, 0, 1]\n");
    let wrong = format!("{own}t = 1.5\n").replace("min_t = 0", "min_t = 2");
    let far = wrong.replace("t = 1.5", "t = 2.5");
    let beside = format!("{own}hit = false\n").replace("[0, 0, 4]", "[0, 2, 4]");
    // Single precision moves the start of this ray, but the answer's three digits stay the same.
    let distant = "\
[[example]]
ray = { e = [300.1, 2, 5], d = [0, 0, -1], min_t = 0 }
shape = { center = [300.8, 2, 0], radius = 1 }
t = 4.29
";
    let entries = [&near, &wrong, &far, INSIDE, &beside, distant].concat();
    let ran = examples("examples-own", &entries, &[]).expect_code(1);
    let shown = "\
✓ own ray 0
✗ own ray 1    Mitsuba gives a different t
      ray       e = (0, 0, 4), d = (0, 0, −2), min_t = 2
      sphere    c = (0, 0, 0), r = 1
✓ own ray 2
✓ inside 0
✓ own ray 3
✓ own ray 4
";
    ran.expect_out(shown)
        .expect_out("Your 5 correct examples catch 20 of 25 mistakes");
}

#[test]
fn mitsuba_loads_nothing_from_the_current_folder() {
    let folder = fresh(&trusted(), "examples-plugins");
    let entries = format!("task = \"sphere\"\n[[example]]\n{OWN_RAY}\n{OWN_SHAPE}\nhit = true\n");
    fs::write(folder.join("mine.toml"), entries).expect("there is room");
    fs::create_dir(folder.join("plugins")).expect("there is room");
    for file in ["plugins/scene.so", "plugins/sphere.so", "plugins/mesh.so"] {
        fs::write(folder.join(file), "no library").expect("there is room");
    }
    // The processes that draw questions import `select`.
    fs::write(folder.join("select.py"), "no module").expect("there is room");
    pinhole_in(&folder, &["examples", "mine.toml"])
        .expect_code(0)
        .expect_out("✓ own ray 0");
}

#[test]
fn rays_of_ones_own_that_no_one_can_judge_are_refused() {
    for (ray, shape, problem) in [
        (OWN_RAY, "", ":2: this example has no question"),
        (OWN_RAY, "shape = {}", ":4:9: this sphere has no `center`"),
        (
            "ray = { e = [0, 0, 4], d = [0, 0, 0], min_t = 0 }",
            OWN_SHAPE,
            ":3: no ray has these numbers",
        ),
        (
            "ray = { e = [0, 0, inf], d = [0, 0, 1], min_t = 0 }",
            OWN_SHAPE,
            ":3: no ray has these numbers",
        ),
        (
            "ray = { e = [0, 1, 4], d = [0, 0, -2], min_t = 0 }",
            OWN_SHAPE,
            "own ray 0 is too close to call",
        ),
        (
            "ray = { e = [0, 0, 4e30], d = [0, 0, -2], min_t = 0 }",
            OWN_SHAPE,
            "Mitsuba's precision is too low for own ray 0",
        ),
        // Single precision has too few digits for these: the first is 3 above the centre, the second
        // 1.5 beside it.
        (
            "ray = { e = [0, 0, 100000003], d = [0, 0, -1], min_t = 0 }",
            "shape = { center = [0, 0, 100000000], radius = 1 }",
            "Mitsuba's precision is too low for own ray 0",
        ),
        (
            "ray = { e = [16777215.5, 0, 5], d = [0, 0, -1], min_t = 0 }",
            "shape = { center = [16777217, 0, 0], radius = 1 }",
            "Mitsuba's precision is too low for own ray 0",
        ),
        (
            OWN_RAY,
            "shape = { center = [0, 0, 0], radius = 1e300 }",
            "own ray 0 has a number beyond float32",
        ),
    ] {
        let entry = format!("[[example]]\n{ray}\n{shape}\nhit = true\n");
        let ran = examples("examples-own-refused", &entry, &[]).expect_code(2);
        ran.expect_err(problem).expect_err("remedy: ");
    }
}

#[test]
fn malformed_examples_are_refused_with_file_place_and_remedy() {
    let entry = |rest: &str| format!("[[example]]\ngroup = \"inside\"\nquestion = {rest}\n");
    for (entries, problem) in [
        (entry("96"), ":2: `inside` has no question 96"),
        (entry("-1"), "line 4, column 12"),
        (entry("1\nt = \"1\""), "line 5, column 5"),
        (entry("1\nspeed = 1"), "line 5, column 1"),
        (entry("1\nnormal = [0, 1]"), "line 5, column 10"),
        (
            entry("1\nmin = [0, 0, 0]"),
            ":2: an answer to this question has no `min`",
        ),
        (
            entry("1\nhit = false\nt = 1"),
            ":2: `hit = false` says that nothing is hit, but there are numbers for a hit",
        ),
        (
            entry("1").replace("inside", "scenes"),
            ":2: `scenes` is not a group of public questions",
        ),
    ] {
        let ran = examples("examples-malformed", &entries, &[]).expect_code(2);
        ran.expect_err("mine.toml")
            .expect_err(problem)
            .expect_err("remedy: ");
    }
    let ran = examples("examples-infinite", &entry("1\nt = inf"), &[]);
    ran.expect_code(1).expect_out("Mitsuba gives a different t");
    let trees = ["examples", "--new", "build_tree", "--assignment"];
    pinhole(&[trees.as_slice(), &["bounding_volumes"]].concat())
        .expect_code(2)
        .expect_err("have many right answers");
}
