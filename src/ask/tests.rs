use std::path::Path;
use std::time::Instant;

use super::*;
use crate::bounds::BoundingBox;
use crate::camera::{Camera, Pixel, Projection, Resolution};
use crate::film::TESTS;
use crate::job::{Message, Panic};
use crate::kind::{
    Answer, CameraQuestion, ObjectsQuestion, Questions, SearchQuestion, Test, TestResult,
    TestResults, TreeQuestion, WireAnswer,
};
use crate::ray::{Hit, Intersection, Ray};
use crate::scene::Scene;
use crate::testing::Random;
use crate::tree::{FlatNode, FlatTree, NodeBox, TreeMeasures};
use glam::DVec3;

mod fuzz;
#[cfg(unix)]
mod process;

const RAY: Ray = Ray {
    origin: DVec3::ZERO,
    direction: DVec3::Z,
};

/// A job with this many hits.
fn hits(count: usize) -> Job {
    let question = ObjectsQuestion {
        objects: Vec::new(),
        ray: RAY,
        min_t: 0.0,
    };
    Job::Ask(Questions::FirstHit(vec![question; count]))
}

/// A job with this many rays.
fn rays(count: usize) -> Job {
    let projection = Projection::Orthographic;
    let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (1.0, 1.0), projection);
    let question = CameraQuestion {
        camera: camera.unwrap(),
        pixel: Pixel { i: 0, j: 0 },
        resolution: Resolution { n_x: 1, n_y: 1 },
    };
    Job::Ask(Questions::ViewingRay(vec![question; count]))
}

fn hit(object: usize) -> Answer {
    let intersection = Intersection {
        t: 1.0,
        normal: DVec3::X,
    };
    Answer::Hit(Some(Hit {
        object,
        intersection,
    }))
}

fn answers(first: usize, answers: &[Answer]) -> Message {
    let answers = answers.iter().copied().map(WireAnswer::Answer).collect();
    Message::Answers { first, answers }
}

/// Sends these messages and expects only the last one to be refused.
#[track_caller]
fn refused(job: &Job, messages: &[Message], why: &str) -> Reply {
    let mut reply = Reply::before(job);
    let (last, before) = messages.split_last().unwrap();
    for message in before {
        reply.take(job, message.clone()).unwrap();
    }
    let said = reply.take(job, last.clone()).unwrap_err();
    assert!(said.contains(why), "{said}");
    assert!(reply.missing > 0, "a refused message completed the reply");
    reply
}

mod message {
    use super::*;

    #[test]
    fn answers_may_come_in_any_order() {
        let job = hits(5);
        let mut reply = Reply::before(&job);
        let take = |reply: &mut Reply, first, given: &[_]| reply.take(&job, answers(first, given));
        assert_eq!(take(&mut reply, 3, &[hit(3), hit(4)]), Ok(Next::Receive));
        assert_eq!(take(&mut reply, 0, &[hit(0)]), Ok(Next::Receive));
        assert_eq!(take(&mut reply, 1, &[hit(1), hit(2)]), Ok(Next::End));
        let objects = reply
            .hits()
            .unwrap()
            .into_iter()
            .map(|hit| hit.unwrap().object);
        assert!(objects.eq(0..5));
    }

    #[test]
    fn a_question_that_was_not_asked_has_no_answer() {
        let job = hits(5);
        for first in [5, 6, 1 << 40, usize::MAX] {
            refused(&job, &[answers(first, &[hit(0)])], "not asked");
        }
        refused(&job, &[answers(4, &[hit(0), hit(0)])], "not asked");
    }

    #[test]
    fn message_without_an_answer_is_refused() {
        // A stream of such messages would keep its reader busy until time is up.
        refused(&hits(5), &[answers(0, &[])], "without an answer");
    }

    #[test]
    fn a_question_is_answered_once() {
        let job = hits(3);
        let again = [answers(0, &[hit(0)]), answers(0, &[hit(1)])];
        let reply = refused(&job, &again, "twice");
        assert_eq!(reply.answers[0], Some(hit(0)), "the first answer counts");
    }

    #[test]
    fn a_message_that_overlaps_another_completes_nothing() {
        let job = hits(2);
        let overlapping = [answers(1, &[hit(1)]), answers(0, &[hit(0), hit(9)])];
        refused(&job, &overlapping, "twice");
    }

