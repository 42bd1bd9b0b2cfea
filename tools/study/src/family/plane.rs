//! Difficult questions about planes: nearly parallel rays, and normals that are not unit
//! length.

use super::{Family, HasFamilies, decades, scales, variations};
use crate::question::{Question, ten_to};
use crate::random::Random;
use crate::shape::Plane;
use crate::vector::Vector;

impl HasFamilies for Plane<f64> {
    fn families() -> Vec<Family<Self>> {
        vec![
            Family {
                name: "parallel",
                axis: "angle between ray and plane = 10^−x",
                exponents: |_| decades(18),
                everyday: 2,
                ask: |random, x, _| parallel(random, x),
            },
            variations::direction(),
            variations::offset(),
            variations::scale(),
            Family {
                name: "normal",
                axis: "length of the stored normal = 10^x",
                exponents: scales,
                everyday: 3,
                ask: |random, x, _| Self::plain(random).map(|l| l, |n| n * ten_to(x), |d| d, |t| t),
            },
            variations::threshold("(distance of min_t from t) / t = 10^−x"),
        ]
    }

    /// A plane and a ray at any angle.
    fn plain(random: &mut Random) -> Question<Plane<f64>> {
        let point = random.unit() * random.within(0.0, 2.0);
        let normal = random.unit() * random.within(0.5, 2.0);
        let origin = random.unit() * random.within(1.0, 5.0);
        let direction = random.unit() * random.within(0.5, 2.0);
        Question::new(Plane { point, normal }, origin, direction)
    }

    fn moved(self, by: Vector<f64>) -> Plane<f64> {
        let point = self.point + by;
        Plane { point, ..self }
    }
}

/// A ray at the angle 10^−`exponent` to the plane. At 18 it is exactly parallel, to an
/// axis-aligned plane.
fn parallel(random: &mut Random, exponent: i32) -> Question<Plane<f64>> {
    let Question {
        mut shape, mut ray, ..
    } = Plane::plain(random);
    if exponent == 18 {
        shape.normal = shape.normal.map(|_| 0.0);
        shape.normal.y = random.within(0.5, 2.0);
        ray.direction.y = 0.0;
    } else {
        let unit = shape.normal * (1.0 / shape.normal.dot(shape.normal).sqrt());
        let lift = random.sign() * ten_to(-exponent);
        ray.direction = random.unit_across(unit) + unit * lift;
    }
    Question::new(shape, ray.origin, ray.direction)
}
