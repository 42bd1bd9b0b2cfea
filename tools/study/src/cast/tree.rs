//! Boxes within boxes, so that a ray is tested against few parts.
//!
//! obvhs builds the tree (Meister & Bittner's PLOC, then reinsertion): of the crates that
//! are kept up it builds best, and gives its nodes away. Its own search is in `f32` and
//! promises nothing; ours loses no hit:
//!
//! 1. A box holds its parts with room to spare: each of its numbers is rounded to `f32`
//!    and then moved outwards to the next.
//! 2. Where a ray crosses a side is off by 3u of itself at most (a difference, a
//!    reciprocal and a product; Ize, "Robust BVH Ray Traversal", *JCGT* 2(2), 2013, §3).
//!    So a ray that enters at most 8u of its way after it leaves still counts as inside.
//! 3. A direction whose component is 0, or as good as that, crosses no side: its
//!    reciprocal is replaced by the largest number. That sends both sides beyond any t in
//!    opposite directions if the ray runs between them. It cannot run *in* a side, for
//!    the spare room is larger than nothing.
//! 4. Parts without a finite box, planes above all, are tested always.

use std::time::Duration;

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;
use smallvec::SmallVec;

use super::Nearest;
use super::model::Model;
use super::world::{Part, Primitive, World};
use crate::kernel::sphere::Scaled;
use crate::shape::Ray;
use crate::vector::Vector;

/// A box, and what is in it: two boxes, or some parts.
#[derive(Clone, Copy, Debug)]
struct Node {
    low: [f32; 3],
    high: [f32; 3],
    /// The first of two nodes, or of `count` parts.
    first: u32,
    /// 0 for boxes.
    count: u32,
}

/// A tree over the parts of a world.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The root first; none if no part has a finite box.
    nodes: Vec<Node>,
    /// Parts from here on are in no box.
    boundless: usize,
}

impl Tree {
    /// Builds it, and puts the world's parts in its order.
    pub fn over(world: &mut World) -> Tree {
        let parts = std::mem::take(&mut world.parts);
        let boxed = |part: &Part| bounds(&part.shape).is_some();
        let (inside, outside): (Vec<_>, Vec<_>) = parts.into_iter().partition(boxed);
        let boxes = inside.iter().filter_map(|part| bounds(&part.shape));
        let built = match inside.is_empty() {
            true => Bvh2::default(),
            false => build_bvh2(
                &boxes.collect::<Vec<_>>(),
                BvhBuildParams::medium_build(),
                &mut Duration::default(),
            ),
        };
        let node = |node: &Bvh2Node| Node {
            low: node.aabb().min.to_array(),
            high: node.aabb().max.to_array(),
            first: node.first_index,
            count: node.prim_count,
        };
        let ordered = built
            .primitive_indices
            .iter()
            .map(|at| inside[*at as usize]);
        world.parts.extend(ordered);
        world.parts.extend(outside);
        Tree {
            nodes: built.nodes.iter().map(node).collect(),
            boundless: inside.len(),
        }
    }

    /// Considers all parts that a ray may meet first.
    #[inline(always)]
    pub(super) fn search<'a, M: Model>(&self, world: &'a World, nearest: &mut Nearest<'a, '_, M>) {
        nearest.consider(&world.parts[self.boundless..]);
        let slabs = Slabs::of(nearest.ray, nearest.min_t);
        let horizon = |nearest: &Nearest<M>| slabs.scaled.scale(nearest.horizon()).min(f64::MAX);
        let mut beyond = horizon(nearest);
        let enters = |at: u32, beyond| slabs.enters(&self.nodes[at as usize], beyond);
        if self.nodes.is_empty() || enters(0, beyond) > beyond {
            return;
        }
        let mut waiting: SmallVec<[(u32, f64); 64]> = SmallVec::new();
        let mut at = 0;
        loop {
            let node = &self.nodes[at as usize];
            let first = node.first as usize;
            if node.count > 0 {
                nearest.consider(&world.parts[first..first + node.count as usize]);
                beyond = horizon(nearest);
            } else {
                let one = (node.first, enters(node.first, beyond));
                let other = (node.first + 1, enters(node.first + 1, beyond));
                let is_other_far = one.1 <= other.1;
                let (near, far) = if is_other_far {
                    (one, other)
                } else {
                    (other, one)
                };
                if far.1 <= beyond {
                    waiting.push(far);
                }
                if near.1 <= beyond {
                    at = near.0;
                    continue;
                }
            }
            at = loop {
                match waiting.pop() {
                    None => return,
                    Some((next, entry)) if entry <= beyond => break next,
                    Some(_) => (),
                }
            };
        }
    }
}

/// A box with room to spare, where that is finite.
fn bounds(shape: &Primitive) -> Option<Aabb> {
    let [low, high] = shape.bounds()?;
    let low = low.map(|x| (x as f32).next_down()).array();
    let high = high.map(|x| (x as f32).next_up()).array();
    let is_finite = low.iter().chain(&high).all(|x| x.abs() < f32::MAX);
    is_finite.then(|| Aabb::new(low.into(), high.into()))
}

/// What is needed of a ray to say which boxes it meets: see the head of this file.
struct Slabs {
    scaled: Scaled<f64>,
    inverse: Vector<f64>,
    /// `min_t` as the scaled ray counts.
    from: f64,
}

/// 1 + 8u.
const ROOM: f64 = 1.0 + 4.0 * f64::EPSILON;
/// A smaller component of a direction crosses nothing within an `f32`'s range.
const PARALLEL: f64 = 1e-270;

impl Slabs {
    fn of(ray: &Ray<f64>, min_t: f64) -> Slabs {
        let scaled = Scaled::new(ray);
        let inverse = scaled.ray.direction.map(|d| match d.abs() < PARALLEL {
            true => f64::MAX,
            false => 1.0 / d,
        });
        let from = scaled.scale(min_t);
        Slabs {
            scaled,
            inverse,
            from,
        }
    }

    /// Where a ray enters a box, if that is not after it leaves it or after `beyond`;
    /// else infinitely far away.
    #[inline(always)]
    fn enters(&self, node: &Node, beyond: f64) -> f64 {
        let (origin, inverse) = (self.scaled.ray.origin.array(), self.inverse.array());
        let (mut near, mut far) = (self.from, beyond);
        for axis in 0..3 {
            let low = (f64::from(node.low[axis]) - origin[axis]) * inverse[axis];
            let high = (f64::from(node.high[axis]) - origin[axis]) * inverse[axis];
            let (enter, leave) = if low < high { (low, high) } else { (high, low) };
            let leave = leave * ROOM;
            near = if enter > near { enter } else { near };
            far = if leave < far { leave } else { far };
        }
        match near <= far {
            true => near,
            false => f64::INFINITY,
        }
    }
}
