//! What a submission's process answers.

use std::time::Duration;

use super::*;
use crate::ask::{Death, Ending, Reply, ask};
use crate::camera::Projection;
use crate::kind::{
    Answer, CameraQuestion, Kind, ObjectsQuestion, Questions, SearchQuestion, ShapeQuestion,
    SoupQuestion, TestResults, TreeQuestion, Unregistered,
};
use crate::scene::Scene;
use crate::tree::{FlatNode, FlatTree, TreeMeasures};

const LONG_ENOUGH: Duration = Duration::from_secs(60);

const RAY: Ray = Ray {
    origin: DVec3::X,
    direction: DVec3::X,
};

fn camera() -> Camera {
    let projection = Projection::Orthographic;
    Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (1.0, 1.0), projection).unwrap()
}

/// Its film has several chunks, not all of them full.
fn scene() -> Scene {
    Scene {
        camera: camera(),
        resolution: Resolution { n_x: 50, n_y: 21 },
        min_t: 0.25,
        objects: vec![sphere()],
    }
}

fn film() -> Job {
    Job::Film(scene())
}

fn sphere() -> Shape {
    Shape::Sphere(Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    })
}

fn rays(count: usize) -> Job {
    let question = |i| CameraQuestion {
        camera: camera(),
        pixel: Pixel { i, j: 3 },
        resolution: Resolution { n_x: count, n_y: 4 },
    };
    Job::Ask(Questions::ViewingRay((0..count).map(question).collect()))
}

#[track_caller]
fn asked(kind: &str, job: &Job) -> Reply {
    ask(submission(kind), job, LONG_ENOUGH, &mut |_| {}).unwrap()
}

#[track_caller]
fn answered(job: &Job) -> Vec<Answer> {
    let reply = asked("able", job);
    assert_eq!(reply.ending, Ending::Complete, "{}", reply.printed);
    reply.answers.into_iter().map(Option::unwrap).collect()
}

fn hit(object: usize, t: f64, normal: DVec3) -> Answer {
    let intersection = Intersection { t, normal };
    Answer::Hit(Some(Hit {
        object,
        intersection,
    }))
}

#[test]
fn every_pixel_gets_its_own_ray() {
    let resolution = Resolution { n_x: 50, n_y: 21 };
    for (index, answer) in answered(&film()).into_iter().enumerate() {
        let Pixel { i, j } = resolution.pixel(index);
        let expected = match i {
            0 => Answer::Hit(None),
            _ => hit(1, 0.25, dvec3(i as f64, j as f64, 0.0)),
        };
        assert_eq!(answer, expected, "({i}, {j})");
    }
}

#[test]
fn scenes_cast_together_are_the_scenes_cast_alone() {
    let smaller = Scene {
        resolution: Resolution { n_x: 30, n_y: 7 },
        min_t: 0.5,
        ..scene()
    };
    let together = asked("able", &Job::Films(vec![scene(), smaller.clone()]));
    let alone = [film(), Job::Film(smaller)];
    let parts = together.split(alone.iter().map(Job::len));
    for (job, part) in alone.iter().zip(parts) {
        let answers: Vec<Answer> = part.answers.into_iter().flatten().collect();
        assert_eq!(answers, answered(job));
    }
}

#[test]
fn progress_grows_to_the_number_of_answers() {
    let mut seen = vec![0];
    let job = film();
    ask(submission("able"), &job, LONG_ENOUGH, &mut |done| {
        seen.push(done);
    })
    .unwrap();
    assert!(seen.is_sorted_by(|before, after| before < after));
    assert_eq!(seen.last(), Some(&job.len()));
}

#[test]
fn viewing_rays_come_in_the_order_asked() {
    for (i, answer) in answered(&rays(700)).into_iter().enumerate() {
        let Answer::Ray(ray) = answer else {
            panic!("a ray was asked for");
        };
        assert_eq!(ray.origin, dvec3(i as f64, 3.0, 0.0));
    }
}

#[test]
fn each_shape_is_asked_about_as_it_was_sent() {
    let plane = Shape::Plane(Plane {
        point: DVec3::ZERO,
        normal: DVec3::X,
    });
    let shapes = [sphere(), plane];
    let met = shapes.each_ref().map(|shape| {
        let told = shape.words(6).len() as f64;
        hit(0, told, DVec3::Y)
    });
    assert_ne!(met[0], met[1], "the two could be mixed up");
    let questions = shapes.map(|shape| ShapeQuestion {
        shape,
        ray: RAY,
        min_t: 4.0,
    });
    let job = Job::Ask(Questions::Intersect(questions.into()));
    assert_eq!(answered(&job), met);
}

