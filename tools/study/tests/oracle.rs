//! Compares the oracle with a second one, which is written in Python and uses other formulas.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::str::FromStr;

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use pinhole_study::family::{HasFamilies, questions};
use pinhole_study::oracle::Truth;
use pinhole_study::question::{Data, Question};
use pinhole_study::shape::{Plane, Sphere, Triangle};

/// Questions at each exponent of each family.
const COUNT: usize = 12;
/// The largest relative difference of t between the oracles is 10 to minus this power: they
/// agree in more than 300 bits.
const AGREE: usize = 91;

/// A number as Python's `float.fromhex` reads it.
fn hexadecimal(value: f64) -> String {
    let bits = value.to_bits();
    let (field, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    let sign = if value.is_sign_negative() { "-" } else { "" };
    match field {
        0 => format!("{sign}0x0.{fraction:013x}p-1022"),
        _ => format!("{sign}0x1.{fraction:013x}p{}", field as i64 - 1023),
    }
}

/// A decimal number as Python prints it, 1.25e-3, exactly.
fn decimal(text: &str) -> RBig {
    let (mantissa, exponent) = text.split_once('e').expect("it has an exponent");
    let exponent = exponent.parse::<i32>().expect("it is a number");
    let digits = IBig::from_str(&mantissa.replace('.', "")).expect("they are digits");
    let places = mantissa
        .split_once('.')
        .map_or(0, |(_, places)| places.len()) as i32;
    let power = UBig::from(10u8).pow((exponent - places).unsigned_abs() as usize);
    match exponent >= places {
        true => RBig::from(digits * IBig::from(power)),
        false => RBig::from_parts(digits, power),
    }
}

/// Runs the second oracle on questions, one per line, and returns its answers.
fn second_opinion(lines: &str) -> Vec<String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let own = here.join("../mitsuba/.venv/bin/python");
    let python = if own.is_file() { own } else { "python3".into() };
    let mut python = Command::new(python)
        .arg(here.join("tests/second_oracle.py"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("there is a Python");
    let mut input = python.stdin.take().expect("it was asked for");
    let lines = lines.to_owned();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = python.wait_with_output().expect("it ends");
    writer.join().expect("no panic").expect("it reads all");
    assert!(output.status.success());
    String::from_utf8(output.stdout)
        .expect("it is text")
        .lines()
        .map(str::to_owned)
        .collect()
}

#[track_caller]
fn oracles_agree<S: HasFamilies + std::fmt::Debug>(shape_first: fn(&Question<S>) -> Vec<f64>) {
    let mut asked = Vec::new();
    for family in S::families() {
        for data in [Data::F64, Data::F32] {
            for exponent in (family.exponents)(data) {
                asked.extend(questions(&family, exponent, data, COUNT, 3));
            }
        }
    }
    let line = |question: &Question<S>| {
        let mut numbers = shape_first(question);
        numbers.extend(question.ray.origin.array());
        numbers.extend(question.ray.direction.array());
        numbers.push(question.min_t);
        let numbers: Vec<String> = numbers.into_iter().map(hexadecimal).collect();
        format!("{} {}\n", S::NAME, numbers.join(" "))
    };
    let second = second_opinion(&asked.iter().map(line).collect::<String>());
    assert_eq!(second.len(), asked.len());
    let mut hits = 0;
    for (question, second) in asked.iter().zip(&second) {
        let Truth { t, .. } = S::truth(question);
        assert_eq!(t.is_some(), second != "miss", "{question:?}: {second}");
        if let Some(t) = t {
            hits += 1;
            let (ours, theirs) = (t.exact.canonicalize(), decimal(&second["hit ".len()..]));
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
