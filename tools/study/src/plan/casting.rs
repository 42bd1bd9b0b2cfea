//! Casting as planned: each kind of shape in its own numbers; what they leave uncertain is
//! cast again in better ones.

use rayon::prelude::*;

use super::bounds::Rounding;
use super::{Kind, Numbers, Wish, watch};
use crate::cast::kernels::Usual;
use crate::cast::model::{Exact, Plain, exact};
use crate::cast::narrow::{Narrow, rounded};
use crate::cast::world::{Part, Primitive, World};
use crate::cast::{Caster, Found, Search, Tally};
use crate::dyadic::{Dyadic, DyadicVector};
use crate::root::Root;
use crate::shape::Ray;
use crate::vector::Vector;

/// What is to be cast with what.
#[derive(Clone, Debug)]
pub struct How {
    /// What for.
    pub wish: Wish,
    /// For spheres, planes and triangles: the numbers, and whether each hit is watched.
    pub numbers: [(Numbers, bool); 3],
    /// Of what is in `f32`.
    pub narrow: Search,
    /// Of the rest.
    pub wide: Search,
}

/// A scene ready to be cast so.
pub struct Casting {
    how: How,
    min_t: f64,
    /// Everything: what is uncertain is cast again here.
    all: Caster,
    /// In the order in which they were given.
    parts: Vec<Part>,
    narrow: Option<Narrow>,
    /// What is not in `f32`, if that is not everything.
    wide: Option<Caster>,
}

/// What is seen: object, t and normal, each 0 if it is not asked for.
pub type Seen = Option<(u32, f64, Vector<f64>)>;

/// Pixels by who had the last word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Spent {
    /// All of them.
    pub pixels: u64,
    /// Uncertain in `f32`, and cast again in `f64`.
    pub again_in_f64: u64,
    /// Uncertain in `f64` too, and cast again by exact arithmetic.
    pub again_exactly: u64,
}

impl Spent {
    fn plus(self, other: Spent) -> Spent {
        Spent {
            pixels: self.pixels + other.pixels,
            again_in_f64: self.again_in_f64 + other.again_in_f64,
            again_exactly: self.again_exactly + other.again_exactly,
        }
    }
}

impl Casting {
    /// Of a scene's parts.
    pub fn new(world: &World, min_t: f64, how: How) -> Casting {
        let is_narrow =
            |part: &&Part| how.numbers[Kind::of(&part.shape) as usize].0 == Numbers::F32;
        let (narrow, wide): (Vec<&Part>, Vec<&Part>) = world.parts.iter().partition(is_narrow);
        let rest = (!narrow.is_empty() && !wide.is_empty()).then(|| {
            let mut rest = World::default();
            for part in &wide {
                rest.add(part.object as usize, part.shape);
            }
            // The places stay those of the scene.
            for (part, given) in rest.parts.iter_mut().zip(&wide) {
                part.place = given.place;
            }
            Caster::new(rest)
        });
        Casting {
            how,
            min_t,
            narrow: (!narrow.is_empty()).then(|| Narrow::new(narrow.into_iter())),
            wide: rest,
            parts: world.parts.clone(),
            all: Caster::new(world.clone()),
        }
    }

    /// What is seen along a ray.
    #[inline]
    pub fn see(&self, ray: &Ray<f64>, spent: &mut Spent) -> Seen {
        spent.pixels += 1;
        match (&self.narrow, &self.wide) {
            _ if self.how.wish.exact_ids => self.see_decided(ray, spent),
            (None, _) => self.see_wide(ray, spent),
            (Some(narrow), wide) => {
                let near = narrow.first::<Usual>(self.how.narrow, &rounded(ray), self.min_t as f32);
                let found = wide.as_ref().and_then(|wide| self.plain(wide, ray));
                let far = found.map_or(f64::INFINITY, |found| found.t);
                match near.filter(|near| f64::from(near.t) < far) {
                    None => self.certain(found?, ray, spent),
                    Some(near) => {
                        let (t, part) = (f64::from(near.t), &self.parts[near.place as usize]);
                        if !self.is_good(part, ray, t, Rounding::F32, false) {
                            spent.again_in_f64 += 1;
                            return self.see_wide(ray, spent);
                        }
                        let normal = || near.normal(&rounded(ray)).map(f64::from);
                        Some(self.asked(part, t, normal))
                    }
                }
            }
        }
    }

    #[inline]
    fn see_wide(&self, ray: &Ray<f64>, spent: &mut Spent) -> Seen {
        self.certain(self.plain(&self.all, ray)?, ray, spent)
    }

