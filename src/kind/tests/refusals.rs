//! Question films that are refused, and why.

use super::*;

/// Makes a new question.
type Ask = fn() -> Channels<'static>;

const TASKS: [(&str, Ask); 11] = [
    ("viewing_ray", camera),
    ("first_hit", canned),
    ("sphere", sphere),
    ("plane", plane),
    ("triangle", triangle),
    ("disk", disk),
    ("triangle_soup", canned),
    ("bounds", two_boxes),
    ("ray_box", ray_and_box),
    ("tree", boxes_for_a_tree),
    ("tree_search", search),
];

#[track_caller]
fn refused(task: &str, question: &[(&str, f32)], problem: &str) {
    let error = ask(task, question).expect_err("this should not be a question");
    let start = format!("this is not a question film for `{task}`: ");
    assert!(error.problem.starts_with(&start), "{error}");
    assert!(error.problem.contains(problem), "{error}");
    assert!(error.remedy.contains("golden render"), "{error}");
}

#[test]
fn every_channel_of_a_question_is_needed() {
    for (task, question) in TASKS {
        assert!(ask(task, &question()).is_ok());
        for (missing, _) in question() {
            let mut rest = question();
            rest.retain(|(name, _)| *name != missing);
            refused(task, &rest, &format!("it has no channel `{missing}`"));
        }
    }
}

#[test]
fn every_channel_of_a_question_is_finite() {
    for (task, question) in TASKS {
        for (name, _) in question() {
            for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let problem = format!("channel `{name}` is not finite at (0, 0)");
                refused(task, &with(question(), name, value), &problem);
            }
        }
    }
}

#[test]
fn counts_are_whole_and_not_negative() {
    for (task, question, name) in [
        ("first_hit", canned as Ask, "count"),
        ("triangle_soup", canned, "1.hits"),
        ("viewing_ray", camera, "n_x"),
        ("viewing_ray", camera, "j"),
    ] {
        for value in [-1.0, 0.5, 1e-20] {
            let shown = f64::from(value);
            let problem = format!("channel `{name}` holds {shown}, which is not a count");
            refused(task, &with(question(), name, value), &problem);
        }
    }
}

#[test]
fn a_count_of_more_than_there_is_misses_a_channel() {
    refused(
        "first_hit",
        &with(canned(), "count", 3.0),
        "no channel `2.hits`",
    );
    for hits in [3.0, 1e30] {
        let question = with(canned(), "0.hits", hits);
        refused("first_hit", &question, "no channel `0.2.t`");
    }
}

#[test]
fn nothing_behind_the_origin_is_asked_about() {
    for task in ["first_hit", "triangle_soup"] {
        let question = with(canned(), "min_t", -0.25);
        refused(
            task,
            &question,
            "`min_t` holds -0.25, behind the ray's origin",
        );
    }
    let question = with(sphere(), "min_t", -0.25);
    refused("sphere", &question, "`min_t` holds -0.25");
}

#[test]
fn too_many_objects_are_refused() {
    for count in [7.0, 1e30] {
        let question = with(canned(), "count", count);
        refused("first_hit", &question, "more than 6 objects");
    }
}

#[test]
fn a_tree_is_asked_for_over_at_least_one_box_and_not_too_many() {
    for count in [0.0, 65.0] {
        let question = with(boxes_for_a_tree(), "count", count);
        refused("tree", &question, "it must be from 1 to 64");
    }
    refused(
        "bounds",
        &with(two_boxes(), "boxes", 1.0),
        "it must hold 0 or 2",
    );
}

#[test]
fn leaves_of_a_tree_to_show_form_a_tree() {
    for depth in [0.0, 2.0, 1e30] {
        let question = with(boxes_for_a_tree(), "1.depth", depth);
        refused("tree", &question, "its leaves don't form a tree");
    }
}

#[test]
fn nodes_to_search_form_a_tree() {
    for second in [1.0, 3.0] {
        let question = with(search(), "0.second", second);
        refused("tree_search", &question, "its nodes don't form a tree");
    }
}

#[test]
fn a_pixel_lies_in_its_picture() {
    for (name, value) in [("i", 8.0), ("j", 4.0), ("n_x", 0.0), ("n_y", 0.0)] {
        let question = with(camera(), name, value);
        refused("viewing_ray", &question, "not a pixel of");
    }
}

#[test]
fn camera_without_a_frame_is_refused() {
    let question = with(with(camera(), "up.Y", 0.0), "up.Z", 3.0);
    refused("viewing_ray", &question, "its view and up are parallel");
}

#[test]
fn intersection_task_must_name_its_shape() {
    let no_questions = |shape| {
        let questions = Questions::from_film(&film(&sphere()), Kind::Intersect, shape);
        questions.expect_err("there is no shape to ask about")
    };
    assert_eq!(no_questions(None), "the task names no shape");
    let problem = no_questions(Some(ShapeKind::Soup));
    assert!(problem.contains("kind = \"soup\""), "{problem}");
}

#[test]
fn missing_question_film_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("absent.ask.exr");
    let (kind, shape) = of_task("sphere");
    let error = Questions::read(&path, "sphere", kind, shape).unwrap_err();
    assert!(
        error.problem.starts_with("cannot read this film"),
        "{error}"
    );
}
