//! Compares the oracle with a second one, which is written in Python and uses other formulas.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::str::FromStr;

use dashu_int::UBig;
use dashu_ratio::RBig;
use pinhole_study::family::{HasFamilies, questions, steps};
use pinhole_study::oracle::Truth;
use pinhole_study::question::{Data, Question};
use pinhole_study::shape::{Plane, Sphere, Triangle};

/// Questions at each exponent of each family.
const COUNT: usize = 12;
/// The largest relative difference of t between the oracles is 10 to minus this power: they
/// agree in more than 300 bits.
const AGREE: usize = 91;

/// Runs the second oracle on questions, one per line, and returns its answers.
fn second_opinion(name: &str, lines: &str) -> Vec<String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let own = here.join("../mitsuba/.venv/bin/python");
    let python = if own.is_file() { own } else { "python3".into() };
    let questions = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.txt"));
    fs::write(&questions, lines).expect("it can be written");
    let output = Command::new(python)
        .arg(here.join("tests/second_oracle.py"))
        .stdin(File::open(&questions).expect("it was written"))
        .stderr(Stdio::inherit())
        .output()
        .expect("there is a Python");
    assert!(output.status.success());
    let answers = String::from_utf8(output.stdout).expect("it is text");
    answers.lines().map(str::to_owned).collect()
}

#[track_caller]
fn oracles_agree<S: HasFamilies + std::fmt::Debug>(shape_first: fn(&Question<S>) -> Vec<f64>) {
    let mut asked = Vec::new();
    for data in [Data::F64, Data::F32] {
        for (family, exponent) in steps::<S>(data) {
            asked.extend(questions(&family, exponent, data, COUNT, 3));
        }
    }
    let line = |question: &Question<S>| {
        let mut numbers = shape_first(question);
        numbers.extend(question.ray.origin.array());
        numbers.extend(question.ray.direction.array());
        numbers.push(question.min_t);
        let bits = |number: f64| format!("{:016x}", number.to_bits());
        let numbers: Vec<String> = numbers.into_iter().map(bits).collect();
        format!("{} {}\n", S::NAME, numbers.join(" "))
    };
    let second = second_opinion(S::NAME, &asked.iter().map(line).collect::<String>());
    assert_eq!(second.len(), asked.len());
    let mut hits = 0;
    for (question, second) in asked.iter().zip(&second) {
        let Truth { t, .. } = S::truth(question);
        assert_eq!(t.is_some(), second != "miss", "{question:?}: {second}");
        if let Some(t) = t {
            hits += 1;
            let theirs = RBig::from_str(second).expect("it is a fraction");
            let ours = t.exact.canonicalize();
            let difference = &ours - &theirs;
            let limit = &ours * RBig::from_parts(1.into(), UBig::from(10u8).pow(AGREE));
            let square = |x: &RBig| x * x;
            assert!(
                square(&difference) <= square(&limit),
                "{question:?}: {second}"
            );
        }
    }
    assert!(
        hits > asked.len() / 8,
        "only {hits} of {} questions are hits",
        asked.len()
    );
}

#[test]
fn two_oracles_agree_on_spheres() {
    oracles_agree::<Sphere<f64>>(|q| [&q.shape.center.array()[..], &[q.shape.radius]].concat());
}

#[test]
fn two_oracles_agree_on_planes() {
    oracles_agree::<Plane<f64>>(|q| [q.shape.point.array(), q.shape.normal.array()].concat());
}

#[test]
fn two_oracles_agree_on_triangles() {
    oracles_agree::<Triangle<f64>>(|q| q.shape.corners.map(|corner| corner.array()).concat());
}
