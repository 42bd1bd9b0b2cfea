//! Tests the study itself: broken kernels are noticed, and correct kernels are not blamed.

use std::cell::Cell;
use std::sync::LazyLock;

use pinhole_study::conditioning::{condition, decade};
use pinhole_study::contestants::Contestant;
use pinhole_study::contestants::{EXACT, HasKernels};
use pinhole_study::extent::{Extent, Part};
use pinhole_study::family::{Family, HasFamilies, questions, steps};
use pinhole_study::judge::{Tally, judge};
use pinhole_study::kernel::{Kernel, sphere, triangle};
use pinhole_study::leaks::{self, Aim};
use pinhole_study::oracle::HasTruth;
use pinhole_study::question::{Class, Question};
use pinhole_study::result::{Findings, Trade};
use pinhole_study::run::run;
use pinhole_study::secondary;
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::targets::targets;
use pinhole_study::vector::Vector;

const SEED: u64 = 7;

/// Tallies of one `f64` or `f32` contestant over every family and exponent.
fn over_all<S: HasFamilies>(kernel: &Contestant<S>, count: usize) -> Vec<(String, Tally)> {
    let tally = |(family, exponent): (Family<S>, i32)| {
        let asked = questions(&family, exponent, kernel.data, count, SEED);
        let truths: Vec<_> = asked.iter().map(S::truth).collect();
        let place = format!("{} {} {exponent}", S::NAME, family.name);
        (place, judge(kernel, &asked, &truths).0)
    };
    steps(kernel.data).map(tally).collect()
}

/// A kernel in `f64` with these answers.
fn with_answers<S: HasKernels>(answer: fn(&Question<S>) -> Option<f64>) -> Contestant<S> {
    let (_, kernel) = S::exact_kernel();
    Contestant { answer, ..kernel }
}

#[test]
fn a_kernel_that_takes_the_far_root_is_noticed() {
    let broken = with_answers(|Question { shape, ray, min_t }: &Question<Sphere<f64>>| {
        let near = sphere::plainly(shape, ray, *min_t)?;
        sphere::plainly(shape, ray, near.next_up() + near.abs() * 1e-9).or(Some(near))
    });
    let tallies = over_all(&broken, 50);
    let roots: u64 = tallies.iter().map(|(_, tally)| tally.wrong_roots).sum();
    assert!(roots > 1000, "{roots}");
}

#[test]
fn a_kernel_that_is_one_ulp_off_is_noticed() {
    let broken = with_answers(|question: &Question<Triangle<f64>>| {
        let mut question = *question;
        question.ray.direction.x = question.ray.direction.x.next_up();
        (Triangle::exact_kernel().1.answer)(&question)
    });
    let tallies = over_all(&broken, 50);
    let wrong: u64 = tallies.iter().map(|(_, tally)| tally.wrong()).sum();
    assert!(wrong > 0);
}

#[test]
fn a_kernel_that_leaves_out_edges_leaks() {
    let broken = with_answers(|Question { shape, ray, min_t }: &Question<Triangle<f64>>| {
        let [a, b, c] = shape.corners.map(|corner| corner - ray.origin);
        let volumes = [b.cross(c), c.cross(a), a.cross(b)].map(|area| area.dot(ray.direction));
        let is_inside = volumes.iter().all(|v| *v > 0.0) || volumes.iter().all(|v| *v < 0.0);
        triangle::MollerTrumbore::intersect(shape, ray, *min_t).filter(|_| is_inside)
    });
    let tally = leaks::of_kernel(&broken, Aim::Vertex, 500, SEED);
    assert!(tally.leaks > 50, "{tally:?}");
}

#[test]
fn an_eye_at_the_centre_sees_the_sphere_at_its_radius() {
    let zero = Vector::new(0.0, 0.0, 0.0);
    let (center, radius) = (zero, 1.0);
    let direction = Vector::new(0.0, -0.5, 0.0);
    let question = Question::new(Sphere { center, radius }, zero, direction);
    for kernel in Sphere::contestants() {
        assert_eq!(
            (kernel.answer)(&question),
            Some(2.0),
            "{} {}",
            kernel.name,
            kernel.numbers
        );
    }
}

/// Values that replace a number. The smallest and the largest finite ones are those of `f32`,
/// which `f64` can represent too.
const SPOILERS: [f64; 7] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1.401298464324817e-45,
    f32::MAX as f64,
    0.0,
    -0.0,
];

