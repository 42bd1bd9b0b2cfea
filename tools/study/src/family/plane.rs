use super::threshold::at_threshold;
use super::{Family, Studied, decades, scales};
use crate::question::{Data, Question, ten_to};
use crate::random::Random;
use crate::shape::{Plane, Ray};
use crate::vector::Vector;

impl Studied for Plane<f64> {
    fn families() -> Vec<Family<Self>> {
        vec![
            Family {
                name: "parallel",
                axis: "angle between ray and plane = 10^−x",
                meaning: "rays that run more and more along the plane; the last is exactly parallel",
                exponents: |_| decades(18),
                easy: 0,
                ask: |random, x, _| parallel(random, x),
            },
            Family {
                name: "direction",
                axis: "length of the direction = 10^x",
                meaning: "the same ray with a longer or a shorter direction: t alone should change",
                exponents: scales,
                easy: 0,
                ask: |random, x, data| {
                    let size = if data == Data::F64 { 1e-13 } else { 1e-6 };
                    let question = plain(random).map(|l| l * size, |n| n, |d| d, |t| t);
                    question.map(|l| l, |n| n, |d| d * ten_to(x), |t| t)
                },
            },
            Family {
                name: "offset",
                axis: "distance of the scene from the world's origin = 10^x",
                meaning: "the same scene moved away from the origin of the world",
                exponents: |_| decades(12),
                easy: 0,
                ask: |random, x, _| {
                    let mut question = plain(random);
                    let offset = random.unit() * ten_to(x);
                    question.shape.point = question.shape.point + offset;
                    question.ray.origin = question.ray.origin + offset;
                    question
                },
            },
            Family {
                name: "scale",
                axis: "size of the scene = 10^x",
                meaning: "the same scene in other units, direction included: t should not change",
                exponents: scales,
                easy: 0,
                ask: |random, x, _| {
                    let scale = ten_to(x);
                    plain(random).map(|l| l * scale, |n| n, |d| d * scale, |t| t)
                },
            },
            Family {
                name: "normal",
                axis: "length of the stored normal = 10^x",
                meaning: "the same plane with a longer or a shorter normal: nothing should change",
                exponents: scales,
                easy: 0,
                ask: |random, x, _| plain(random).map(|l| l, |n| n * ten_to(x), |d| d, |t| t),
            },
            Family {
                name: "threshold",
                axis: "distance of min_t from t = 10^−x of it",
                meaning: "rays that may begin just before or just behind the plane",
                exponents: |_| (1..=17).collect(),
                easy: 1,
                ask: |random, x, _| at_threshold(random, x, plain),
            },
        ]
    }
}

/// A plane and a ray at any angle; half of the rays go away from it.
fn plain(random: &mut Random) -> Question<Plane<f64>> {
    let point = random.unit() * random.within(0.0, 2.0);
    let normal = random.unit() * random.within(0.5, 2.0);
    let origin = random.unit() * random.within(1.0, 5.0);
    let direction = random.unit() * random.within(0.5, 2.0);
    asked(point, normal, origin, direction)
}

/// A ray at the angle 10^−`exponent`; exactly parallel at 18, in one of the axes' planes.
fn parallel(random: &mut Random, exponent: i32) -> Question<Plane<f64>> {
    let Question {
        mut shape, mut ray, ..
    } = plain(random);
    if exponent == 18 {
        shape.normal = shape.normal.map(|_| 0.0);
        shape.normal.y = random.within(0.5, 2.0);
        ray.direction.y = 0.0;
    } else {
        let unit = shape.normal * (1.0 / shape.normal.dot(shape.normal).sqrt());
        let lift = random.sign() * ten_to(-exponent);
        ray.direction = random.unit_across(unit) + unit * lift;
    }
    asked(shape.point, shape.normal, ray.origin, ray.direction)
}

fn asked(
    point: Vector<f64>,
    normal: Vector<f64>,
    origin: Vector<f64>,
    direction: Vector<f64>,
) -> Question<Plane<f64>> {
    let ray = Ray { origin, direction };
    let shape = Plane { point, normal };
    Question {
        shape,
        ray,
        min_t: 0.0,
    }
}
