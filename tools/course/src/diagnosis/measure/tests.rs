use glam::DVec3;
use pinhole::film::{BOX_CHANNELS, Channel, HIT_CHANNELS, TREE_CHANNELS};
use pinhole::judge::Golden;
use pinhole::kind::{Answer, BoundsQuestion, Questions, ShapeQuestion, TreeQuestion};
use pinhole::part::Tally;
use pinhole::tree::TreeMeasures;
use pinhole::{
    BoundingBox, Film, FlatTree, Hit, Intersection, Plane, Ray, Resolution, Shape, Triangle,
};

use super::*;

const COUNT: usize = 200;

/// A number between 0 and 1, the same each time (the golden ratio's fractional parts).
fn random(index: usize, stream: usize) -> f64 {
    ((index * 7 + stream * 13 + 1) as f64 * 0.618_033_988_749).fract()
}

/// A ray to a plane of unit normal, from either side, of any direction.
fn question(index: usize) -> ShapeQuestion {
    let side = if random(index, 0) < 0.3 { -1.0 } else { 1.0 };
    let along = DVec3::new(random(index, 1), random(index, 2), -side);
    ShapeQuestion {
        shape: Shape::Plane(Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z * (1.0 + random(index, 5)),
        }),
        ray: Ray {
            origin: DVec3::Z * side * (1.0 + random(index, 3)),
            direction: along * (0.5 + 4.0 * random(index, 4)),
        },
        min_t: 0.0,
    }
}

fn right(question: &ShapeQuestion) -> Intersection {
    Intersection {
        t: -question.ray.origin.z / question.ray.direction.z,
        // Along y it is 0, apart from rounding, which must not be taken for a factor.
        normal: DVec3::new(0.0, 1e-7, 1.0),
    }
}

fn hit(intersection: Intersection) -> Option<Hit> {
    let object = 0;
    Some(Hit {
        object,
        intersection,
    })
}

/// Questions from this index on, with right and given answers. Only some of the rays may hit
/// anything.
fn group(
    from: usize,
    is_hit: impl Fn(&ShapeQuestion) -> bool,
    answer: impl Fn(&ShapeQuestion, Intersection) -> Option<Intersection>,
) -> (Questions, Vec<Option<Answer>>, Golden) {
    let questions: Vec<ShapeQuestion> = (from..from + COUNT).map(question).collect();
    let right_hit = |it: &ShapeQuestion| hit(right(it)).filter(|_| is_hit(it));
    let hits: Vec<Option<Hit>> = questions.iter().map(right_hit).collect();
    let resolution = Resolution { n_x: COUNT, n_y: 1 };
    let channels = HIT_CHANNELS.map(|name| Channel {
        name: name.into(),
        samples: vec![1e-5; COUNT],
    });
    let tolerance = Film::new(resolution, channels.into());
    let golden = Golden::new(Film::of_hits(resolution, &hits), tolerance);
    let given = |it: &ShapeQuestion| Some(Answer::Hit(answer(it, right(it)).and_then(hit)));
    let answers: Vec<Option<Answer>> = questions.iter().map(given).collect();
    (
        Questions::Intersect(questions),
        answers,
        golden.expect("they belong together"),
    )
}

/// The sentences about these answers. They must hold for other questions, too.
fn said(answer: impl Fn(&ShapeQuestion, Intersection) -> Option<Intersection>) -> Vec<String> {
    said_if(|_| true, answer)
}

/// The same, if only some rays hit anything.
fn said_if(
    is_hit: impl Fn(&ShapeQuestion) -> bool,
    answer: impl Fn(&ShapeQuestion, Intersection) -> Option<Intersection>,
) -> Vec<String> {
    let of = |from: usize| group(from, &is_hit, &answer);
    let (public, fresh) = (of(0), of(1000));
    let asked = |(questions, answers, golden): &'_ (Questions, Vec<Option<Answer>>, Golden)| {
        measure(&[QuestionsAndAnswers {
            questions,
            answers,
            tallies: &[],
            golden,
        }])
    };
    let measured = asked(&public);
    let (questions, answers, golden) = &fresh;
    for measured in &measured {
        let says = &measured.finding.says;
        assert!(
            measured.holds(&[QuestionsAndAnswers {
                questions,
                answers,
                tallies: &[],
                golden
            }]),
            "{says}"
        );
    }
    measured.into_iter().map(|it| it.finding.says).collect()
}

