//! A bounding volume hierarchy over the parts, so that a ray is tested against few of them.
//!
//! obvhs builds the tree (Meister & Bittner's PLOC, then reinsertion), with two boxes per node.
//! Here, nodes are collapsed to eight boxes (a BVH8). The search loses no hit:
//!
//! 1. A box encloses its parts with a margin: see [`Frame::boxed`].
//! 2. The slab test never rejects a box that contains a hit that could be the first: see
//!    [`super::slabs`].
//! 3. Parts without a finite box, such as planes, are always tested. A ray that starts too far
//!    away for the slab test is tested against every part.

use std::time::Duration;

use arrayvec::ArrayVec;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use wide::f32x8;

use super::Nearest;
use super::model::Model;
use super::slabs::{Boxes, Frame, Slabs};
use super::world::{Part, Primitive, World};
use crate::kernel::ScaledQuery;
use crate::random::Random;
use crate::vector::{Vector, around};

/// A node of the BVH8: eight boxes and their contents.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Node {
    boxes: Boxes,
    /// For each box, the index of another node; or [`LEAF`], [`COUNT`] times the number of parts
    /// after the first, and the index of the first part.
    inside: [u32; 8],
}

const LEAF: u32 = 1 << 31;
const COUNT: u32 = 1 << 29;

/// A tree over the parts of a world. The default has no node.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    frame: Frame,
    /// Whether the frame's centre is the eye, from which all rays start.
    is_around_eye: bool,
    /// The first is the root. There are none if all parts with a box fit into a leaf.
    nodes: Vec<Node>,
    /// Parts from this index on are in no box.
    boundless: usize,
}

/// Parts with larger coordinates are in no box: differences of these might overflow.
const LARGE: f64 = 1e300;

/// The corners of a part's box; `None` if it is unbounded or a coordinate reaches `LARGE`.
fn bounds(part: &Part) -> Option<[Vector<f64>; 2]> {
    let bounds = part.shape.bounds()?;
    let is_small = |corner: &Vector<f64>| corner.array().into_iter().all(|x| x.abs() < LARGE);
    bounds.iter().all(is_small).then_some(bounds)
}

/// Whether the eye is so near to a scene's box that `f32` numbers tell the scene's parts apart in a
/// frame around the eye.
fn is_near(eye: &Vector<f64>, [low, high]: [Vector<f64>; 2]) -> bool {
    let away = (high - *eye).largest().max((low - *eye).largest());
    away <= 256.0 * (high - low).largest()
}

/// The binary tree over these boxes.
///
/// Where boxes are equal, equally far apart, or one within the other, obvhs might merge only one pair
/// at a time, which takes quadratic time. So it first gets them in random order, and larger by up to
/// 1 % and eight units in the last place.
fn binary_tree(boxes: &[Aabb]) -> Bvh2 {
    let mut random = Random::new(1, "boxes");
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    for at in (1..order.len()).rev() {
        order.swap(at, random.below(at + 1));
    }
    let unequal = order.iter().map(|part| {
        let bounds = &boxes[*part as usize];
        let more = random.within(0.0, 0.01) as f32;
        let extent = (bounds.max - bounds.min).to_array();
        let [mut low, mut high] = [bounds.min, bounds.max].map(|corner| corner.to_array());
        for axis in 0..3 {
            // The areas of the boxes must not underflow.
            let size = low[axis].abs().max(high[axis].abs()).max(1e-10);
            let margin = more * (extent[axis] + 800.0 * f32::EPSILON * size);
            (low[axis], high[axis]) = (low[axis] - margin, high[axis] + margin);
        }
        Aabb::new(low.into(), high.into())
    });
    let one_each = BvhBuildParams {
        max_prims_per_leaf: 1,
        ..BvhBuildParams::fast_build()
    };
    let unequal: Vec<_> = unequal.collect();
    let mut twos = build_bvh2(&unequal, one_each, &mut Duration::default());
    for part in &mut twos.primitive_indices {
        *part = order[*part as usize];
    }
    for node in twos.nodes.iter_mut().filter(|node| node.is_leaf()) {
        let part = twos.primitive_indices[node.first_index as usize];
        node.set_aabb(boxes[part as usize]);
    }
    // This is the capacity of a stack, and obvhs may have made the tree deeper.
    twos.max_depth = twos.nodes.len();
    twos.refit_all();
    twos
}