    #[test]
    fn ray_for_a_hit_or_hit_for_a_ray_is_refused() {
        refused(&hits(2), &[answers(0, &[Answer::Ray(RAY)])], "another kind");
        refused(&rays(2), &[answers(0, &[hit(0)])], "another kind");
        refused(
            &hits(2),
            &[answers(0, &[hit(0), Answer::Ray(RAY)])],
            "another kind",
        );
    }

    #[test]
    fn tests_that_a_submission_counts_itself_stay_out_of_the_film_that_is_judged() {
        let projection = Projection::Orthographic;
        let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (1.0, 1.0), projection);
        let resolution = Resolution { n_x: 2, n_y: 1 };
        let job = Job::Film(Scene {
            camera: camera.unwrap(),
            resolution,
            min_t: 0.0,
            objects: Vec::new(),
        });
        let mut reply = Reply::before(&job);
        assert_eq!(reply.own_tests(resolution), None);
        let counted = vec![WireAnswer::Answer(hit(0)), WireAnswer::Counted(hit(1), 7)];
        let message = |answers| Message::Answers { first: 0, answers };
        assert_eq!(reply.take(&job, message(counted.clone())), Ok(Next::End));
        let tests = reply.own_tests(resolution).expect("they are counted");
        assert_eq!(tests.channel(TESTS), Some(&[0.0, 7.0][..]));
        assert_eq!(reply.film(resolution).channel(TESTS), None);
        let half = Resolution { n_x: 1, n_y: 1 };
        let tests = reply.split([1, 1].into_iter()).pop();
        let tests = tests
            .and_then(|part| part.own_tests(half))
            .expect("they are split");
        assert_eq!(tests.channel(TESTS), Some(&[7.0][..]));
        refused(&hits(2), &[message(counted)], "another kind");
    }

    fn tree_question(boxes: Vec<BoundingBox>) -> TreeQuestion {
        TreeQuestion {
            boxes,
            example: FlatTree::default(),
        }
    }

    #[test]
    fn trees_are_kept_as_outlines_for_pictures() {
        let bounds = |x: f64| BoundingBox {
            min: DVec3::splat(x),
            max: DVec3::splat(x + 1.0),
        };
        let ask = |x| Questions::Tree(vec![tree_question(vec![bounds(x)]); 2]);
        let mut both = ask(0.0);
        assert!(both.append(&ask(5.0)));
        let job = Job::Ask(both);
        let mut reply = Reply::before(&job);
        assert!(reply.outlines.is_empty());
        let leaf = || WireAnswer::Tree(FlatTree(vec![FlatNode::Leaf(vec![0])]));
        let answers = (0..4).map(|_| leaf()).collect();
        let next = reply.take(&job, Message::Answers { first: 0, answers });
        assert_eq!(next, Ok(Next::End));
        for (part, x) in reply.split([2, 2].into_iter()).iter().zip([0.0, 5.0]) {
            let root = NodeBox {
                depth: 0,
                bounds: bounds(x),
            };
            assert_eq!(part.outlines, [[root], [root]]);
        }
    }

    #[test]
    fn a_list_of_nodes_that_is_no_tree_is_refused() {
        let (min, max) = (DVec3::ZERO, DVec3::ONE);
        let boxes = vec![BoundingBox { min, max }];
        let job = Job::Ask(Questions::Tree(vec![tree_question(boxes)]));
        let tree = |nodes| Message::Answers {
            first: 0,
            answers: vec![WireAnswer::Tree(FlatTree(nodes))],
        };
        let circle = vec![FlatNode::Branch([0, 0])];
        refused(&job, &[tree(circle)], "another kind");
        // A branch, its leaf and the next branch, a thousand times.
        let level = |k: usize| {
            let branch = FlatNode::Branch([2 * k + 1, 2 * k + 2]);
            [branch, FlatNode::Leaf(vec![0])]
        };
        let mut deep: Vec<FlatNode> = (0..1000).flat_map(level).collect();
        deep.push(FlatNode::Leaf(vec![0]));
        refused(&job, &[tree(deep)], "another kind");
        let measures = TreeMeasures {
            misplaced: 0,
            depth: 0,
            largest_leaf: 0,
            cost: 0.0,
        };
        // Measures that the submission computed itself.
        refused(
            &job,
            &[answers(0, &[Answer::Tree(measures)])],
            "another kind",
        );
        let mut reply = Reply::before(&job);
        let leaf = tree(vec![FlatNode::Leaf(vec![0])]);
        assert_eq!(reply.take(&job, leaf), Ok(Next::End));
    }

    #[test]
    fn only_searches_are_tested() {
        let test = Message::Test(
            0,
            Test::Box {
                node: 0,
                min_t: 0.0,
                max_t: 1.0,
            },
        );
        refused(&hits(1), &[test], "unknown question");
    }

    /// A search knows a question only by tests of it, and each of these is counted, whatever a
    /// submission sends before, meanwhile or afterwards.
    #[test]
    fn no_message_lowers_the_count_of_tests() {
        let leaf = |triangle| FlatNode::Leaf(vec![triangle]);
        let question = SearchQuestion {
            tree: FlatTree(vec![FlatNode::Branch([1, 2]), leaf(0), leaf(1)]),
            min_t: 0.0,
            results: TestResults {
                boxes: vec![Some(1.0..=2.0); 3],
                triangles: Vec::new(),
            },
        };
        let job = Job::Ask(Questions::TreeSearch(vec![question; 3]));
        let test = |index, node| {
            let (min_t, max_t) = (0.0, 9.0);
            Message::Test(index, Test::Box { node, min_t, max_t })
        };
        let mut reply = Reply::before(&job);
        let entered = || Ok(Next::Send(TestResult::Box(Some(1.0))));
        for (index, node) in [(0, 0), (0, 0), (1, 2), (0, 1)] {
            assert_eq!(reply.take(&job, test(index, node)), entered());
        }
        reply.take(&job, answers(0, &[hit(0)])).unwrap();
        assert_eq!(reply.take(&job, test(0, 2)), entered());
        reply.take(&job, answers(1, &[hit(0)])).unwrap();
        assert!(reply.take(&job, answers(0, &[hit(0)])).is_err());
        for (index, node) in [(2, 3), (2, usize::MAX), (3, 0), (usize::MAX, 0)] {
            assert!(
                reply.take(&job, test(index, node)).is_err(),
                "{index} {node}"
            );
        }
        assert_eq!(reply.tests[..2], [4, 1]);
        assert!(reply.missing > 0, "a refused message completed the reply");
    }

    #[test]
    fn needless_steps_of_a_search_are_counted() {
        let leaf = |triangle| FlatNode::Leaf(vec![triangle]);
        let met = |object, t| Hit {
            object,
            intersection: Intersection {
                t,
                normal: DVec3::X,
            },
        };
        let question = SearchQuestion {
            tree: FlatTree(vec![FlatNode::Branch([1, 2]), leaf(0), leaf(1)]),
            min_t: 0.0,
            results: TestResults {
                boxes: vec![Some(1.0..=9.0), Some(1.0..=2.0), Some(3.0..=9.0)],
                triangles: vec![met(0, 1.5), met(1, 4.0)],
            },
        };
        let job = Job::Ask(Questions::TreeSearch(vec![question; 2]));
        let mut reply = Reply::before(&job);
        let mut test = |index, nodes: &[usize], triangles: &[usize]| {
            let (min_t, max_t) = (0.0, f64::INFINITY);
            let boxes = nodes.iter().map(|&node| Test::Box { node, min_t, max_t });
            let triangles = triangles.iter();
            let triangles = triangles.map(|&triangle| Test::Triangle { triangle, min_t });
            for test in boxes.chain(triangles) {
                reply.take(&job, Message::Test(index, test)).unwrap();
            }
        };
        // The nearer box first, and then the one behind the hit.
        test(0, &[0, 1, 2], &[0, 1]);
        // The farther box first, and one box twice.
        test(1, &[0, 1, 2, 2], &[1, 0]);
        reply.take(&job, answers(0, &[hit(0), hit(0)])).unwrap();
        let counts = |index: usize| {
            let tallies = reply.tallies[index].iter();
            tallies.map(|it| (it.some, it.all)).collect::<Vec<_>>()
        };
        assert_eq!(counts(0), [(0, 1), (0, 3), (1, 3), (0, 3)]);
        assert_eq!(counts(1), [(1, 1), (0, 3), (0, 3), (1, 4)]);
    }

    #[test]
    fn a_panic_ends_the_reply_and_stays_within_the_job() {
        let job = hits(3);
        let mut reply = Reply::before(&job);
        let panic = Panic {
            message: "é".repeat(MOST_PANIC_TEXT),
            file: "<".repeat(50 * MOST_PANIC_TEXT),
            line: 1,
            index: usize::MAX,
        };
        assert_eq!(reply.take(&job, Message::Panicked(panic)), Ok(Next::End));
        let Ending::Panicked(panic) = reply.ending else {
            panic!("it ended in another way");
        };
        assert_eq!(panic.index, 2);
        assert!(panic.message.len() <= MOST_PANIC_TEXT);
        assert!(panic.file.len() <= MOST_PANIC_TEXT);
    }

    #[test]
    fn panic_in_a_job_without_questions_is_reported() {
        let job = hits(0);
        let panic = Panic {
            message: String::new(),
            file: String::new(),
            line: 0,
            index: 5,
        };
        assert_eq!(
            Reply::before(&job).take(&job, Message::Panicked(panic)),
            Ok(Next::End)
        );
    }

    #[test]
    fn a_chunk_of_any_answers_fits_into_a_message() {
        let far = Hit {
            object: usize::MAX,
            intersection: Intersection {
                t: f64::MAX,
                normal: DVec3::MAX,
            },
        };
        for answer in [Answer::Hit(Some(far)), Answer::Ray(RAY)] {
            let mut bytes = Vec::new();
            let message = answers(usize::MAX, &[answer; CHUNK]);
            crate::job::send(&message, &mut bytes).unwrap();
            assert!(bytes.len() - 4 <= MOST_MESSAGE);
        }
    }

    #[test]
    fn no_sequence_of_messages_makes_the_asker_panic() {
        let mut random = Random::new(1);
        for _ in 0..3000 {
            let job = [hits(4), rays(4)][random.below(2)].clone();
            let mut reply = Reply::before(&job);
            for _ in 0..random.below(6) {
                let first = *random.one_of(&[0, 1, 2, 3, 4, 5, usize::MAX]);
                let given = (0..random.below(4))
                    .map(|_| *random.one_of(&[hit(0), Answer::Hit(None), Answer::Ray(RAY)]))
                    .collect::<Vec<_>>();
                if reply.take(&job, answers(first, &given)).is_err() {
                    break;
                }
                let missing = reply.answers.iter().filter(|answer| answer.is_none());
                assert_eq!(missing.count(), reply.missing);
            }
            reply.film(Resolution { n_x: 2, n_y: 2 });
        }
    }
}

