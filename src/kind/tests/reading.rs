//! Questions are read as they were written.

use super::*;
use crate::Hit;
use crate::tree::{FlatNode, FlatTree};

#[track_caller]
fn only_shape(task: &str, question: Channels<'_>) -> Shape {
    let Questions::Intersect(questions) = ask(task, &question).unwrap() else {
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
fn a_disk_is_asked_about_as_it_was_written() {
    let expected = Disk {
        center: dvec3(4.0, 5.0, 6.0),
        normal: dvec3(0.0, 2.0, 1.0),
        radius: 0.75,
    };
    assert_eq!(only_shape("disk", disk()), Shape::Disk(expected));
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
        let (objects, ray, min_t) = match ask(task, &canned()).unwrap() {
            Questions::FirstHit(questions) if task == "first_hit" => {
                let question = &questions[0];
                (question.objects.clone(), question.ray, question.min_t)
            }
            Questions::Soup(questions) if task == "triangle_soup" => {
                let question = &questions[0];
                (
                    question.soup.triangles.clone(),
                    question.ray,
                    question.min_t,
                )
            }
            other => panic!("`{task}` is asked by {other:?}"),
        };
        let at = |t, normal| Intersection { t, normal };
        let [twice, never] = objects.as_slice() else {
            panic!("there are two objects");
        };
        assert_eq!(
            twice.intersections,
            [at(1.5, DVec3::X), at(2.5, DVec3::NEG_Y)]
        );
        assert_eq!(never.intersections, []);
        assert_eq!(min_t, 0.125);
        assert_eq!(ray.origin, dvec3(1.0, 2.0, 3.0));
    }
}

#[test]
fn a_max_t_too_great_for_a_film_is_none() {
    for (max_t, expected) in [(2.5, 2.5), (1e30, f64::INFINITY)] {
        let question = with(ray_and_box(), "max_t", max_t);
        let Questions::RayBox(questions) = ask("ray_box", &question).unwrap() else {
            panic!("it is asked with a box");
        };
        assert_eq!(questions[0].max_t, expected);
    }
}

#[test]
fn a_tree_to_show_stays_with_the_asker() {
    let Questions::Tree(questions) = ask("tree", &boxes_for_a_tree()).unwrap() else {
        panic!("it asks for a tree");
    };
    let leaf = |triangle| FlatNode::Leaf(vec![triangle]);
    let shown = [FlatNode::Branch([1, 2]), leaf(1), leaf(0)];
    assert_eq!(questions[0].example.0, shown);
    let sent = postcard::to_stdvec(&questions[0]).unwrap();
    let received: TreeQuestion = postcard::from_bytes(&sent).unwrap();
    assert_eq!(received.boxes, questions[0].boxes);
    assert_eq!(received.example, FlatTree::default());
}

#[test]
fn a_search_knows_how_the_ray_gets_to_a_triangle() {
    let questions = ask("tree_search", &search()).unwrap();
    let hit = |object| {
        let intersection = Intersection {
            t: 2.5,
            normal: DVec3::Y,
        };
        let hit = Hit {
            object,
            intersection,
        };
        Answer::Hit(Some(hit))
    };
    let second = "the path to the triangle goes through a second child";
    for (triangle, is_second) in [(2, false), (0, true), (9, false)] {
        let conditions = questions.conditions(0, &hit(triangle)).into_iter();
        let met: Vec<&str> = conditions.filter(|it| it.holds).map(|it| it.name).collect();
        assert_eq!(met.contains(&second), is_second, "{met:?}");
        assert!(!met.iter().any(|name| name.contains("after its sibling")));
    }
    let later = with(with(search(), "2.near", 0.5), "2.far", 2.0);
    let questions = ask("tree_search", &later).unwrap();
    let conditions = questions.conditions(0, &hit(2)).into_iter();
    let later = "a box with the triangle is entered after its sibling";
    assert!(conditions.filter(|it| it.holds).any(|it| it.name == later));
    let quantities = questions.quantities(0, &hit(2)).into_iter();
    let quantities: Vec<(&str, f64)> = quantities.map(|it| (it.name, it.value)).collect();
    let expected = [
        ("the t at which the ray enters the root's box", 1.0),
        ("the t at which the ray leaves the root's box", 4.0),
        ("the t at which the ray leaves the leaf's box", 3.0),
    ];
    assert_eq!(quantities[1..], expected);
    let (name, Answer::Hit(Some(other))) = questions.others(0, &hit(0)).pop().unwrap() else {
        panic!("it is no hit");
    };
    assert_eq!(name, "the t at which the ray enters the leaf's box");
    assert_eq!((other.object, other.intersection.t), (0, 0.5));
}

#[test]
fn tests_of_a_search_keep_to_min_t_and_max_t() {
    let questions = ask("tree_search", &search()).unwrap();
    let enters = |node, min_t, max_t| match questions.test(0, Test::Box { node, min_t, max_t }) {
        Some(TestResult::Box(t)) => t,
        other => panic!("{other:?}"),
    };
    assert_eq!(enters(0, 0.5, 9.0), Some(1.0));
    assert_eq!(enters(0, 2.0, 9.0), Some(2.0));
    assert_eq!(enters(1, 0.5, 1.0), Some(1.0));
    assert_eq!(enters(1, 0.5, 0.75), None);
    assert_eq!(enters(1, 3.5, 9.0), None);
    assert_eq!(enters(2, 0.0, 9.0), None);
    let meets = |triangle, min_t| match questions.test(0, Test::Triangle { triangle, min_t }) {
        Some(TestResult::Triangle(met)) => met.map(|met| met.t),
        other => panic!("{other:?}"),
    };
    assert_eq!(meets(2, 2.5), Some(2.5));
    assert_eq!(meets(2, 2.75), None);
    assert_eq!(meets(1, 0.0), None);
}

#[test]
fn what_is_not_in_the_tree_is_not_tested() {
    let questions = ask("tree_search", &search()).unwrap();
    let [min_t, max_t] = [0.0, 9.0];
    for test in [
        Test::Box {
            node: 3,
            min_t,
            max_t,
        },
        Test::Triangle { triangle: 3, min_t },
    ] {
        assert_eq!(questions.test(0, test), None);
        assert_eq!(questions.test(1, test), None);
    }
}

#[test]
fn there_may_be_no_object_at_all() {
    let question = [ray(), vec![("count", 0.0)]].concat();
    let Questions::FirstHit(questions) = ask("first_hit", &question).unwrap() else {
        panic!("it is asked with canned objects");
    };
    assert!(questions[0].objects.is_empty());
}

#[test]
fn a_camera_is_asked_about_one_of_its_pixels() {
    let Questions::ViewingRay(questions) = ask("viewing_ray", &camera()).unwrap() else {
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
    let Questions::ViewingRay(questions) = ask("viewing_ray", &question).unwrap() else {
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
    let (questions, resolution) = read_film(&testing::grid(3, &channels), "sphere").unwrap();
    assert_eq!(resolution, Resolution { n_x: 3, n_y: 2 });
    let Questions::Intersect(questions) = questions else {
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