impl Tree {
    /// Builds the tree, and reorders the world's parts to match it.
    pub fn over(world: &mut World) -> Tree {
        // Most of the time here goes into memory for parts, so copy them only once.
        let mut inside = std::mem::take(&mut world.parts);
        world.parts.reserve_exact(inside.len());
        let mut boxes = Vec::with_capacity(inside.len());
        let is_boundless = |part: &mut Part| {
            boxes.extend(bounds(part));
            bounds(part).is_none()
        };
        let outside: Vec<Part> = inside.extract_if(.., is_boundless).collect();
        let mut tree = Tree::default();
        if let Some(all) = around(boxes.iter().copied()) {
            let eye = world.camera.and_then(|camera| camera.eye());
            let eye = eye.filter(|eye| is_near(eye, all));
            tree.frame = Frame::around(all, eye);
            tree.is_around_eye = eye.is_some();
            let boxes = boxes.into_iter().map(|bounds| {
                let [low, high] = tree.frame.boxed(bounds);
                Aabb::new(low.into(), high.into())
            });
            let twos = binary_tree(&boxes.collect::<Vec<_>>());
            let mut wide = WideTreeBuilder {
                twos,
                parts: &inside,
                ordered: &mut world.parts,
                tree: &mut tree,
            };
            wide.build();
        }
        tree.boundless = world.parts.len();
        world.parts.extend(outside);
        tree
    }

    /// Tests all parts that a ray may hit first.
    #[inline(always)]
    pub(super) fn search<'a, M: Model>(&self, world: &'a World, nearest: &mut Nearest<'a, '_, M>) {
        if self.nodes.is_empty() {
            return nearest.consider_all(&world.parts);
        }
        let ScaledQuery { scaled, .. } = &nearest.query.scaled;
        let min_t = nearest.query.min_t;
        if M::HAS_EYE && self.is_around_eye {
            let slabs = Slabs::from_center(&self.frame, scaled, min_t);
            return self.traverse::<M, true>(&slabs, world, nearest);
        }
        match Slabs::of(&self.frame, scaled, min_t) {
            Some(slabs) => self.traverse::<M, false>(&slabs, world, nearest),
            None => nearest.consider_all(&world.parts),
        }
    }

    /// Tests the parts in all boxes that a ray enters before its first hit.
    #[inline(always)]
    fn traverse<'a, M: Model, const FROM_CENTER: bool>(
        &self,
        slabs: &Slabs,
        world: &'a World,
        nearest: &mut Nearest<'a, '_, M>,
    ) {
        nearest.consider_all(&world.parts[self.boundless..]);
        let mut horizon = slabs.horizon(nearest.horizon());
        let mut waiting = TraversalStack::default();
        let mut at = 0;
        loop {
            if at & LEAF == 0 {
                let node = &self.nodes[at as usize];
                let (mut met, entries) = slabs.enter::<FROM_CENTER>(&node.boxes, horizon);
                if met != 0 {
                    let take = |met: &mut u32| {
                        let lane = met.trailing_zeros() as usize & 7;
                        *met &= *met - 1;
                        TraversalStack::stack_entry(entries[lane], node.inside[lane])
                    };
                    let before = waiting.stack_entries.len();
                    let mut near = take(&mut met);
                    while met != 0 {
                        let other = take(&mut met);
                        waiting.add(near.max(other));
                        near = near.min(other);
                    }
                    waiting.order_from(before);
                    at = near as u32;
                    continue;
                }
            } else {
                nearest.consider_all(inside(at, world));
                horizon = slabs.horizon(nearest.horizon());
            }
            match waiting.next(horizon) {
                None => return,
                Some(next) => at = next,
            }
        }
    }
}

/// The parts of a leaf.
#[inline(always)]
fn inside(leaf: u32, world: &World) -> &[Part] {
    let first = (leaf & (COUNT - 1)) as usize;
    let after = (leaf & !LEAF) / COUNT;
    &world.parts[first..=first + after as usize]
}

/// Stack of nodes still to visit. Each entry packs the ray's entry t (upper 32 bits) and the
/// node (lower 32 bits). The bits of non-negative floats sort like the floats, so comparing
/// entries compares t.
#[derive(Default)]
struct TraversalStack {
    stack_entries: ArrayVec<u64, 128>,
    /// Overflow of the fixed array, for trees that are deeper than any seen.
    more: Vec<u64>,
}

impl TraversalStack {
    #[inline(always)]
    fn stack_entry(entry: f32, inside: u32) -> u64 {
        // `f32::max` might give −0, whose bits sort after all others.
        let entry = if entry > 0.0 { entry } else { 0.0 };
        u64::from(entry.to_bits()) << 32 | u64::from(inside)
    }