mod reply {
    use super::*;

    fn complete(answers: &[Answer]) -> Reply {
        let mut reply = Reply::before(&hits(0));
        reply.answers = answers.iter().copied().map(Some).collect();
        reply
    }

    fn row(n_x: usize) -> Resolution {
        Resolution { n_x, n_y: 1 }
    }

    #[test]
    fn missing_answer_becomes_a_miss() {
        let mut reply = complete(&[hit(3), Answer::Hit(None), hit(5)]);
        reply.answers[2] = None;
        assert_eq!(reply.film(row(3)).channel("id").unwrap(), [3.0, -1.0, -1.0]);
    }

    #[test]
    fn rays_make_a_film_of_rays() {
        let film = complete(&[Answer::Ray(RAY); 2]).film(row(2));
        assert_eq!(film.channel("D.Z").unwrap(), [1.0, 1.0]);
        assert_eq!(film.channel("id"), None);
    }

    #[test]
    fn rays_count_only_if_every_one_came() {
        let mut reply = complete(&[Answer::Ray(RAY); 2]);
        assert_eq!(reply.rays(), Some(vec![RAY; 2]));
        reply.answers[0] = None;
        assert_eq!((reply.rays(), reply.hits()), (None, None));
    }

    #[test]
    fn a_split_reply_has_every_answer_where_it_was_asked() {
        let all: Vec<Answer> = (0..6).map(hit).collect();
        let mut reply = complete(&all);
        reply.ending = Ending::Died(Death::Lost);
        reply.answers[4] = None;
        let parts = reply.split([1, 0, 3, 2].into_iter());

        let asked: Vec<_> = parts.iter().flat_map(|part| &part.answers).collect();
        for (index, answer) in asked.into_iter().enumerate() {
            assert_eq!(*answer, (index != 4).then_some(all[index]));
        }
        let lengths: Vec<usize> = parts.iter().map(|part| part.answers.len()).collect();
        assert_eq!(lengths, [1, 0, 3, 2]);
        let missing: Vec<usize> = parts.iter().map(|part| part.missing).collect();
        assert_eq!(missing, [0, 0, 0, 1]);
        assert!(
            parts
                .iter()
                .all(|part| part.ending == Ending::Died(Death::Lost))
        );
    }

    #[test]
    #[should_panic = "some answers are left over"]
    fn a_reply_is_split_without_rest() {
        complete(&[hit(0), hit(1)]).split([1].into_iter());
    }
}
