use glam::DVec3;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::{Notation, ObjectTable};
use crate::error::Error;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::Ray;
use crate::words::vector;

/// A flat triangle, edges included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Triangle {
    /// The corners a, b, c, counter-clockwise when seen from outside; world space.
    pub corners: [DVec3; 3],
}

/// Corners count as lying on one line if the sine of each angle is below this. The limit is not 0,
/// because rounding of decimals such as 0.3 moves corners off their line by about 1e-16 of their
/// size.
const ON_ONE_LINE: f64 = 1e-14;

/// The unit vector from one corner to another; 0 if they coincide. The square of a long edge
/// overflows, and so may the edge itself.
fn direction(from: DVec3, to: DVec3) -> DVec3 {
    let edge = match to - from {
        edge if edge.is_finite() => edge,
        _ => 0.5 * to - 0.5 * from,
    };
    (edge / edge.abs().max_element()).normalize_or_zero()
}

fn lie_on_one_line([a, b, c]: [DVec3; 3]) -> bool {
    let sine = |at, one, other| direction(at, one).cross(direction(at, other)).length();
    let sines = [sine(a, b, c), sine(b, c, a), sine(c, a, b)];
    sines.iter().all(|sine| *sine < ON_ONE_LINE)
}

impl Notation for Triangle {
    const KEYS: &'static [&'static str] = &["corners"];

    fn read_table(table: &ObjectTable<'_>) -> Result<Triangle, Error> {
        let corners: Spanned<[DVec3; 3]> = table.get("corners")?;
        let [a, b, c] = *corners.get_ref();
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Err(table.source.not_finite("corners", corners.span()));
        }
        if lie_on_one_line([a, b, c]) {
            return Err(table.source.error(
                corners.span(),
                "these corners lie on one line, so the triangle has no area and no normal",
                "move one corner off the line",
            ));
        }
        Ok(Triangle { corners: [a, b, c] })
    }

    fn read_samples(samples: Samples<'_>) -> Result<Triangle, String> {
        let corner = |name| samples.vector(name);
        Ok(Triangle {
            corners: [corner("a")?, corner("b")?, corner("c")?],
        })
    }

    fn words(&self, digits: usize) -> String {
        let [a, b, c] = self.corners.map(|corner| vector(corner, digits));
        format!("a = {a}, b = {b}, c = {c}")
    }

    fn quantities(&self, ray: &Ray) -> Vec<Quantity> {
        let edge = |from: usize| self.corners[(from + 1) % 3] - self.corners[from];
        let lengths = [0, 1, 2].map(|from| edge(from).length());
        let sine = edge(0).angle_between(edge(2)).sin();
        vec![
            Quantity::new("the longest edge", lengths.into_iter().fold(0.0, f64::max)),
            Quantity::new("twice the area", lengths[0] * lengths[2] * sine),
            Quantity::new(
                "|d · (b − a) × (c − a)|",
                ray.direction.dot(edge(0).cross(-edge(2))).abs(),
            ),
        ]
    }

    fn conditions(&self, _: &Ray, point: DVec3) -> Vec<Condition> {
        // A point is beyond an edge if the edge's line separates it from the opposite corner.
        let is_beyond = |[from, to, opposite]: [usize; 3]| {
            let [from, to, opposite] = [from, to, opposite].map(|k| self.corners[k]);
            let away = (opposite - from).reject_from(to - from);
            (point - from).dot(away) < 0.0
        };
        let beyond = [[0, 1, 2], [1, 2, 0], [2, 0, 1]].map(is_beyond);
        let beside = beyond.contains(&true);
        let [ab, bc, ca] = beyond;
        // Single edges come before all three together, because an edge says which condition is
        // missing.
        vec![
            Condition::new(
                "the point lies beyond edge ab",
                "the point does not lie beyond edge ab",
                ab,
            ),
            Condition::new(
                "the point lies beyond edge bc",
                "the point does not lie beyond edge bc",
                bc,
            ),
            Condition::new(
                "the point lies beyond edge ca",
                "the point does not lie beyond edge ca",
                ca,
            ),
            Condition::new(
                "the point lies outside the triangle",
                "the point lies on the triangle",
                beside,
            ),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_lie_on_one_line_in_whatever_order() {
        let [zero, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
        for (corners, expected) in [
            ([zero, 0.1 * (x + y), 0.3 * (x + y)], true),
            ([zero, zero, x], true),
            ([1e15 * x, y, -y], false),
            ([-1.7e308 * x, 1.7e308 * x, 1.7e308 * y], false),
            ([zero, 5e-324 * x, 5e-324 * y], false),
        ] {
            let [a, b, c] = corners;
            for corners in [[a, b, c], [b, c, a], [c, b, a]] {
                assert_eq!(lie_on_one_line(corners), expected, "{corners:?}");
            }
        }
    }

    #[test]
    fn an_edge_is_named_before_the_whole_triangle() {
        let triangle = Triangle {
            corners: [DVec3::ZERO, DVec3::X, DVec3::Y],
        };
        let ray = Ray {
            origin: DVec3::Z,
            direction: -DVec3::Z,
        };
        let beyond = |x: f64, y: f64| {
            let conditions = triangle.conditions(&ray, DVec3::new(x, y, 0.0));
            let first = conditions.into_iter().find(|it| it.holds);
            first.map(|condition| condition.name)
        };
        assert_eq!(beyond(0.25, 0.25), None);
        assert_eq!(beyond(0.5, -0.1), Some("the point lies beyond edge ab"));
        assert_eq!(beyond(0.6, 0.6), Some("the point lies beyond edge bc"));
        assert_eq!(beyond(-0.1, 0.5), Some("the point lies beyond edge ca"));
    }
}
