use super::*;
use crate::testing::{self, row};
use glam::dvec3;

/// Channels of one pixel each.
type Question<'a> = Vec<(&'a str, f32)>;

fn read_film(film: &Film, task: &str) -> Result<(Job, Resolution), Error> {
    let (_folder, path) = testing::file("probe.ask.exr", "");
    film.write(&path).unwrap();
    read(&path, task)
}

fn ask(task: &str, question: &[(&str, f32)]) -> Result<Job, Error> {
    let channels: Vec<(&str, [f32; 1])> = question.iter().map(|(n, x)| (*n, [*x])).collect();
    let channels: Vec<(&str, &[f32])> = channels.iter().map(|(n, x)| (*n, &x[..])).collect();
    read_film(&row(&channels), task).map(|(job, _)| job)
}

fn ray() -> Question<'static> {
    vec![
        ("O.X", 1.0),
        ("O.Y", 2.0),
        ("O.Z", 3.0),
        ("D.X", 0.5),
        ("D.Y", 0.25),
        ("D.Z", -2.0),
        ("min_t", 0.125),
    ]
}

fn sphere() -> Question<'static> {
    let own = [
        ("center.X", 4.0),
        ("center.Y", 5.0),
        ("center.Z", 6.0),
        ("radius", 0.75),
    ];
    [ray(), own.into()].concat()
}

fn plane() -> Question<'static> {
    let own = [
        ("point.X", 4.0),
        ("point.Y", 5.0),
        ("point.Z", 6.0),
        ("normal.X", 0.0),
        ("normal.Y", 2.0),
        ("normal.Z", 1.0),
    ];
    [ray(), own.into()].concat()
}

fn triangle() -> Question<'static> {
    let own = [
        ("a.X", 1.0),
        ("a.Y", 2.0),
        ("a.Z", 3.0),
        ("b.X", 4.0),
        ("b.Y", 5.0),
        ("b.Z", 6.0),
        ("c.X", 7.0),
        ("c.Y", 8.0),
        ("c.Z", 0.0),
    ];
    [ray(), own.into()].concat()
}

/// Two objects: the first is met twice, the second never.
fn canned() -> Question<'static> {
    let own = [
        ("count", 2.0),
        ("0.hits", 2.0),
        ("0.0.t", 1.5),
        ("0.0.N.X", 1.0),
        ("0.0.N.Y", 0.0),
        ("0.0.N.Z", 0.0),
        ("0.1.t", 2.5),
        ("0.1.N.X", 0.0),
        ("0.1.N.Y", -1.0),
        ("0.1.N.Z", 0.0),
        ("1.hits", 0.0),
    ];
    [ray(), own.into()].concat()
}

fn camera() -> Question<'static> {
    vec![
        ("eye.X", 1.0),
        ("eye.Y", 2.0),
        ("eye.Z", 3.0),
        ("view.X", 0.0),
        ("view.Y", 0.0),
        ("view.Z", -2.0),
        ("up.X", 0.0),
        ("up.Y", 1.0),
        ("up.Z", 0.0),
        ("focal_length", 1.5),
        ("width", 2.0),
        ("height", 1.0),
        ("n_x", 8.0),
        ("n_y", 4.0),
        ("i", 7.0),
        ("j", 1.0),
    ]
}

/// Makes a question afresh.
type Ask = fn() -> Question<'static>;

const TASKS: [(&str, Ask); 6] = [
    ("viewing_ray", camera),
    ("first_hit", canned),
    ("sphere", sphere),
    ("plane", plane),
    ("triangle", triangle),
    ("triangle_soup", canned),
];