#[test]
fn right_answers_get_no_sentence() {
    assert_eq!(said(|_, right| Some(right)), Vec::<String>::new());
}

#[test]
fn a_t_that_is_a_distance_is_multiplied_by_the_directions_length() {
    let said = said(|question, right| {
        let t = right.t * question.ray.direction.length();
        Some(Intersection { t, ..right })
    });
    let law = "t is multiplied by |d|, in all 200 hits.";
    assert_eq!(
        said,
        [law, "The normal is right in every real hit that you find."]
    );
}

#[test]
fn missed_side_is_described_by_its_condition() {
    let said = said(|question, right| (question.ray.origin.z > 0.0).then_some(right));
    let place = "exactly those where d · n > 0 (the surface is met from behind).";
    assert!(
        said[0].starts_with("You miss") && said[0].ends_with(place),
        "{said:?}"
    );
}

#[test]
fn a_normal_turned_on_one_side_says_where_and_how() {
    let said = said(|question, right| {
        let normal = right.normal * question.ray.origin.z.signum();
        Some(Intersection { normal, ..right })
    });
    assert!(
        said[0].starts_with("The normal has the opposite sign, in "),
        "{said:?}"
    );
    assert!(said[0].contains("exactly where d · n > 0"), "{said:?}");
}

#[test]
fn a_normal_of_another_length_says_which() {
    let said = said(|question, right| {
        let Shape::Plane(plane) = &question.shape else {
            return None;
        };
        let normal = plane.normal;
        Some(Intersection { normal, ..right })
    });
    assert_eq!(said[0], "The normal is multiplied by |n|, in all 200 hits.");
}

#[test]
fn hits_that_are_all_before_min_t_are_described_even_if_every_right_one_is_missed() {
    let front = |question: &ShapeQuestion| question.ray.origin.z > 0.0;
    let rest = "there is none. In each of them, your t is below 0.";
    let invents = |finds: &dyn Fn(usize) -> bool| {
        said_if(front, |question, right| {
            let t = -right.t;
            let is_found = !front(question) && finds(question.ray.direction.x.to_bits() as usize);
            is_found.then_some(Intersection { t, ..right })
        })
    };
    for (finds, many) in [
        (&(|_: usize| true) as &dyn Fn(usize) -> bool, "all "),
        (&|bits| bits % 8 > 0, ""),
    ] {
        let said = invents(finds);
        assert!(said[0].starts_with("You miss all "), "{said:?}");
        let begin = format!("You find a hit in {many}");
        assert!(
            said[1].starts_with(&begin) && said[1].ends_with(rest),
            "{said:?}"
        );
    }
}

#[test]
fn noise_gets_no_law() {
    let said = said(|question, right| {
        let t = right.t + question.ray.direction.x.sin() * question.ray.origin.z.cos();
        Some(Intersection { t, ..right })
    });
    assert!(said[0].starts_with("t is wrong in "), "{said:?}");
}

#[test]
fn a_fixed_bound_is_reported_with_its_number() {
    let said = said(|question, right| {
        let Shape::Plane(plane) = &question.shape else {
            return None;
        };
        let along = question.ray.direction.dot(plane.normal).abs();
        (along >= 1.0).then_some(right)
    });
    let place = "exactly those where |d · n| is less than 1. \
                 Your code may compare it with a fixed bound.";
    assert!(said[0].ends_with(place), "{said:?}");
}

