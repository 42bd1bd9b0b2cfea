//! Casts by a plan. Which object is first is decided exactly. t and the normal are computed in
//! `f64` if that is proven to be accurate enough, and exactly otherwise.

use rayon::prelude::*;

use super::bounds::{OF_UNIT, PROVEN_T, normal_of, of_normal, of_t};
use super::{AccuracyTarget, exact_hit};
use crate::cast::model::Exact;
use crate::cast::world::{Part, Primitive, World};
use crate::cast::{Caster, Found, Search, Seen, Tally};
use crate::kernel::sphere::ScaledRay;
use crate::shape::Ray;
use crate::vector::Vector;

/// A scene ready to be cast by a plan.
pub struct PlannedCaster {
    wish: AccuracyTarget,
    min_t: f64,
    search: Search,
    caster: Caster,
}

const NO_NORMAL: Vector<f64> = Vector {
    x: 0.0,
    y: 0.0,
    z: 0.0,
};

impl PlannedCaster {
    /// Prepares the parts of a scene.
    pub fn new(world: World, min_t: f64, wish: AccuracyTarget) -> PlannedCaster {
        PlannedCaster {
            wish,
            min_t,
            search: Search::cheaper(&world.parts),
            caster: Caster::new(world),
        }
    }

    /// Casts one ray. t and normal are 0 if they are not requested.
    #[inline]
    pub fn see(&self, ray: &Ray<f64>, tally: &mut Tally) -> Seen {
        let Found { part, t } = self
            .caster
            .first::<Exact>(self.search, ray, self.min_t, tally)?;
        let (t, normal) = match self.proven(part, ray, t) {
            Some(normal) => (t, normal),
            None => {
                tally.exact_hits += 1;
                exact_hit::exact_hit(&part.shape, ray, self.min_t)
            }
        };
        let AccuracyTarget {
            depth,
            normal: wants_normal,
            ..
        } = self.wish;
        let t = if depth { t } else { 0.0 };
        Some((
            part.object,
            t,
            if wants_normal { normal } else { NO_NORMAL },
        ))
    }

    /// The normal, if it and t are proven to have the requested accuracy.
    #[inline]
    fn proven(&self, part: &Part, ray: &Ray<f64>, t: f64) -> Option<Vector<f64>> {
        let normal = self.proven_from(&part.shape, ray, t, PROVEN_T);
        normal.or_else(|| {
            let closer = of_t(&part.shape, &ScaledRay::new(ray));
            let is_worth_it = self.wish.depth || matches!(part.shape, Primitive::Sphere(_));
            is_worth_it
                .then(|| self.proven_from(&part.shape, ray, t, closer))
                .flatten()
        })
    }

    /// Like `proven`, given the relative error of t. A subnormal or overflowing t has no such
    /// bound.
    #[inline]
    fn proven_from(
        &self,
        shape: &Primitive,
        ray: &Ray<f64>,
        t: f64,
        of_t: f64,
    ) -> Option<Vector<f64>> {
        let AccuracyTarget {
            accuracy,
            depth,
            normal,
        } = self.wish;
        let has_digits = (1e-300..1e300).contains(&t);
        if depth && !(of_t <= accuracy && has_digits) {
            return None;
        }
        if !normal {
            return Some(NO_NORMAL);
        }
        let (normal, turned) = match shape {
            Primitive::Plane(plane) => (plane.normal.unit(), OF_UNIT),
            Primitive::Triangle(triangle) => normal_of(triangle),
            Primitive::Sphere(sphere) => {
                let away = (ray.origin - sphere.center).largest();
                let turned = if has_digits {
                    of_normal(sphere, away, of_t)
                } else {
                    f64::INFINITY
                };
                (shape.normal(ray, t), turned)
            }
        };
        (turned <= accuracy).then_some(normal)
    }

    /// Casts many rays, on all cores.
    pub fn film(&self, rays: &[Ray<f64>]) -> (Vec<Seen>, Tally) {
        let cast = |rays: &[Ray<f64>]| {
            let mut tally = Tally::default();
            let see = |ray| self.see(ray, &mut tally);
            (rays.iter().map(see).collect::<Vec<_>>(), tally)
        };
        let pieces: Vec<_> = rays.par_chunks(512).map(cast).collect();
        let tally = pieces
            .iter()
            .fold(Tally::default(), |sum, (_, tally)| sum.plus(*tally));
        let seen = pieces.into_iter().flat_map(|(seen, _)| seen).collect();
        (seen, tally)
    }
}