/// Replaces each number of a question in turn. If the question becomes invalid, the kernel must
/// miss; otherwise it must give the true answer.
fn survives_replaced_numbers<S: HasFamilies + std::fmt::Debug>(kernel: &Contestant<S>, value: f64) {
    let families = S::families();
    let plain = families.iter().find(|family| family.name == "offset");
    let plain = plain.expect("every shape has an offset");
    for question in questions(plain, 0, kernel.data, 20, SEED) {
        for place in 0.. {
            let at = Cell::new(0);
            let replace = |number: f64| {
                at.set(at.get() + 1);
                if at.get() == place + 1 { value } else { number }
            };
            let spoilt = question.map(replace, replace, replace, replace);
            if at.get() <= place {
                break;
            }
            if spoilt.is_sound() {
                let tally = judge(kernel, &[spoilt], &[S::truth(&spoilt)]).0;
                assert_eq!(tally.wrong() + tally.not_finite, 0, "{spoilt:?}");
            } else if spoilt.min_t != f64::NEG_INFINITY {
                // −∞ is a valid min_t: it accepts every t.
                let answer = (kernel.answer)(&spoilt);
                assert_eq!(answer, None, "{} {spoilt:?}", kernel.name);
            }
        }
    }
}

#[test]
fn exact_kernels_survive_replaced_numbers() {
    fn survive<S: HasFamilies + std::fmt::Debug>() {
        let exact = S::contestants().into_iter().filter(|it| it.name == EXACT);
        for kernel in exact {
            for value in SPOILERS {
                survives_replaced_numbers(&kernel, value);
            }
        }
    }
    survive::<Sphere<f64>>();
    survive::<Plane<f64>>();
    survive::<Triangle<f64>>();
}

/// The part `classes` of a study with few questions.
static FINDINGS: LazyLock<Findings> = LazyLock::new(judged_classes);

fn judged_classes() -> Findings {
    let extent = Extent {
        only: Some(Part::Classes),
        seed: SEED,
        questions: 60,
        ..Extent::QUICK
    };
    run(&extent, &|_| ())
}

/// Wrong and judged decisions of one kernel in one class, on few questions.
fn traded(shape: &str, class: Class, kernel: &str, numbers: &str) -> (u64, u64) {
    let is_it = |it: &&Trade| {
        (it.shape, it.class) == (shape, class) && (it.kernel, it.numbers) == (kernel, numbers)
    };
    let trade = FINDINGS
        .trades
        .iter()
        .find(is_it)
        .expect("this kernel was measured");
    let missed = targets(&FINDINGS).into_iter().filter(|target| !target.met);
    assert_eq!(
        missed.map(|target| target.about).collect::<Vec<_>>(),
        [""; 0]
    );
    (trade.wrong, trade.asked)
}

#[test]
fn each_class_shows_which_kernels_fail_in_it() {
    let share = |(wrong, asked): (u64, u64)| wrong as f64 / asked as f64;
    let textbook = |class, numbers| share(traded("sphere", class, "textbook", numbers));
    assert_eq!(textbook(Class::Everyday, "f64"), 0.0);
    assert!(textbook(Class::Everyday, "f32") > 0.0);
    assert!((0.005..0.1).contains(&textbook(Class::Hard, "f64")));
    assert!(textbook(Class::Absurd, "f64") > 0.2);
    for class in Class::ALL {
        assert_eq!(traded("sphere", class, EXACT, "f64").0, 0);
    }
}

#[test]
fn a_question_is_as_sensitive_as_its_conditioning_says() {
    // If n · d is 1e-6 times the magnitude of its products, t is a million times as sensitive.
    for (across, expected) in [(1.0, 0), (1e-6, 6)] {
        let at = |x, y, z| Vector::new(x, y, z);
        let (point, normal) = (at(0.0, 0.0, 0.0), at(1.0, 0.0, 1.0));
        let (origin, direction) = (at(0.0, 0.0, 1.0), at(1.0, 0.0, -1.0 - across));
        let question = Question::new(Plane { point, normal }, origin, direction);
        let condition = condition(&question, &Plane::truth(&question));
        let condition = condition.expect("the ray hits the plane");
        assert_eq!(decade(condition / 1.5), expected, "{condition}");
    }
}

#[test]
fn secondary_rays_hit_their_own_surface_unless_their_origin_is_offset() {
    let all = secondary::studied(2_000, SEED);
    for tally in &all {
        let is_moved = ["pbrt-v4", "Wächter–Binder"].contains(&tally.method);
        assert!(!is_moved || tally.self_hits <= 10, "{tally:?}");
    }
    let computed = all.iter().filter(|tally| tally.method == "as computed");
    assert!(computed.map(|tally| tally.self_hits).sum::<u64>() > 1_000);
}

#[test]
fn repeated_study_gives_identical_sweeps() {
    let sweeps = |findings: &Findings| serde_json::to_string(&findings.families).expect("JSON");
    let (first, second) = (sweeps(&FINDINGS), sweeps(&judged_classes()));
    assert!(first.len() > 1000 && first == second);
}
