//! All shapes of a kind in `f32`, and what a ray meets first among them.

use std::time::Duration;

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use smallvec::SmallVec;

use super::slabs::{Slabs, room};
use super::{Met, Near};
use crate::cast::eight::{EIGHT, Sifted};
use crate::cast::world::Primitive;
use crate::kernel::Kernel;
use crate::number::Real;
use crate::shape::{Ray, Shape};

/// All shapes of a kind.
pub struct Kind<S: Sifted> {
    /// In the order of the tree.
    shapes: Vec<S>,
    /// The same, eight in a row.
    rows: Vec<S::Rows>,
    /// Of each, [`Part::place`](crate::cast::world::Part::place).
    places: Vec<u32>,
    tree: Bvh2,
}

/// Fewer than this are sooner asked one by one than eight at a time.
const FEW: usize = 4;

impl<S: Sifted> Default for Kind<S> {
    fn default() -> Kind<S> {
        Kind {
            shapes: Vec::new(),
            rows: Vec::new(),
            places: Vec::new(),
            tree: Bvh2::default(),
        }
    }
}

impl<S: Sifted> Kind<S> {
    /// Of these places and shapes.
    pub fn new<W>(parts: &[(u32, W)], primitive: fn(W) -> Primitive) -> Kind<S>
    where
        W: Shape<With<f32> = S>,
    {
        let boxes: Option<Vec<Aabb>> = parts.iter().map(|part| room(primitive(part.1))).collect();
        let tree = match boxes {
            Some(boxes) if !boxes.is_empty() => {
                let medium = BvhBuildParams::medium_build();
                build_bvh2(&boxes, medium, &mut Duration::default())
            }
            _ => Bvh2::default(),
        };
        let as_given = 0..parts.len() as u32;
        let order = match tree.primitive_indices.is_empty() {
            true => as_given.collect(),
            false => tree.primitive_indices.clone(),
        };
        let ordered = || order.iter().map(|at| &parts[*at as usize]);
        let shapes: Vec<S> = ordered().map(|part| part.1.map(f32::of, f32::of)).collect();
        Kind {
            rows: shapes.chunks(EIGHT).map(S::rows).collect(),
            shapes,
            places: ordered().map(|part| part.0).collect(),
            tree,
        }
    }

    /// Where one is met, if that is before what was met so far.
    #[inline(always)]
    fn meet<'a, K: Kernel<S, f32>>(
        &'a self,
        at: usize,
        ray: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        let Some(t) = K::intersect(&self.shapes[at], ray, min_t) else {
            return;
        };
        let place = self.places[at];
        if near.is_none_or(|near| (t, place) < (near.t, near.place)) {
            let shape = met(&self.shapes[at]);
            *near = Some(Near { t, place, shape });
        }
    }

    /// What is first of all shapes: eight are sifted at a time, and what is left is asked.
    #[inline(always)]
    pub fn all<'a, K: Kernel<S, f32>>(
        &'a self,
        ray: &Ray<f32>,
        prepared: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        if self.shapes.len() < FEW {
            return (0..self.shapes.len()).for_each(|at| {
                self.meet::<K>(at, prepared, min_t, met, near);
            });
        }
        for (chunk, rows) in self.rows.iter().enumerate() {
            let mut passed = S::passed(rows, ray);
            while passed != 0 {
                let at = chunk * EIGHT + passed.trailing_zeros() as usize;
                passed &= passed - 1;
                if at < self.shapes.len() {
                    self.meet::<K>(at, prepared, min_t, met, near);
                }
            }
        }
    }

    /// The same by boxes, the nearer of two first.
    #[inline(always)]
    pub fn boxed<'a, K: Kernel<S, f32>>(
        &'a self,
        ray: &Ray<f32>,
        prepared: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        if self.shapes.len() <= EIGHT || self.tree.nodes.is_empty() {
            return self.all::<K>(ray, prepared, min_t, met, near);
        }
        let slabs = Slabs::of(ray, min_t);
        let nodes = &self.tree.nodes;
        let mut waiting: SmallVec<[(u32, f32); 64]> = SmallVec::new();
        let mut beyond = slabs.horizon(near);
        let mut next = (0, slabs.enters(nodes[0].aabb(), beyond));
        loop {
            let (at, entry) = next;
            let node = &nodes[at as usize];
            if entry <= beyond {
                let first = node.first_index;
                if node.prim_count == 0 {
                    let [one, other] = [first, first + 1]
                        .map(|at| (at, slabs.enters(nodes[at as usize].aabb(), beyond)));
                    let (nearer, further) = match one.1 <= other.1 {
                        true => (one, other),
                        false => (other, one),
                    };
                    if further.1 <= beyond {
                        waiting.push(further);
                    }
                    next = nearer;
                    continue;
                }
                for at in first..first + node.prim_count {
                    self.meet::<K>(at as usize, prepared, min_t, met, near);
                }
                beyond = slabs.horizon(near);
            }
            match waiting.pop() {
                None => return,
                Some(one) => next = one,
            }
        }
    }
}
