//! Casts whole scenes, with a choice of kernels.
//!
//! [`world`] is the scene as a list of parts, [`tree`] is a bounding volume hierarchy over them
//! ([`slabs`] tests its boxes), [`model`] chooses the kernels, [`bounds`] tells how accurate their
//! t must be, and [`refined`] computes it with more digits.

pub mod bounds;
pub mod model;
pub mod refined;
pub mod slabs;
pub mod tree;
pub mod world;

use std::marker::PhantomData;

use serde::Serialize;

use crate::kernel::Camera;
use crate::shape::Ray;
use model::{Exact, Model, Query};
use tree::Tree;
use world::{Accurate, Part, View, World};

/// Counters of the work that a cast did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// Tests of a ray against a part. Results contain the mean for one ray instead.
    #[serde(skip)]
    pub tests: u64,
    /// Tests that the static filter could not decide.
    pub semi_static: u64,
    /// Tests that were decided exactly, because the semi-static filter could not decide either.
    pub exact: u64,
    /// Comparisons of two t that were too close to decide in `f64`.
    pub close_calls: u64,
    /// Hits whose t and normal had to be computed exactly to reach the requested accuracy.
    pub exact_hits: u64,
}

impl Tally {
    /// The sum of two tallies.
    pub fn plus(self, other: Tally) -> Tally {
        Tally {
            tests: self.tests + other.tests,
            semi_static: self.semi_static + other.semi_static,
            exact: self.exact + other.exact,
            close_calls: self.close_calls + other.close_calls,
            exact_hits: self.exact_hits + other.exact_hits,
        }
    }
}

/// The part that a ray meets first, and where.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// The part that is hit first.
    pub part: &'a Part,
    /// The ray parameter of the hit, in multiples of the ray's direction.
    pub t: f64,
    /// Whether t is as accurate as its [`View`] requires.
    pub is_accurate: bool,
}

impl<'a> Found<'a> {
    /// A hit whose t is proven to [`PROVEN_T`](world::PROVEN_T).
    #[inline(always)]
    pub fn new(part: &'a Part, t: f64) -> Found<'a> {
        let is_accurate = part.accurate == Accurate::Always;
        Found {
            part,
            t,
            is_accurate,
        }
    }
}

/// A scene with its acceleration structure, if it has one.
pub struct Caster {
    /// The parts of the scene.
    pub world: World,
    tree: Tree,
}

impl Caster {
    /// Prepares the parts for exact casting of the view's rays, and builds the tree. Without a
    /// view, it casts only in plain `f64`. Without boxes, every part is tested.
    pub fn new(mut world: World, view: Option<View>, has_boxes: bool) -> Caster {
        if let Some(view) = view {
            world.settle(view);
        }
        let tree = match has_boxes {
            true => Tree::over(&mut world),
            false => Tree::default(),
        };
        Caster { world, tree }
    }

    /// The first hit with t ≥ `min_t`. `min_t` must not be negative.
    #[inline(always)]
    pub fn first<M: Model>(
        &self,
        ray: &Ray<f64>,
        min_t: f64,
        tally: &mut Tally,
    ) -> Option<Found<'_>> {
        let mut nearest = Nearest {
            query: Query::new::<M>(ray, min_t, &self.world),
            tally,
            found: None,
            model: PhantomData::<M>,
        };
        self.tree.search(&self.world, &mut nearest);
        nearest.found
    }
}

/// The place of the part that a single ray hits first, decided exactly, and its t. The ray's origin
/// is the eye of a camera.
pub fn first_hit(
    world: World,
    ray: &Ray<f64>,
    min_t: f64,
    tally: &mut Tally,
) -> Option<(u32, f64)> {
    let view = View {
        camera: Camera::Perspective { eye: ray.origin },
        accuracy: f64::INFINITY,
    };
    let caster = Caster::new(world, Some(view), true);
    let found = caster.first::<Exact<true>>(ray, min_t, tally)?;
    Some((found.part.place, found.t))
}

/// The state of the search for one ray's first hit.
pub struct Nearest<'a, 'r, M> {
    query: Query<'r>,
    tally: &'r mut Tally,
    found: Option<Found<'a>>,
    model: PhantomData<M>,
}

impl<'a, M: Model> Nearest<'a, '_, M> {
    /// Tests these parts, and keeps the nearest hit.
    #[inline(always)]
    fn consider_all(&mut self, parts: &'a [Part]) {
        self.tally.tests += parts.len() as u64;
        for part in parts {
            self.consider(part);
        }
    }

    /// Tests a part, and keeps the hit if it is nearer.
    #[inline(always)]
    fn consider(&mut self, part: &'a Part) {
        let Some(found) = M::meet(part, &self.query, self.tally) else {
            return;
        };
        let is_first = self
            .found
            .is_none_or(|best| M::comes_first(&found, &best, &self.query, self.tally));
        if is_first {
            self.found = Some(found);
        }
    }

    /// An upper limit on the t of the first hit: nothing beyond it can come first. The last
    /// term covers a subnormal t, which has an absolute instead of a relative error.
    #[inline(always)]
    fn horizon(&self) -> f64 {
        let beyond = |t: f64| t + t.abs() * M::SLACK + f64::MIN_POSITIVE;
        self.found.map_or(f64::INFINITY, |found| beyond(found.t))
    }
}