    #[inline(always)]
    fn add(&mut self, stack_entry: u64) {
        if self.stack_entries.try_push(stack_entry).is_err() {
            self.more.push(stack_entry);
        }
    }

    /// Sorts the entries from `before` on, nearest last, so that the nearest is popped first.
    #[inline(always)]
    fn order_from(&mut self, before: usize) {
        for end in before + 1..self.stack_entries.len() {
            for at in (before..end).rev() {
                if self.stack_entries[at] < self.stack_entries[at + 1] {
                    self.stack_entries.swap(at, at + 1);
                }
            }
        }
    }

    /// Pops the next node that the ray enters before the horizon.
    #[inline(always)]
    fn next(&mut self, horizon: f32) -> Option<u32> {
        let beyond = TraversalStack::stack_entry(horizon, u32::MAX);
        loop {
            let stack_entry = match self.stack_entries.pop() {
                Some(stack_entry) => stack_entry,
                None => self.more.pop()?,
            };
            if stack_entry <= beyond {
                return Some(stack_entry as u32);
            }
        }
    }
}

/// Collapses the binary tree to nodes with eight boxes.
struct WideTreeBuilder<'a> {
    twos: Bvh2,
    parts: &'a [Part],
    ordered: &'a mut Vec<Part>,
    tree: &'a mut Tree,
}

impl<'a> WideTreeBuilder<'a> {
    fn build(&mut self) {
        if let Some(parts) = self.leaf_parts(0) {
            self.leaf(&parts);
            return;
        }
        let nowhere = [[f32x8::splat(f32::MAX); 3], [f32x8::splat(f32::MIN); 3]];
        let empty = Node {
            boxes: nowhere,
            inside: [0; 8],
        };
        let mut waiting = vec![(0, 0)];
        self.tree.nodes.push(empty);
        while let Some((node, two)) = waiting.pop() {
            for (lane, two) in self.children(two).into_iter().enumerate() {
                let bounds = self.twos.nodes[two].aabb();
                let sides = [bounds.min.to_array(), bounds.max.to_array()];
                let inside = match self.leaf_parts(two) {
                    Some(parts) => self.leaf(&parts),
                    None => {
                        self.tree.nodes.push(empty);
                        let new = self.tree.nodes.len() - 1;
                        waiting.push((new, two));
                        new as u32
                    }
                };
                let node = &mut self.tree.nodes[node];
                for (boxes, side) in node.boxes.iter_mut().zip(sides) {
                    for (lanes, number) in boxes.iter_mut().zip(side) {
                        lanes.as_mut_array()[lane] = number;
                    }
                }
                node.inside[lane] = inside;
            }
        }
    }

    /// The parts below a binary node, if they fit into a leaf: one part, or up to four triangles.
    fn leaf_parts(&self, two: usize) -> Option<ArrayVec<&'a Part, 4>> {
        let (mut waiting, mut parts) = (ArrayVec::<usize, 5>::new(), ArrayVec::new());
        waiting.push(two);
        while let Some(two) = waiting.pop() {
            let (node, at) = (
                &self.twos.nodes[two],
                self.twos.nodes[two].first_index as usize,
            );
            match node.prim_count {
                0 => waiting.extend([at, at + 1]),
                _ => parts.push(&self.parts[self.twos.primitive_indices[at] as usize]),
            }
            if waiting.len() + parts.len() > parts.capacity() {
                return None;
            }
        }
        let is_triangle = |part: &&Part| matches!(part.shape, Primitive::Triangle(_));
        (parts.len() == 1 || parts.iter().all(is_triangle)).then_some(parts)
    }

    /// The two to eight children of a wide node: keeps opening the child with the largest area.
    fn children(&self, two: usize) -> Vec<usize> {
        let mut children = vec![two];
        while children.len() < 8 {
            let area = |two: &usize| self.twos.nodes[*two].aabb().half_area();
            let open = (0..children.len()).filter(|at| self.leaf_parts(children[*at]).is_none());
            let widest = open.max_by(|p, q| area(&children[*p]).total_cmp(&area(&children[*q])));
            let Some(widest) = widest else { break };
            let opened = children.remove(widest);
            let first = self.twos.nodes[opened].first_index as usize;
            children.extend([first, first + 1]);
        }
        children
    }

    fn leaf(&mut self, parts: &[&Part]) -> u32 {
        let first = self.ordered.len() as u32;
        self.ordered.extend(parts.iter().copied());
        let after = parts.len() as u32 - 1;
        LEAF | (after * COUNT) | first
    }
}
