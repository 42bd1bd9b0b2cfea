//! Casts whole scenes, with a choice of kernels.
//!
//! [`world`] is the scene as a list of parts, [`tree`] is a bounding volume hierarchy over them
//! ([`slabs`] tests its boxes), [`model`] chooses the kernels, [`bounds`] tells how
//! accurate their t must be, and [`rays`] says where rays come from.

pub mod bounds;
pub mod model;
pub mod rays;
pub mod slabs;
pub mod tree;
pub mod world;

use std::marker::PhantomData;

use wide::f32x4;

use crate::shape::Ray;
use crate::vector::Vector;
use model::{Model, Query};
use tree::{Leaf, Tree};
use world::{Accurate, Part, View, World};

/// Counters of the work that a cast did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Tests of a ray against a part.
    pub tests: u64,
    /// Tests that the static filter could not decide.
    pub semi_static: u64,
    /// Tests that the semi-static filter could not decide either.
    pub double_double: u64,
    /// Tests that were decided exactly.
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
            double_double: self.double_double + other.double_double,
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
    /// Computes the filters' limits for all parts, and builds the tree. Without boxes, every part
    /// is tested. With a view, it casts only the rays of one camera: see [`model::FromCamera`].
    pub fn new(mut world: World, view: Option<View>, has_boxes: bool) -> Caster {
        world.settle(view);
        let tree = match has_boxes {
            true => Tree::over(&mut world),
            false => Tree::default(),
        };
        Caster { world, tree }
    }

    /// The first hit with t ≥ `min_t`. `min_t` must not be negative.
    #[inline]
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
        match self.tree.root {
            Some(root) => self.tree.search(root, &self.world, &mut nearest),
            None => nearest.consider(&self.world.parts),
        }
        nearest.found
    }
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
    fn consider(&mut self, parts: &'a [Part]) {
        self.tally.tests += parts.len() as u64;
        for part in parts {
            if let Some(found) = M::meet(part, &self.query, self.tally) {
                self.keep(found);
            }
        }
    }

    /// Tests the triangles of a leaf, which are the first of these parts.
    #[inline(always)]
    fn consider_leaf(&mut self, leaf: &Leaf, parts: &'a [Part], packed: Vector<f32x4>) {
        self.tally.tests += u64::from(leaf.count);
        let met = M::meet_leaf(leaf, &self.query, packed);
        let (mut hits, mut open) = (met.hits, met.open);
        while hits != 0 {
            let lane = hits.trailing_zeros() as usize & 3;
            hits &= hits - 1;
            match met.t[lane].is_finite() {
                true => self.keep(Found::new(&parts[lane], met.t[lane])),
                false => open |= 1 << lane,
            }
        }
        match open != 0 && !M::HAS_CAMERA {
            true => self.consider_open(open, parts),
            false => self.consider_lanes(open, parts),
        }
    }

    #[cold]
    fn consider_open(&mut self, open: u32, parts: &'a [Part]) {
        self.consider_lanes(open, parts);
    }

    /// Tests those of these parts that have a bit in `lanes`.
    #[inline(always)]
    fn consider_lanes(&mut self, mut lanes: u32, parts: &'a [Part]) {
        while lanes != 0 {
            let part = &parts[lanes.trailing_zeros() as usize & 3];
            lanes &= lanes - 1;
            if let Some(found) = M::meet(part, &self.query, self.tally) {
                self.keep(found);
            }
        }
    }

    #[inline(always)]
    fn keep(&mut self, found: Found<'a>) {
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
