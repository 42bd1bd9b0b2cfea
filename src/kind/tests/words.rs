//! Questions and answers in words.

use super::*;
use crate::fact::Fact;

#[track_caller]
fn described(task: &str, question: &[(&str, f32)], expected: &str) {
    let questions = ask(task, question).unwrap();
    let facts = questions.describe(0, "corners", 6);
    let line = |fact: &Fact| {
        let text = fact.text.replace('\n', "\n          ");
        format!("{:<9} {text}", fact.label)
    };
    let lines: Vec<String> = facts.iter().map(line).collect();
    assert_eq!(lines.join("\n"), expected);
}

#[test]
fn a_camera_is_described_with_its_pixel() {
    described(
        "viewing_ray",
        &camera(),
        "pixel     (7, 1) of 8×4, corners\n\
         camera    perspective, focal length 1.5, 2 × 1, eye (1, 2, 3)\n          \
         u (1, 0, 0)  v (0, 1, 0)  w (0, 0, 1)",
    );
}

#[test]
fn a_shape_is_described_with_its_ray() {
    let ray = "ray       e = (1, 2, 3), d = (0.5, 0.25, −2), min_t = 0.125";
    let lines = [
        ("sphere", sphere(), "sphere    c = (4, 5, 6), r = 0.75"),
        (
            "plane",
            plane(),
            "plane     through (4, 5, 6), n = (0, 2, 1)",
        ),
        (
            "triangle",
            triangle(),
            "triangle  a = (1, 2, 3), b = (4, 5, 6), c = (7, 8, 0)",
        ),
        (
            "disk",
            disk(),
            "disk      c = (4, 5, 6), n = (0, 2, 1), r = 0.75",
        ),
    ];
    for (task, question, line) in lines {
        described(task, &question, &format!("{ray}\n{line}"));
    }
}

#[test]
fn questions_about_boxes_are_described_by_their_corners() {
    let corners = "from (4, 5, 6) to (7, 8, 9)";
    described(
        "bounds",
        &two_boxes(),
        &format!("a         {corners}\nb         {corners}"),
    );
    let ray = "ray       e = (1, 2, 3), d = (0.5, 0.25, −2), min_t = 0.125, max_t = 2.5";
    described(
        "ray_box",
        &ray_and_box(),
        &format!("{ray}\nbox       {corners}"),
    );
    described(
        "tree",
        &boxes_for_a_tree(),
        &format!("boxes     0: {corners}\n          1: {corners}"),
    );
}

#[test]
fn a_search_is_described_by_what_the_ray_meets() {
    described(
        "tree_search",
        &search(),
        "min_t     0.125\n\
         entered   0: branch to 1 and 2, t from 1 to 4\n          \
         1: leaf of [1, 2], t from 1 to 3\n\
         met       2 at t = 2.5",
    );
}

#[test]
fn canned_objects_are_described_by_where_they_are_met() {
    let expected = "min_t     0.125\nobjects   met at t = { 0: 1.5, 2.5; 1: never }";
    described("first_hit", &canned(), expected);
    described("triangle_soup", &canned(), expected);
}

#[test]
fn id_is_described_only_where_it_was_asked() {
    let met = Answer::Hit(Some(crate::ray::Hit {
        object: 1,
        intersection: Intersection {
            t: 2.5,
            normal: DVec3::Y,
        },
    }));
    for (task, question, expected) in [
        (
            "first_hit",
            canned(),
            "object 1 at t = 2.5, normal (0, 1, 0)",
        ),
        ("triangle_soup", canned(), "t = 2.5, normal (0, 1, 0)"),
        ("sphere", sphere(), "t = 2.5, normal (0, 1, 0)"),
    ] {
        let questions = ask(task, &question).unwrap();
        assert_eq!(questions.describe_answer(0, &met, 6), expected);
        assert_eq!(
            questions.describe_answer(0, &Answer::Hit(None), 6),
            "no hit"
        );
    }
}

#[test]
fn a_kind_has_the_name_that_assignments_use() {
    for kind in [
        Kind::ViewingRay,
        Kind::Intersect,
        Kind::FirstHit,
        Kind::Soup,
    ] {
        #[derive(Deserialize)]
        struct Task {
            kind: Kind,
        }
        let task: Task = toml::from_str(&format!("kind = \"{kind}\"")).unwrap();
        assert_eq!(task.kind, kind);
    }
}