/// The question with one channel holding something else.
#[track_caller]
fn with(mut question: Question<'static>, name: &str, value: f32) -> Question<'static> {
    let mut channels = question.iter_mut();
    channels.find(|(own, _)| *own == name).unwrap().1 = value;
    question
}

#[track_caller]
fn refused(task: &str, question: &[(&str, f32)], problem: &str) {
    let error = ask(task, question).expect_err("this should be no question");
    let start = format!("this is no question film for `{task}`: ");
    assert!(error.problem.starts_with(&start), "{error}");
    assert!(error.problem.contains(problem), "{error}");
    assert!(error.remedy.contains("golden render"), "{error}");
}

#[track_caller]
fn only_shape(task: &str, question: Question<'_>) -> Shape {
    let Job::Intersect(questions) = ask(task, &question).unwrap() else {
        panic!("`{task}` is asked with one shape alone");
    };
    let [asked] = questions.as_slice() else {
        panic!("one pixel is one question");
    };
    assert_eq!(asked.min_t, 0.125);
    assert_eq!(asked.ray.origin, dvec3(1.0, 2.0, 3.0));
    assert_eq!(asked.ray.direction, dvec3(0.5, 0.25, -2.0));
    asked.shape.clone()
}

#[test]
fn a_sphere_is_asked_about_as_it_was_written() {
    let expected = Sphere {
        center: dvec3(4.0, 5.0, 6.0),
        radius: 0.75,
    };
    assert_eq!(only_shape("sphere", sphere()), Shape::Sphere(expected));
}

#[test]
fn a_plane_keeps_the_length_of_its_normal() {
    let expected = Plane {
        point: dvec3(4.0, 5.0, 6.0),
        normal: dvec3(0.0, 2.0, 1.0),
    };
    assert_eq!(only_shape("plane", plane()), Shape::Plane(expected));
}

#[test]
fn a_triangle_keeps_the_order_of_its_corners() {
    let corners = [
        dvec3(1.0, 2.0, 3.0),
        dvec3(4.0, 5.0, 6.0),
        dvec3(7.0, 8.0, 0.0),
    ];
    let expected = Shape::Triangle(Triangle { corners });
    assert_eq!(only_shape("triangle", triangle()), expected);
}

#[test]
fn canned_objects_know_their_intersections() {
    for task in ["first_hit", "triangle_soup"] {
        let questions = match ask(task, &canned()).unwrap() {
            Job::FirstHit(questions) if task == "first_hit" => questions,
            Job::TriangleSoup(questions) if task == "triangle_soup" => questions,
            other => panic!("`{task}` is asked by {other:?}"),
        };
        let at = |t, normal| Intersection { t, normal };
        let [twice, never] = questions[0].objects.triangles.as_slice() else {
            panic!("there are two objects");
        };
        assert_eq!(
            twice.intersections,
            [at(1.5, DVec3::X), at(2.5, DVec3::NEG_Y)]
        );
        assert_eq!(never.intersections, []);
        assert_eq!(questions[0].min_t, 0.125);
        assert_eq!(questions[0].ray.origin, dvec3(1.0, 2.0, 3.0));
    }
}

#[test]
fn there_may_be_no_object_at_all() {
    let question = [ray(), vec![("count", 0.0)]].concat();
    let Job::FirstHit(questions) = ask("first_hit", &question).unwrap() else {
        panic!("it is asked with canned objects");
    };
    assert!(questions[0].objects.triangles.is_empty());
}

#[test]
fn a_camera_is_asked_about_one_of_its_pixels() {
    let Job::ViewingRay(questions) = ask("viewing_ray", &camera()).unwrap() else {
        panic!("it is asked with cameras");
    };
    let CameraQuestion {
        camera,
        pixel,
        resolution,
    } = questions[0];
    assert_eq!(camera.eye, dvec3(1.0, 2.0, 3.0));
    assert_eq!(
        [camera.u, camera.v, camera.w],
        [DVec3::X, DVec3::Y, DVec3::Z]
    );
    assert_eq!((camera.width, camera.height), (2.0, 1.0));
    let projection = Projection::Perspective { focal_length: 1.5 };
    assert_eq!(camera.projection, projection);
    assert_eq!(pixel, Pixel { i: 7, j: 1 });
    assert_eq!(resolution, Resolution { n_x: 8, n_y: 4 });
}

#[test]
fn a_camera_without_focal_length_is_orthographic() {
    let question = with(camera(), "focal_length", 0.0);
    let Job::ViewingRay(questions) = ask("viewing_ray", &question).unwrap() else {
        panic!("it is asked with cameras");
    };
    assert_eq!(questions[0].camera.projection, Projection::Orthographic);
}

#[test]
fn questions_stand_in_the_order_of_the_film() {
    let radii = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let repeated: Vec<(&str, [f32; 6])> = sphere()
        .into_iter()
        .map(|(name, value)| (name, if name == "radius" { radii } else { [value; 6] }))
        .collect();
    let channels: Vec<(&str, &[f32])> = repeated.iter().map(|(n, x)| (*n, &x[..])).collect();
    let (job, resolution) = read_film(&testing::grid(3, &channels), "sphere").unwrap();
    assert_eq!(resolution, Resolution { n_x: 3, n_y: 2 });
    let Job::Intersect(questions) = job else {
        panic!("it is asked with one shape alone");
    };
    let read: Vec<f64> = questions
        .iter()
        .map(|question| match question.shape {
            Shape::Sphere(sphere) => sphere.radius,
            _ => f64::NAN,
        })
        .collect();
    assert_eq!(read, radii.map(f64::from));
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
            let problem = format!("channel `{name}` holds {shown}, which counts nothing");
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
fn too_many_objects_are_not_quietly_dropped() {
    for count in [7.0, 1e30] {
        let question = with(canned(), "count", count);
        refused("first_hit", &question, "more than 6 objects");
    }
}

#[test]
fn a_pixel_lies_in_its_picture() {
    for (name, value) in [("i", 8.0), ("j", 4.0), ("n_x", 0.0), ("n_y", 0.0)] {
        let question = with(camera(), name, value);
        refused("viewing_ray", &question, "no pixel of");
    }
}

#[test]
fn a_camera_without_a_frame_is_no_question() {
    let question = with(with(camera(), "up.Y", 0.0), "up.Z", 3.0);
    refused("viewing_ray", &question, "its view and up are parallel");
}

#[test]
fn an_unknown_task_has_no_questions() {
    refused("intersect", &sphere(), "no such task");
}

#[test]
fn a_question_film_that_is_not_there_is_told_so() {
    let folder = tempfile::tempdir().unwrap();
    let error = read(&folder.path().join("absent.ask.exr"), "sphere").unwrap_err();
    assert!(
        error.problem.starts_with("cannot read this film"),
        "{error}"
    );
}