    #[inline]
    fn plain<'a>(&self, caster: &'a Caster, ray: &Ray<f64>) -> Option<Found<'a>> {
        caster.first::<Plain>(self.how.wide, ray, self.min_t, &mut Tally::default())
    }

    /// What was found in `f64`, if that is certain; else what is exact.
    #[inline]
    fn certain(&self, Found { part, t }: Found, ray: &Ray<f64>, spent: &mut Spent) -> Seen {
        match self.is_good(part, ray, t, Rounding::F64, false) {
            true => Some(self.asked(part, t, || on(part, ray, t))),
            false => self.see_exactly(ray, spent),
        }
    }

    /// By kernels that decide exactly; what t and normal they leave uncertain is mended.
    #[inline]
    fn see_decided(&self, ray: &Ray<f64>, spent: &mut Spent) -> Seen {
        let (search, mut tally) = (self.how.wide, Tally::default());
        let Found { part, t } = self
            .all
            .first::<Exact>(search, ray, self.min_t, &mut tally)?;
        match self.is_good(part, ray, t, Rounding::F64, true) {
            true => Some(self.asked(part, t, || on(part, ray, t))),
            false => self.see_exactly(ray, spent),
        }
    }

    #[cold]
    #[inline(never)]
    fn see_exactly(&self, ray: &Ray<f64>, spent: &mut Spent) -> Seen {
        spent.again_exactly += 1;
        let (search, mut tally) = (self.how.wide, Tally::default());
        let part = self
            .all
            .first::<Exact>(search, ray, self.min_t, &mut tally)?
            .part;
        let t = exact(&part.shape, ray, self.min_t)?.rounded();
        Some(self.asked(part, t, || exact_normal(&part.shape, ray, t)))
    }

    /// Whether what is asked for is as near the truth as is wished.
    #[inline]
    fn is_good(
        &self,
        part: &Part,
        ray: &Ray<f64>,
        t: f64,
        rounding: Rounding,
        is_decided: bool,
    ) -> bool {
        let (numbers, is_watched) = self.how.numbers[Kind::of(&part.shape) as usize];
        numbers != Numbers::Exact
            && (!is_watched || {
                let bound = watch::bound(&part.shape, ray, (t, self.min_t), rounding, is_decided);
                self.how.wish.is_met(bound)
            })
    }

    #[inline]
    fn asked(
        &self,
        part: &Part,
        t: f64,
        normal: impl FnOnce() -> Vector<f64>,
    ) -> (u32, f64, Vector<f64>) {
        let wish = &self.how.wish;
        let normal = match wish.normal {
            true => normal(),
            false => Vector::new(0.0, 0.0, 0.0),
        };
        (part.object, if wish.depth { t } else { 0.0 }, normal)
    }

    /// What is seen along many rays, by all of the machine's cores.
    pub fn film(&self, rays: &[Ray<f64>]) -> (Vec<Seen>, Spent) {
        let cast = |rays: &[Ray<f64>]| {
            let mut spent = Spent::default();
            let see = |ray| self.see(ray, &mut spent);
            (rays.iter().map(see).collect::<Vec<_>>(), spent)
        };
        let pieces: Vec<_> = rays.par_chunks(512).map(cast).collect();
        let spent = pieces
            .iter()
            .fold(Spent::default(), |sum, (_, spent)| sum.plus(*spent));
        let seen = pieces.into_iter().flat_map(|(seen, _)| seen).collect();
        (seen, spent)
    }
}

fn on(part: &Part, ray: &Ray<f64>, t: f64) -> Vector<f64> {
    part.shape.normal(ray.origin + ray.direction * t)
}

/// The normal where a ray is at a `t` that is rounded; nothing else is, but the result.
fn exact_normal(shape: &Primitive, ray: &Ray<f64>, t: f64) -> Vector<f64> {
    let along = match shape {
        Primitive::Plane(plane) => return plane.normal.unit(),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(DyadicVector::of);
            (&b - &a).cross(&(&c - &a))
        }
        Primitive::Sphere(sphere) => {
            let f = &DyadicVector::of(ray.origin) - &DyadicVector::of(sphere.center);
            let (t, d) = (Dyadic::of(t), DyadicVector::of(ray.direction));
            let at = f.0.iter().zip(&d.0).map(|(f, d)| f + &(&t * d));
            DyadicVector(at.collect::<Vec<_>>().try_into().expect("three of them"))
        }
    };
    // Over the largest, so that none is rounded to 0 or to infinity.
    let is_less = |p: &Dyadic, q: &Dyadic| (&(p * p) - &(q * q)).sign() < 0;
    let larger = |p, q| if is_less(&p, &q) { q } else { p };
    let largest = match along.0.clone().into_iter().reduce(larger) {
        Some(number) if number.sign() < 0 => -number,
        Some(number) if number.sign() > 0 => number,
        _ => Dyadic::of(1.0),
    };
    let [x, y, z] = along
        .0
        .map(|number| Root::fraction(number, largest.clone()).rounded());
    Vector::new(x, y, z).unit()
}
