//! The report, in a real browser.

mod access;
mod reading;

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::browser::Browser;
use crate::check::{from_root, with_body};
use pinhole_testing::{TASKS, fresh, pinhole, root, submission, trusted};

/// The scene of these tests. It is small, and has a sphere in front of a plane.
pub const SCENE: &str = "sphere_and_plane";

/// A known mistake's answer files laid over the reference's.
pub fn mistaken(name: &str, slug: &str, file: &str) -> PathBuf {
    let wrong = root().join("assignments/ray_casting/mistakes").join(slug);
    let text = std::fs::read_to_string(wrong.join(file)).expect("the mistake has it");
    submission(&trusted(), name, &[(file, &text)])
}

/// Checks a folder and returns the path of its report.
#[track_caller]
pub fn report(folder: &Path, arguments: &[&str]) -> PathBuf {
    let page = folder.join("report.html");
    let [folder, path] = [folder, &page].map(|path| path.to_str().expect("plain"));
    let all = [&["check", folder, "--report", path], arguments].concat();
    let shown = from_root(folder, "report.html");
    pinhole(&all)
        .expect_code(1)
        .expect_out(&format!("report: {shown}"));
    page
}

/// A report of a scene whose rays are all half a pixel off.
pub fn half_a_pixel_off(name: &str) -> (PathBuf, PathBuf) {
    let folder = mistaken(name, "viewing_ray_half_pixel_sign", "viewing_ray.rs");
    let page = report(&folder, &["--scene", SCENE]);
    (folder, page)
}

/// The numbers in a text, in order.
pub fn numbers(text: &str) -> Vec<f64> {
    let text = text.replace('−', "-");
    let pieces = text.split(|c: char| !(c.is_ascii_digit() || "-.e".contains(c)));
    pieces.filter_map(|piece| piece.parse().ok()).collect()
}

#[track_caller]
pub fn assert_near(shown: &str, values: &[&Value]) {
    let flat = values.iter().flat_map(|value| match value {
        Value::Array(axes) => axes.clone(),
        other => vec![(*other).clone()],
    });
    let values: Vec<f64> = flat
        .map(|value| value.as_f64().expect("a number"))
        .collect();
    let shown = numbers(shown);
    assert_eq!(shown.len(), values.len(), "{shown:?} {values:?}");
    for (shown, value) in shown.iter().zip(&values) {
        assert!(
            (shown - value).abs() <= 2e-5 * value.abs() + 1e-6,
            "{shown} is not {value}"
        );
    }
}

/// Checks that the page and `explain` say the same of a pixel.
#[track_caller]
pub fn assert_as_explained(browser: &Browser, folder: &Path, i: usize, j: usize) {
    let folder = folder.to_str().expect("plain");
    let [i, j] = [i, j].map(|k| k.to_string());
    let explained = pinhole(&["explain", SCENE, &i, &j, "--submission", folder, "--json"]).json();
    let cell = |row: usize, column: usize| {
        browser.text(&format!(
            "document.querySelectorAll('.pixel tbody tr')[{row}].children[{column}].textContent"
        ))
    };
    assert!(
        browser
            .text("document.querySelector('.reading .cause').textContent")
            .contains(&format!("({i}, {j})"))
    );
    let ray = &explained["expected"]["ray"];
    let shown = |k: usize| {
        browser.text(&format!(
            "document.querySelectorAll('.ray dd')[{k}].textContent"
        ))
    };
    assert_near(&shown(0), &[&ray["origin"]]);
    assert_near(&shown(1), &[&ray["direction"]]);
    assert_near(&shown(2), &[&explained["min_t"]]);
    for (column, hit) in [
        (1, &explained["expected"]["first_hit"]),
        (2, &explained["first_hit"]),
    ] {
        if hit.is_null() {
            assert_eq!(cell(0, column), "no hit");
            continue;
        }
        let at = &hit["intersection"];
        assert_near(&cell(0, column), &[&hit["object"]]);
        assert_near(&cell(1, column), &[&at["t"]]);
        for axis in 0..3 {
            assert_near(&cell(2 + axis, column), &[&at["normal"][axis]]);
        }
    }
}

