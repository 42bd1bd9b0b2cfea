//! Difficult questions about triangles: far away, thin, seen edge-on, or without area.

use super::{Family, HasFamilies, decades, scales, variations};
use crate::question::{Question, ten_to};
use crate::random::Random;
use crate::shape::Triangle;
use crate::vector::Vector;

impl HasFamilies for Triangle<f64> {
    fn families() -> Vec<Family<Self>> {
        vec![
            Family {
                name: "distance",
                axis: "distance / size = 10^x",
                exponents: |_| decades(9),
                everyday: 3,
                ask: |random, x, _| {
                    let corners = well_shaped(random);
                    let from = random.unit();
                    aimed(random, corners, from, ten_to(x))
                },
            },
            Family {
                name: "sliver",
                axis: "length / width = 10^x",
                exponents: |_| decades(9),
                everyday: 2,
                ask: |random, x, _| {
                    let a = random.unit();
                    let along = random.unit();
                    let across = random.unit_across(along) * ten_to(-x);
                    let c = a + along * random.within(0.0, 1.0) + across;
                    let from = random.unit();
                    aimed(random, [a, a + along, c], from, 3.0)
                },
            },
            Family {
                name: "edge-on",
                axis: "angle between ray and triangle = 10^−x",
                exponents: |_| decades(16),
                everyday: 2,
                ask: |random, x, _| {
                    let corners = well_shaped(random);
                    let [a, b, c] = corners;
                    let normal = (b - a).cross(c - a);
                    let normal = normal * (1.0 / normal.dot(normal).sqrt());
                    let along = random.unit_across(normal);
                    aimed(random, corners, along + normal * ten_to(-x), 3.0)
                },
            },
            Family {
                name: "flat",
                axis: "corners: 0 all at one point, 1 two at one point, 2 in a line, 3 in a line but for rounding",
                exponents: |_| decades(3),
                everyday: -1,
                ask: |random, x, _| flat(random, x),
            },
            variations::direction(),
            variations::offset(),
            Family {
                name: "scale",
                axis: "size of the scene = 10^x",
                exponents: scales,
                everyday: 3,
                ask: |random, x, _| Self::plain(random).map(|l| l * ten_to(x), |n| n, |d| d, |t| t),
            },
            Family {
                name: "small",
                axis: "size of the scene = 10^−x",
                exponents: |_| decades(9),
                everyday: 3,
                ask: |random, x, _| {
                    Self::plain(random).map(|l| l * ten_to(-x), |n| n, |d| d, |t| t)
                },
            },
            variations::threshold("(distance of min_t from t) / t = 10^−x"),
        ]
    }

    /// A ray from a few sizes away, from any side.
    fn plain(random: &mut Random) -> Question<Triangle<f64>> {
        let corners = well_shaped(random);
        let (from, away) = (random.unit(), random.within(1.0, 5.0));
        aimed(random, corners, from, away)
    }

    fn moved(self, by: Vector<f64>) -> Triangle<f64> {
        let corners = self.corners.map(|corner| corner + by);
        Triangle { corners }
    }
}

/// A triangle with no angle near 0° or 180°.
fn well_shaped(random: &mut Random) -> [Vector<f64>; 3] {
    loop {
        let corners = [random.unit(), random.unit(), random.unit()];
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a);
        if normal.dot(normal) > 0.5 {
            return corners;
        }
    }
}

/// A ray from the direction `from`, aimed at a point in the triangle or around it in its plane.
fn aimed(
    random: &mut Random,
    corners: [Vector<f64>; 3],
    from: Vector<f64>,
    away: f64,
) -> Question<Triangle<f64>> {
    let [a, b, c] = corners;
    let (alpha, beta) = (random.within(-0.3, 1.0), random.within(-0.3, 1.0));
    let target = a + (b - a) * alpha + (c - a) * beta;
    let direction = from * -random.within(0.5, 2.0);
    Question::new(Triangle { corners }, target + from * away, direction)
}

/// Corners that coincide or are collinear. They are exactly so for kinds 0 to 2, because all
/// coordinates are multiples of 1/4096.
fn flat(random: &mut Random, kind: i32) -> Question<Triangle<f64>> {
    let coarse = |vector: Vector<f64>| vector.map(|x| (x * 1024.0).round() / 1024.0);
    let (a, along) = (coarse(random.unit()), coarse(random.unit()));
    let at = random.within(0.0, 1.0);
    let corners = match kind {
        0 => [a, a, a],
        1 => [a, a + along, a + along],
        2 => [a, a + along, a + along * 0.25],
        _ => [a, a + along, a + along * at],
    };
    let from = random.unit();
    let target = a + along * at;
    let origin = target + from * 3.0;
    Question::new(Triangle { corners }, origin, target - origin)
}