#[test]
fn canned_objects_are_asked_of_first_hit_or_of_the_soup() {
    let object = |t| Canned {
        ray: RAY,
        intersections: vec![Intersection {
            t,
            normal: DVec3::Z,
        }],
    };
    let objects = vec![object(5.0), object(2.0)];
    let (ray, min_t) = (RAY, 0.5);
    let question = ObjectsQuestion {
        objects: objects.clone(),
        ray,
        min_t,
    };
    let job = Job::Ask(Questions::FirstHit(vec![question]));
    assert_eq!(answered(&job), [hit(2, 0.5, DVec3::X)]);
    let question = SoupQuestion {
        soup: TriangleSoup { triangles: objects },
        ray,
        min_t,
    };
    let job = Job::Ask(Questions::Soup(vec![question]));
    assert_eq!(answered(&job), [hit(0, 5.0, DVec3::Z)]);
}

#[test]
fn missing_function_is_named() {
    let shape = ShapeQuestion {
        shape: sphere(),
        ray: RAY,
        min_t: 0.0,
    };
    for (job, kind) in [
        (film(), Kind::FirstHit),
        (Job::Cast(RAY, 0.0, vec![sphere()]), Kind::FirstHit),
        (
            Job::Ask(Questions::Intersect(vec![shape; 1000])),
            Kind::Intersect,
        ),
    ] {
        let reply = asked("unregistered", &job);
        assert_eq!(reply.ending, Ending::Unregistered(Unregistered(kind)));
        assert!(reply.answers.iter().all(Option::is_none));
    }
    assert_eq!(asked("unregistered", &rays(3)).ending, Ending::Complete);
}

#[test]
fn one_ray_is_cast_among_real_shapes() {
    let job = Job::Cast(RAY, 0.5, vec![sphere(), sphere(), sphere()]);
    assert_eq!(answered(&job), [hit(3, 0.5, DVec3::X)]);
}

#[track_caller]
fn panicked(kind: &str, job: &Job) -> Panic {
    match asked(kind, job).ending {
        Ending::Panicked(panic) => panic,
        other => panic!("it ended in another way: {other:?}"),
    }
}

#[test]
fn a_todo_is_unanswered_and_names_its_file() {
    let panic = panicked("unanswered", &film());
    assert!(panic.is_unanswered(), "{panic:?}");
    assert!(panic.file.ends_with("serve/tests.rs"), "{panic:?}");
    assert!(panic.line > 0);
}

#[test]
fn panic_names_its_question() {
    let panic = panicked("stumbling", &rays(9));
    assert_eq!(panic.index, 7);
    assert!(panic.message.contains("the len is 3"), "{panic:?}");
    assert!(!panic.is_unanswered());
}

#[test]
fn the_library_does_not_help_with_an_answer() {
    let panic = panicked("prying", &rays(1));
    assert!(panic.message.contains("only Pinhole may ask"), "{panic:?}");
}

#[test]
fn panic_that_no_question_reaches_has_no_effect() {
    assert_eq!(asked("stumbling", &rays(7)).ending, Ending::Complete);
}

#[test]
fn a_long_panic_is_cut_between_characters() {
    let panic = panicked("long-winded", &rays(1));
    assert_eq!(panic.message, "é".repeat(MOST_PANIC_TEXT / 2));
}

#[test]
fn a_stack_overflow_aborts_and_says_so() {
    let reply = asked("bottomless", &rays(1));
    assert_eq!(reply.ending, Ending::Died(Death::Signal(6)));
    assert!(reply.printed.contains("stack overflow"), "{reply:?}");
}

#[test]
fn a_submission_that_exits_in_an_answer_has_died() {
    let ending = asked("leaving", &rays(1)).ending;
    assert_eq!(ending, Ending::Died(Death::Exit(7)));
}

#[test]
fn endless_loop_ends_at_its_time_limit() {
    let second = Duration::from_secs(1);
    let reply = ask(submission("endless"), &rays(1), second, &mut |_| {}).unwrap();
    assert_eq!(reply.ending, Ending::TimedOut(second));
    assert_eq!(reply.answers, [None]);
}