#[test]
fn student_text_in_a_report_is_only_text() {
    let evil =
        "</script><img src=x onerror='document.title=666'><script>document.title=666</script>";
    let panic = format!("println!(\"{evil}\"); panic!(\"{evil}\");");
    let folder = submission(
        &trusted(),
        "report-evil<img src=x onerror='document.title=666'>",
        &[("plane.rs", &with_body("plane", &panic))],
    );
    std::fs::write(
        folder.join("triangle.rs"),
        format!("compile_error!(\"{evil}\");"),
    )
    .expect("it can be written");
    let page = report(
        &folder,
        &["--task", "plane", "--task", "triangle", "--scene", SCENE],
    );
    let browser = Browser::open(&page);
    assert!(browser.text("document.title").contains("Ray casting"));
    assert_eq!(
        browser.value("document.querySelectorAll('img[src=x]').length"),
        0
    );
    let seen = browser.text("document.body.innerText");
    // The folder, panics, compiler messages and output are shown as plain text.
    assert!(
        seen.matches("<img src=x onerror='document.title=666'>")
            .count()
            >= 4,
        "{seen}"
    );
    browser.expect_quiet();

    // If some text did get through as markup, the policy would still stop it.
    browser.value("document.body.insertAdjacentHTML('beforeend', \"<img src='x' onerror='document.title=666'>\")");
    browser.value("document.body.append(Object.assign(document.createElement('script'), { textContent: 'document.title=666' }))");
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert!(browser.text("document.title").contains("Ray casting"));
}

#[test]
fn diff_writes_a_report_beside_its_pictures() {
    let (folder, _) = half_a_pixel_off("report-diff");
    let out = folder.join("out");
    let [folder, out_name] = [&folder, &out].map(|path| path.to_str().expect("plain"));
    pinhole(&["render", SCENE, "--submission", folder, "--out", out_name]).expect_code(0);
    let film = out.join("film.exr");
    let golden = format!("golden/ray_casting/{SCENE}.exr");
    let ran = pinhole(&[
        "diff",
        &golden,
        film.to_str().expect("plain"),
        "--out",
        out_name,
    ]);
    ran.expect_code(1).expect_out("report.html");
    let browser = Browser::open(&out.join("report.html"));
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    // The golden belongs to the assignment, so its scene is known. Its golden rays are in the
    // same folder.
    let reading = browser.text("document.querySelector('.reading').innerText");
    assert!(
        reading.contains("(plane)") && reading.contains("min_t"),
        "{reading}"
    );
    browser.expect_quiet();
}

/// A submission about bounding volumes that is right except for this answer, which a mistake gives.
fn with_mistake(name: &str, mistake: &str, file: &str) -> PathBuf {
    let assignment = root().join("assignments/bounding_volumes");
    let folder = fresh(&trusted(), name);
    let copy = |from: PathBuf| {
        let to = folder.join(from.file_name().expect("it is a file"));
        std::fs::copy(from, to).expect("it can be copied");
    };
    for file in [
        "triangle_box.rs",
        "ray_box.rs",
        "build_tree.rs",
        "nearest_hit.rs",
    ] {
        copy(assignment.join("reference/src").join(file));
    }
    copy(assignment.join("mistakes").join(mistake).join(file));
    folder
}

#[test]
fn the_worst_tree_of_a_group_is_drawn_beside_a_right_one() {
    let folder = with_mistake("report-tree", "build_tree_leaves_of_16", "build_tree.rs");
    let picked = ["--assignment", "bounding_volumes", "--task", "build_tree"];
    let browser = Browser::open(&report(&folder, &picked));
    let shown = |what: &str| {
        let all = format!("document.querySelectorAll('#task-0 .tree {what}')");
        browser.value(&format!("{all}.length"))
    };
    let drawn = shown("figure").as_u64().expect("a number");
    assert!(
        drawn >= 6 && drawn % 2 == 0,
        "two for each wrong group: {drawn}"
    );
    assert_eq!(shown("figure:first-child .depth-0"), drawn / 2);
    // A right tree has more boxes, because this mistake leaves up to 16 triangles in a leaf.
    let boxes = |figure: &str| shown(&format!("figure:{figure}-child [class^=depth]")).as_u64();
    assert!(boxes("first") > boxes("last"), "{:?}", boxes("last"));
    let outside = "[...document.querySelectorAll('.tree figure path')].every((it) => {
        const [path, all] = [it, it.ownerSVGElement].map((it) => it.getBoundingClientRect());
        return path.left > all.left - 1 && path.right < all.right + 1
            && path.top > all.top - 1 && path.bottom < all.bottom + 1;
    })";
    assert_eq!(browser.value(outside), true);
    browser.expect_quiet();
}