#[test]
fn a_share_is_rounded_to_the_nearest_percent() {
    let said = said(|question, right| {
        let is_doubled = question.ray.direction.length() > 1.5;
        let odd = right.t + question.ray.direction.x.sin() * question.ray.origin.z.cos();
        let t = if is_doubled { 2.0 * right.t } else { odd };
        Some(Intersection { t, ..right })
    });
    let doubled = (0..COUNT).filter(|it| question(*it).ray.direction.length() > 1.5);
    let percent = (100.0 * doubled.count() as f64 / COUNT as f64).round();
    let share = format!("in about {percent} % of the wrong ones, it is 2 times what it should be.");
    assert!(said[0].ends_with(&share), "{said:?}");
}

#[test]
fn single_precision_is_recognised_by_the_numbers_themselves() {
    let said = said(|_, right| {
        let t = f64::from((right.t * 1.5) as f32);
        Some(Intersection { t, ..right })
    });
    assert!(
        said[0].starts_with("t has only single precision"),
        "{said:?}"
    );
    let other = self::said(|_, right| {
        let t = right.t * 1.5;
        Some(Intersection { t, ..right })
    });
    assert!(!other[0].contains("f32"), "{other:?}");
}

#[test]
fn a_part_that_is_never_finite_is_reported_in_few_words() {
    let said = said(|_, right| {
        let normal = DVec3::NAN;
        Some(Intersection { normal, ..right })
    });
    let normal = "The normal is infinite or not a number in all 200 hits.";
    assert!(said.iter().any(|it| it == normal), "{said:?}");
}

#[test]
fn single_precision_is_reported_even_if_every_answer_is_right() {
    let says = |round: fn(f64) -> f64| {
        let answer = |_: &ShapeQuestion, right: Intersection| {
            let t = round(right.t);
            Some(Intersection { t, ..right })
        };
        let (questions, answers, golden) = group(0, |_| true, answer);
        let found = single_precision(&[QuestionsAndAnswers {
            questions: &questions,
            answers: &answers,
            tallies: &[],
            golden: &golden,
        }]);
        found.map(|it| it.finding.says)
    };
    let rounded = says(|t| f64::from(t as f32)).expect("t is rounded");
    assert!(
        rounded.starts_with("t has only single precision"),
        "{rounded}"
    );
    assert_eq!(says(|t| t), None);
}

#[test]
fn a_normal_that_is_the_questions_own_is_not_taken_for_rounded() {
    let said = said(|question, right| {
        let Shape::Plane(plane) = &question.shape else {
            return None;
        };
        let stored = plane.normal.as_vec3().as_dvec3();
        let normal = stored * question.ray.origin.z.signum();
        Some(Intersection { normal, ..right })
    });
    assert!(!said.concat().contains("f32"), "{said:?}");
}

#[test]
fn one_of_two_reasons_for_misses_is_reported_with_its_count() {
    let said = said(|question, right| {
        let is_seen = question.ray.origin.z > 0.0 && question.ray.direction.x.sin() > -0.5;
        is_seen.then_some(right)
    });
    let behind = (0..COUNT).filter(|index| question(*index).ray.origin.z < 0.0);
    let among = format!(
        ", including all {} where d · n > 0 (the surface is met from behind).",
        behind.count()
    );
    assert!(
        said[0].starts_with("You miss ") && said[0].ends_with(&among),
        "{said:?}"
    );
}

#[test]
fn a_part_with_a_law_on_each_side_of_a_condition_gets_two_sentences() {
    let said = said(|question, right| {
        let Shape::Plane(plane) = &question.shape else {
            return None;
        };
        let normal = plane.normal * question.ray.origin.z.signum();
        Some(Intersection { normal, ..right })
    });
    let behind = "Where d · n > 0 (the surface is met from behind), the normal is multiplied by −|n|, in all ";
    assert!(said[0].starts_with(behind), "{said:?}");
    let front = "Where d · n < 0 (the surface is met from the front), the normal is multiplied by |n|, in all ";
    assert!(said[1].starts_with(front), "{said:?}");
}

