//! Difficult questions about spheres: far away, very large, barely touched, or with an origin
//! on the surface.

use super::{Family, HasFamilies, decades, variations};
use crate::question::{Question, ten_to};
use crate::random::Random;
use crate::shape::Sphere;
use crate::vector::Vector;

impl HasFamilies for Sphere<f64> {
    fn families() -> Vec<Family<Self>> {
        vec![
            Family {
                name: "distance",
                axis: "distance / radius = 10^x",
                exponents: |_| decades(9),
                everyday: 3,
                ask: |random, x, _| {
                    let radius = random.within(0.5, 2.0);
                    let squared = random.within(0.0, 2.0);
                    aimed(random, radius, ten_to(x), squared.sqrt())
                },
            },
            Family {
                name: "ground",
                axis: "radius / height of the eye = 10^x",
                exponents: |_| decades(9),
                everyday: 4,
                ask: |random, x, _| ground(random, ten_to(x)),
            },
            Family {
                name: "grazing",
                axis: "distance of the line from the ball's edge = 10^−x radii",
                exponents: |_| (1..=16).collect(),
                everyday: 4,
                ask: |random, x, _| {
                    let radius = random.within(0.5, 2.0);
                    let impact = 1.0 + random.sign() * ten_to(-x);
                    aimed(random, radius, 10.0, impact)
                },
            },
            Family {
                name: "surface",
                axis: "distance of the eye from the surface = 10^−x radii",
                exponents: |_| (1..=17).collect(),
                everyday: 4,
                ask: |random, x, _| {
                    let radius = random.within(0.5, 2.0);
                    let (center, out) = (random.unit(), random.unit());
                    let origin = center + out * (radius * (1.0 + random.sign() * ten_to(-x)));
                    let direction = random.unit() * random.within(0.5, 2.0);
                    Question::new(Sphere { center, radius }, origin, direction)
                },
            },
            variations::direction(),
            variations::offset(),
            variations::scale(),
            variations::threshold("(distance of min_t from the near root) / near root = 10^−x"),
        ]
    }

    /// A ray from a few radii away, with a direction that is not unit length; about half of the
    /// rays hit.
    fn plain(random: &mut Random) -> Question<Sphere<f64>> {
        let (radius, away) = (random.within(0.5, 2.0), random.within(1.0, 5.0));
        let squared = random.within(0.0, 2.0);
        aimed(random, radius, away, squared.sqrt())
    }

    fn moved(self, by: Vector<f64>) -> Sphere<f64> {
        let center = self.center + by;
        Sphere { center, ..self }
    }
}

/// A ray from `away` radii outside the surface, along a line at distance `impact` radii from
/// the centre.
fn aimed(random: &mut Random, radius: f64, away: f64, impact: f64) -> Question<Sphere<f64>> {
    let (center, towards) = (random.unit(), random.unit());
    let distance = radius * (1.0 + away);
    let origin = center + towards * -distance;
    // The line's angle to the centre has the sine impact / distance, both in the same unit.
    let sine = impact * radius / distance;
    let across = random.unit_across(towards) * sine;
    let along = towards * (1.0 - sine * sine).max(0.0).sqrt();
    let direction = (along + across) * random.within(0.5, 2.0);
    Question::new(Sphere { center, radius }, origin, direction)
}

/// A ray from about one unit above a large sphere, aimed at 0.5 to 1.5 times the angle of its
/// horizon below the horizontal.
fn ground(random: &mut Random, radius: f64) -> Question<Sphere<f64>> {
    let up = random.unit();
    let origin = random.unit();
    let height = random.within(0.5, 2.0);
    let center = origin + up * -(radius + height);
    let horizon = (2.0 * height / radius).sqrt().min(1.0);
    let below = horizon * random.within(0.5, 1.5);
    let direction = random.unit_across(up) + up * -below;
    let direction = direction * random.within(0.5, 2.0);
    Question::new(Sphere { center, radius }, origin, direction)
}