#[test]
fn time_out_names_the_question_that_is_still_being_answered() {
    let second = Duration::from_secs(1);
    let reply = ask(submission("stuck"), &rays(9), second, &mut |_| {}).unwrap();
    assert_eq!(reply.ending, Ending::TimedOut(second));
    assert_eq!(reply.still_at, Some(7));
    let parts = reply.split([7, 2].into_iter());
    let at: Vec<_> = parts.iter().map(|part| part.still_at).collect();
    assert_eq!(at, [None, Some(0)]);
}

#[test]
fn what_a_student_prints_is_kept_apart_from_the_answers() {
    let reply = asked("talkative", &rays(3));
    assert_eq!(reply.ending, Ending::Complete);
    assert_eq!(reply.printed.matches("an honest line\n").count(), 3);
    assert_eq!(reply.printed.matches("an honest complaint\n").count(), 3);
}

#[test]
fn endless_answer_ends_when_the_asker_is_gone() {
    use std::os::fd::OwnedFd;
    use std::os::unix::net::UnixStream;
    use std::process::Stdio;

    let (mut asker, theirs) = UnixStream::pair().unwrap();
    let mut child = submission("endless")
        .stdin(OwnedFd::from(theirs))
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    job::send(&rays(9), &mut asker).unwrap();
    std::thread::sleep(Duration::from_secs(1));
    assert!(child.try_wait().unwrap().is_none(), "it was not endless");
    drop(asker);
    let start = std::time::Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > LONG_ENOUGH {
            child.kill().unwrap();
            panic!("it runs on without an asker");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// Two boxes of two triangles each, of which the ray meets the nearest in the second.
fn search() -> SearchQuestion {
    let leaf = |first| FlatNode::Leaf(vec![first, first + 1]);
    let met = |object, t| Hit {
        object,
        intersection: Intersection {
            t,
            normal: DVec3::Y,
        },
    };
    SearchQuestion {
        tree: FlatTree(vec![FlatNode::Branch([1, 2]), leaf(2), leaf(0)]),
        min_t: 1.0,
        results: TestResults {
            boxes: vec![Some(0.5..=9.0), Some(4.0..=9.0), Some(0.5..=3.0)],
            triangles: vec![met(3, 5.0), met(1, 2.0)],
        },
    }
}

#[test]
fn tests_of_a_search_are_answered_and_counted_by_the_asker() {
    let job = Job::Ask(Questions::TreeSearch(vec![search(); 300]));
    let reply = asked("able", &job);
    assert_eq!(reply.ending, Ending::Complete, "{}", reply.printed);
    for answer in &reply.answers {
        assert_eq!(*answer, Some(hit(1, 2.0, DVec3::Y)));
    }
    // Three boxes and four triangles: the submission tests everything.
    assert_eq!(reply.tests, vec![7; 300]);
    let film = reply.film(Resolution { n_x: 30, n_y: 10 });
    assert_eq!(film.channel("tests").unwrap()[299], 7.0);
}

#[test]
fn a_search_without_end_is_stopped() {
    let job = Job::Ask(Questions::TreeSearch(vec![search()]));
    let Ending::Garbled(why) = asked("testing", &job).ending else {
        panic!("it ended in another way");
    };
    assert!(why.contains("ten times as many tests"), "{why}");
}

#[test]
fn a_tree_is_measured_by_the_asker() {
    let bounds = |x: f64| BoundingBox {
        min: dvec3(x, 0.0, 0.0),
        max: dvec3(x + 1.0, 1.0, 1.0),
    };
    let boxes: Vec<BoundingBox> = (0..3).map(|x| bounds(2.0 * f64::from(x))).collect();
    let question = TreeQuestion {
        boxes: boxes.clone(),
        example: FlatTree::default(),
    };
    let job = Job::Ask(Questions::Tree(vec![question; 300]));
    let measures = TreeMeasures {
        misplaced: 0,
        depth: 2,
        largest_leaf: 1,
        // The half surface of the whole is 11, that of the first leaf 3, and that of the branch
        // beside it 7.
        cost: (2.0 * 11.0 + 2.0 * 7.0 + 3.0 * 3.0) / 11.0,
    };
    for answer in answered(&job) {
        assert_eq!(answer, Answer::Tree(measures));
    }
}