#[test]
fn parts_that_are_wrong_in_the_same_way_share_a_sentence() {
    let said = said(|question, right| {
        let by = question.ray.direction.x.sin() * question.ray.origin.z.cos();
        let normal = right.normal + DVec3::splat(by);
        let t = right.t + by;
        Some(Intersection { t, normal })
    });
    assert!(
        said[0].starts_with("t and the normal are wrong in "),
        "{said:?}"
    );
}

#[test]
fn an_axis_with_a_law_is_described_beside_one_without() {
    let said = said(|question, right| {
        let mut normal = right.normal;
        normal.x += 0.5;
        normal.y += question.ray.direction.x.sin() * question.ray.origin.z.cos();
        Some(Intersection { normal, ..right })
    });
    let law = "The normal along x is too large by 0.5, is right along z, and is also wrong \
               along y, in all 200 hits.";
    assert_eq!(said[0], law);
}

/// A tree in which this many triangles are misplaced.
fn tree_with(misplaced: usize) -> TreeMeasures {
    TreeMeasures {
        misplaced,
        depth: 1,
        largest_leaf: 1,
        cost: if misplaced == 0 { 4.0 } else { 0.0 },
    }
}

/// What is said about trees with these measures. All measures except misplaced triangles may be up
/// to 8.
fn said_of_trees(measures: impl Fn(usize) -> TreeMeasures) -> Vec<String> {
    said_of_branches(measures, 0)
}

/// The same, if this many of the four branches of each tree divide badly.
fn said_of_branches(measures: impl Fn(usize) -> TreeMeasures, bad: usize) -> Vec<String> {
    let question = || TreeQuestion {
        boxes: vec![
            BoundingBox {
                min: DVec3::ZERO,
                max: DVec3::ONE,
            };
            2
        ],
        example: FlatTree::default(),
    };
    let given = |index: usize| Some(Answer::Tree(measures(index)));
    let resolution = Resolution { n_x: COUNT, n_y: 1 };
    let all = |sample: f32| {
        let channel = |name: &str| Channel {
            name: name.into(),
            samples: vec![if name == "misplaced" { 0.0 } else { sample }; COUNT],
        };
        Film::new(resolution, TREE_CHANNELS.map(channel).into())
    };
    let golden = Golden::new(all(0.0), all(8.0)).expect("the two belong together");
    let questions = Questions::Tree((0..COUNT).map(|_| question()).collect());
    let answers: Vec<Option<Answer>> = (0..COUNT).map(given).collect();
    let tally = Tally {
        steps: "branches",
        sort: "divide badly",
        explains: Some("the expected number of tests"),
        some: bad,
        all: 4,
    };
    let tallies = vec![vec![tally]; COUNT];
    let asked = QuestionsAndAnswers {
        questions: &questions,
        answers: &answers,
        tallies: &tallies,
        golden: &golden,
    };
    let measured = measure(&[asked]);
    measured.into_iter().map(|it| it.finding.says).collect()
}

#[test]
fn a_tree_without_all_triangles_has_no_right_number_of_tests() {
    let right = |said: &[String]| said.last().expect("something is said").clone();
    for misplaced in [|_| 1, |index| usize::from(index % 3 == 0)] as [fn(usize) -> usize; 2] {
        let said = said_of_trees(|index| tree_with(misplaced(index)));
        assert_eq!(
            right(&said),
            "The depth and the largest leaf are right everywhere."
        );
        assert!(!said.concat().contains("tests"), "{said:?}");
    }
}