#[test]
fn tests_that_are_counted_have_heat_maps_on_one_scale() {
    let slow = "nearest_hit_max_t_never_shrinks";
    let folder = with_mistake("report-heat", slow, "nearest_hit.rs");
    let picked = ["--task", "nearest_hit", "--scene", "teapot"];
    let page = report(
        &folder,
        &[&["--assignment", "bounding_volumes"][..], &picked].concat(),
    );
    let browser = Browser::open(&page);
    // Four groups have too many tests: for each, what is enough and what was taken.
    let shown = |what: &str| browser.value(&format!("document.querySelectorAll('{what}').length"));
    assert_eq!(shown("#task-0 .heat"), 4);
    assert_eq!(shown("#task-0 .heat .stills img"), 8);
    assert_eq!(shown(".costs .heat .stills img"), 2);
    assert_eq!(
        browser.value(
            "[...document.querySelectorAll('.heat img')].every((it) => it.naturalWidth > 0)"
        ),
        true
    );
    // The last of the four takes more than twice as many tests as are needed.
    let last = "[...document.querySelectorAll('#task-0 .heat')].at(-1)";
    let sums = browser.text(&format!("{last}.querySelector('.stills').innerText"));
    let [expected, yours] = numbers(&sums)[..] else {
        panic!("two sums: {sums}");
    };
    assert!(yours > 2.0 * expected, "{sums}");
    let sums = browser.text("document.querySelector('.costs .stills').innerText");
    let [expected, yours] = numbers(&sums)[..] else {
        panic!("two sums: {sums}");
    };
    assert!(yours > 1.05 * expected, "{sums}");
    let steps = browser.text(&format!("{last}.querySelector('.scale p').innerText"));
    let steps = numbers(&steps);
    assert_eq!(steps[0], 0.0);
    assert!(steps[4] >= 113.0 && steps[2] * 2.0 == steps[4], "{steps:?}");
    let again = browser.text("document.querySelector('.again code').innerText");
    assert!(again.contains("--assignment bounding_volumes"), "{again}");
    browser.expect_quiet();
}

#[test]
fn a_report_on_scenes_that_fail_everywhere_has_less_than_two_megabytes() {
    let folder = mistaken(
        "report-size",
        "viewing_ray_half_pixel_sign",
        "viewing_ray.rs",
    );
    let page = report(&folder, &[]);
    let size = page.metadata().expect("it was written").len();
    assert!(size < 2_000_000, "{size}");
    let browser = Browser::open(&page);
    browser.value(
        "document.querySelectorAll('details.scene').forEach((card) => { card.open = true; })",
    );
    browser.wait_for("[...document.querySelectorAll('.viewer')].every((viewer) => !viewer.hidden)");
    assert_eq!(
        browser.value("document.querySelectorAll('.viewer').length"),
        12
    );
    browser.expect_quiet();
}

#[test]
fn check_writes_a_report_unless_told_not_to_and_says_where() {
    let reference = "assignments/ray_casting/reference";
    let default = root().join("target/pinhole/report.html").canonicalize();
    let json = |arguments: &[&str]| {
        let all = [
            &["check", reference, "--task", "plane", "--json"],
            arguments,
        ]
        .concat();
        pinhole(&all).expect_code(0).json()["report"].clone()
    };
    let said = json(&[]);
    let said = Path::new(said.as_str().expect("a path"))
        .canonicalize()
        .expect("it is there");
    assert_eq!(said, default.expect("it is there"));
    assert_eq!(json(&["--no-report"]), Value::Null);
    let own = fresh(&trusted(), "report-own").join("deep/mine.html");
    let own = own.to_str().expect("plain");
    assert_eq!(json(&["--report", own]), own);
    assert!(Path::new(own).is_file());
    pinhole(&[
        "check",
        reference,
        "--task",
        "plane",
        "--report",
        "/dev/null/report.html",
    ])
    .expect_code(2)
    .expect_out("12 / 12")
    .expect_err("cannot write the report");
}

#[test]
fn a_scene_that_was_not_cast_shows_what_was_expected_and_why() {
    let page = trusted().join("report-unanswered.html");
    let path = page.to_str().expect("plain");
    pinhole(&["check", "assignments/ray_casting/handout", "--report", path]).expect_code(1);
    let browser = Browser::open(&page);
    assert_eq!(
        browser.value("document.querySelectorAll('.viewer').length"),
        0
    );
    let seen = browser.text("document.body.innerText");
    assert!(
        seen.contains("0 of 100 points") && seen.contains("unanswered"),
        "{seen}"
    );
    for name in TASKS.into_iter().chain(["in_front_of_the_image_plane"]) {
        let shown = "[...document.querySelectorAll('.tables a')].map((a) => a.innerText).join(' ')";
        assert!(browser.text(shown).split(' ').any(|shown| shown == name));
    }
    assert_eq!(
        browser.value("document.querySelectorAll('.gallery img').length"),
        12
    );
    browser.expect_quiet();
}