#[test]
fn a_part_above_its_limit_is_told_with_the_limit() {
    let leaves = |largest: fn(usize) -> usize| {
        said_of_trees(|index| TreeMeasures {
            largest_leaf: largest(index),
            ..tree_with(0)
        })
    };
    assert_eq!(leaves(|index| index % 9), Vec::<String>::new());
    let half = COUNT / 2;
    let said = leaves(|index| if index % 2 == 0 { 8 } else { 9 + index % 3 });
    let worst = "11 at worst, where at most 8 is allowed";
    let leaf = format!("The largest leaf is too large in {half} of {COUNT} questions: {worst}.");
    assert_eq!(said[0], leaf);
    // Nothing else is above its limit.
    let rest = "The number of missing, repeated or unknown triangles, the depth and the expected \
                number of tests are";
    assert_eq!(said[1..], [format!("{rest} right everywhere.")]);
}

#[test]
fn a_part_that_always_has_the_same_value_above_its_limit_is_told_with_it() {
    let trees = |misplaced: fn(usize) -> usize| said_of_trees(|index| tree_with(misplaced(index)));
    let said = trees(|_| 1).concat();
    assert!(
        said.contains("unknown triangles is always 1, in all 200"),
        "{said}"
    );
    let said = trees(|index| 1 + index % 2).concat();
    assert!(!said.contains("always"), "{said}");
}

#[test]
fn bad_branches_are_told_if_they_may_explain_what_is_wrong() {
    let told = |cost: f64, bad: usize| {
        let measures = |index: usize| TreeMeasures {
            cost: if index.is_multiple_of(2) { cost } else { 4.0 },
            largest_leaf: 9,
            ..tree_with(0)
        };
        let said = said_of_branches(measures, bad);
        said.contains(&format!(
            "Of {} branches, {} divide badly.",
            4 * COUNT,
            bad * COUNT
        ))
    };
    assert!(told(9.0, 3));
    assert!(!told(9.0, 0));
    assert!(!told(4.0, 3), "the number of tests is right");
}

#[test]
fn another_answer_is_named_even_if_some_questions_lack_it() {
    let corner = |index: usize, stream| DVec3::splat(random(index, stream));
    let question = |index: usize| match index % 2 {
        0 => BoundsQuestion::Triangle(Triangle {
            corners: [1, 2, 3].map(|stream| corner(index, stream)),
        }),
        _ => {
            let of = |stream| BoundingBox {
                min: corner(index, stream),
                max: corner(index, stream) + DVec3::ONE,
            };
            BoundsQuestion::Boxes(of(1), of(2))
        }
    };
    let questions: Vec<BoundsQuestion> = (0..COUNT).map(question).collect();
    let right = |question: &BoundsQuestion| match question {
        BoundsQuestion::Triangle(Triangle { corners: [a, b, c] }) => BoundingBox {
            min: a.min(*b).min(*c),
            max: a.max(*b).max(*c),
        },
        BoundsQuestion::Boxes(a, b) => BoundingBox {
            min: a.min.min(b.min),
            max: a.max.max(b.max),
        },
    };
    // A triangle's box is wrong in some way, and a join is the second box.
    let given = |question: &BoundsQuestion| match question {
        BoundsQuestion::Triangle(_) => BoundingBox {
            min: right(question).min - (9.0 * right(question).max).powf(1.7),
            ..right(question)
        },
        BoundsQuestion::Boxes(_, b) => *b,
    };
    let resolution = Resolution { n_x: COUNT, n_y: 1 };
    let rights: Vec<BoundingBox> = questions.iter().map(right).collect();
    let tolerance = Film::new(
        resolution,
        BOX_CHANNELS
            .map(|name| Channel {
                name: name.into(),
                samples: vec![1e-5; COUNT],
            })
            .into(),
    );
    let golden = Golden::new(Film::of_boxes(resolution, &rights), tolerance);
    let answers = questions.iter().map(|it| Some(Answer::Box(given(it))));
    let measured = measure(&[QuestionsAndAnswers {
        answers: &answers.collect::<Vec<_>>(),
        questions: &Questions::Bounds(questions),
        tallies: &[],
        golden: &golden.expect("they belong together"),
    }]);
    let said: Vec<&str> = measured.iter().map(|it| it.finding.says.as_str()).collect();
    assert!(said.concat().contains("that of the second box"), "{said:?}");
}
