//! Trees over the triangles of a mesh, and how one is searched.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::bounds::BoundingBox;
use crate::ray::Intersection;

// ANCHOR: tree
/// A binary tree over a list of triangles. It holds their places in the list, counted
/// from 0; the boxes of its nodes are computed from them.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    /// Some of the triangles, in any order.
    Leaf(Vec<usize>),
    /// Two smaller trees.
    Branch(Box<[Tree; 2]>),
}
// ANCHOR_END: tree

// ANCHOR: ray_tree
/// A tree as one ray sees it. Its tests are the only way to find out what the ray meets.
/// The harness counts them, because a search that needs fewer is faster.
pub trait RayTree {
    /// What is in a node. The root is node 0.
    fn node(&self, node: usize) -> Node<'_>;

    /// The t at which the ray enters a node's box, `min_t` if it starts inside, or `None`
    /// if it is not in the box at any t from `min_t` to `max_t`. Counts as one test.
    fn enter_box(&self, node: usize, min_t: f64, max_t: f64) -> Option<f64>;

    /// Where the ray meets a triangle, from `min_t` on. Counts as one test.
    fn intersect_triangle(&self, triangle: usize, min_t: f64) -> Option<Intersection>;
}

/// What is in a node of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node<'a> {
    /// Triangles, by their places in the mesh's list.
    Leaf(&'a [usize]),
    /// Two nodes, each with a box of its own.
    Branch([usize; 2]),
}
// ANCHOR_END: ray_tree

/// A tree in a list. Each branch precedes its children, and its first child comes directly after
/// it. The root is node 0.
///
/// ```
/// use pinhole::tree::{FlatNode, FlatTree, Tree};
///
/// let leaves = [Tree::Leaf(vec![0, 2]), Tree::Leaf(vec![1])];
/// let flat = FlatTree::from(Tree::Branch(Box::new(leaves)));
/// assert_eq!(flat.0[0], FlatNode::Branch([1, 2]));
/// assert_eq!(flat.0[2], FlatNode::Leaf(vec![1]));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlatTree(pub Vec<FlatNode>);

/// A node of a [`FlatTree`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FlatNode {
    /// Triangles, by their places in the list.
    Leaf(Vec<usize>),
    /// The nodes of its two children.
    Branch([usize; 2]),
}

impl From<Tree> for FlatTree {
    fn from(tree: Tree) -> FlatTree {
        let mut nodes = Vec::new();
        // Trees still to be placed, each with the branch whose second child it is.
        let mut waiting = vec![(tree, None)];
        while let Some((tree, parent)) = waiting.pop() {
            let index = nodes.len();
            if let Some(parent) = parent
                && let FlatNode::Branch(children) = &mut nodes[parent]
            {
                let children: &mut [usize; 2] = children;
                children[1] = index;
            }
            match tree {
                Tree::Leaf(triangles) => nodes.push(FlatNode::Leaf(triangles)),
                Tree::Branch(children) => {
                    let [first, second] = *children;
                    nodes.push(FlatNode::Branch([index + 1, 0]));
                    waiting.push((second, Some(index)));
                    waiting.push((first, None));
                }
            }
        }
        FlatTree(nodes)
    }
}

impl FlatTree {
    /// The tree whose leaves, from the first to the last, have these depths and members; `None`
    /// if there is none. The depths alone determine the branches.
    pub(crate) fn of_leaves(leaves: Vec<(usize, Vec<usize>)>) -> Option<FlatTree> {
        // Trees in their order, each with its depth. Two neighbours of equal depth are children of
        // one branch.
        let mut whole: Vec<(usize, Tree)> = Vec::new();
        for (depth, members) in leaves {
            whole.push((depth, Tree::Leaf(members)));
            while let [.., (first, _), (second, _)] = whole[..]
                && first == second
            {
                let children = [whole.swap_remove(whole.len() - 2).1, whole.pop()?.1];
                whole.push((first.checked_sub(1)?, Tree::Branch(Box::new(children))));
            }
        }
        match whole.pop() {
            Some((0, tree)) if whole.is_empty() => Some(tree.into()),
            _ => None,
        }
    }

    /// One of the nodes.
    ///
    /// # Panics
    /// If there is no such node.
    pub fn node(&self, index: usize) -> Node<'_> {
        match &self.0[index] {
            FlatNode::Leaf(triangles) => Node::Leaf(triangles),
            FlatNode::Branch(children) => Node::Branch(*children),
        }
    }

    /// The box of each node. `leaf` gives the box around some triangles, and `join` the box around
    /// two boxes.
    pub fn boxes(
        &self,
        leaf: impl Fn(&[usize]) -> BoundingBox,
        join: impl Fn(&BoundingBox, &BoundingBox) -> BoundingBox,
    ) -> Vec<BoundingBox> {
        let mut boxes = vec![around([]); self.0.len()];
        // Children come after their parents.
        for index in (0..self.0.len()).rev() {
            boxes[index] = match self.node(index) {
                Node::Leaf(triangles) => leaf(triangles),
                Node::Branch([a, b]) => join(&boxes[a], &boxes[b]),
            };
        }
        boxes
    }

    /// The number of nodes and of places in leaves, added up.
    pub(crate) fn size(&self) -> usize {
        let members = |node: &FlatNode| match node {
            FlatNode::Leaf(members) => members.len(),
            FlatNode::Branch(_) => 0,
        };
        self.0.len() + self.0.iter().map(members).sum::<usize>()
    }

    /// Whether it is a list as described: the root first, each node in one place of the
    /// tree, children after their parents.
    pub(crate) fn is_tree(&self) -> bool {
        let mut parents = vec![0; self.0.len()];
        for (index, node) in self.0.iter().enumerate() {
            if let FlatNode::Branch(children) = node {
                for &child in children {
                    match parents.get_mut(child) {
                        Some(count) if child > index => *count += 1,
                        _ => return false,
                    }
                }
            }
        }
        parents.first() == Some(&0) && parents[1..].iter().all(|&count| count == 1)
    }

    /// How many branches are above each node.
    fn depths(&self) -> Vec<usize> {
        let mut depths = vec![0; self.0.len()];
        for (index, node) in self.0.iter().enumerate() {
            if let FlatNode::Branch(children) = node {
                for &child in children {
                    depths[child] = depths[index] + 1;
                }
            }
        }
        depths
    }

    /// The boxes of its upper nodes, as a tree over triangles with these boxes. There are at most
    /// 15, however large the tree is. A node without any of the triangles has no box.
    pub(crate) fn outline(&self, triangles: &[BoundingBox]) -> Vec<NodeBox> {
        let leaf = |members: &[usize]| {
            let members = members.iter();
            around(members.filter_map(|&index| triangles.get(index).copied()))
        };
        let boxes = self.boxes(leaf, |a, b| around([*a, *b]));
        let nodes = self.depths().into_iter().zip(boxes);
        let is_drawn = |(depth, bounds): &(usize, BoundingBox)| {
            *depth <= DEEPEST_DRAWN && bounds.min.x <= bounds.max.x
        };
        let drawn = nodes.filter(is_drawn);
        drawn
            .map(|(depth, bounds)| NodeBox { depth, bounds })
            .collect()
    }

    /// Its measures, as a tree over triangles with these boxes.
    pub(crate) fn measure(&self, triangles: &[BoundingBox]) -> TreeMeasures {
        let mut seen = vec![0_usize; triangles.len()];
        let mut foreign = 0;
        let mut largest_leaf = 0;
        for node in &self.0 {
            if let FlatNode::Leaf(members) = node {
                largest_leaf = largest_leaf.max(members.len());
                for &triangle in members {
                    match seen.get_mut(triangle) {
                        Some(count) => *count += 1,
                        None => foreign += 1,
                    }
                }
            }
        }
        let misplaced = seen.iter().filter(|&&count| count != 1).count() + foreign;
        TreeMeasures {
            misplaced,
            depth: self.depths().into_iter().max().unwrap_or(0),
            largest_leaf,
            cost: match misplaced {
                0 => self.cost(triangles),
                _ => 0.0,
            },
        }
    }

    /// How many tests a ray that meets the root's box is expected to need if no hit ends its search
    /// early, by the surface area heuristic (Goldsmith and Salmon 1987; MacDonald and Booth 1990):
    /// a ray that meets a box also meets a box inside it with a probability equal to the ratio of
    /// their surface areas. A box's test counts as much as a triangle's.
    fn cost(&self, triangles: &[BoundingBox]) -> f64 {
        let leaf = |members: &[usize]| around(members.iter().map(|&index| triangles[index]));
        let boxes = self.boxes(leaf, |a, b| around([*a, *b]));
        let whole = boxes[0].half_area();
        let tests = |index: usize| match self.node(index) {
            Node::Leaf([]) => 0.0,
            Node::Leaf(members) => boxes[index].half_area() * members.len() as f64,
            Node::Branch(_) => boxes[index].half_area() * 2.0,
        };
        let sum: f64 = (0..self.0.len()).map(tests).sum();
        match whole > 0.0 {
            true => sum / whole,
            false => 0.0,
        }
    }
}

/// How a branch divides its triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Cut {
    /// At the middle of the axis along which the centres spread most, or all centres coincide.
    Middle,
    /// Elsewhere on that axis.
    OffMiddle,
    /// On another axis.
    OtherAxis,
    /// On no axis, because on every axis, the centres of the two children are mixed.
    Mixed,
}

/// Centres that are closer to each other than this share of their coordinates may coincide.
const ROUNDED: f64 = 1e-6;

impl FlatTree {
    /// How each branch divides its triangles, as a tree over triangles with these boxes. A branch
    /// with an empty child divides nothing.
    pub(crate) fn cuts(&self, triangles: &[BoundingBox]) -> Vec<Cut> {
        let mut centers: Vec<Vec<DVec3>> = vec![Vec::new(); self.0.len()];
        let mut cuts = Vec::new();
        // Children come after their parents.
        for index in (0..self.0.len()).rev() {
            centers[index] = match self.node(index) {
                Node::Leaf(members) => {
                    let known = members.iter().filter_map(|&member| triangles.get(member));
                    known.map(BoundingBox::center).collect()
                }
                Node::Branch([a, b]) => {
                    let [a, b] = [a, b].map(|child| std::mem::take(&mut centers[child]));
                    if !a.is_empty() && !b.is_empty() {
                        cuts.push(cut(&a, &b));
                    }
                    [a, b].concat()
                }
            };
        }
        cuts
    }
}

/// How these centres are divided.
fn cut(a: &[DVec3], b: &[DVec3]) -> Cut {
    let bounds = |centers: &[DVec3]| {
        let low = centers.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = centers
            .iter()
            .copied()
            .fold(DVec3::NEG_INFINITY, DVec3::max);
        (low, high)
    };
    let [(a_low, a_high), (b_low, b_high)] = [bounds(a), bounds(b)];
    let (low, high) = (a_low.min(b_low), a_high.max(b_high));
    let spread = high - low;
    let slack = ROUNDED * low.abs().max(high.abs()).max_element();
    let widest = spread.max_element();
    if widest <= slack {
        return Cut::Middle;
    }
    let gap = |axis: usize| f64::max(b_low[axis] - a_high[axis], a_low[axis] - b_high[axis]);
    let is_middle = |axis: usize| {
        let middle = (low[axis] + high[axis]) / 2.0;
        let is_below = |high: f64| high <= middle + slack;
        let is_above = |low: f64| low >= middle - slack;
        is_below(a_high[axis]) && is_above(b_low[axis])
            || is_below(b_high[axis]) && is_above(a_low[axis])
    };
    let (wide, narrow): (Vec<usize>, Vec<usize>) =
        (0..3).partition(|&axis| spread[axis] >= widest - slack);
    if wide.iter().any(|&axis| is_middle(axis)) {
        Cut::Middle
    } else if wide.iter().any(|&axis| gap(axis) >= -slack) {
        Cut::OffMiddle
    } else if narrow.iter().any(|&axis| gap(axis) > slack) {
        Cut::OtherAxis
    } else {
        Cut::Mixed
    }
}

/// The smallest box around these boxes. Around none, its corners are infinite.
fn around(boxes: impl IntoIterator<Item = BoundingBox> + Clone) -> BoundingBox {
    let corners = |corner: fn(BoundingBox) -> DVec3| boxes.clone().into_iter().map(corner);
    BoundingBox {
        min: corners(|it| it.min).fold(DVec3::INFINITY, DVec3::min),
        max: corners(|it| it.max).fold(DVec3::NEG_INFINITY, DVec3::max),
    }
}

/// The depth of the deepest nodes of an outline.
pub const DEEPEST_DRAWN: usize = 3;

/// The box of a node, for pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeBox {
    /// How many branches are above the node.
    pub depth: usize,
    /// The smallest box around its triangles.
    pub bounds: BoundingBox,
}

/// The measures by which a tree is judged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TreeMeasures {
    /// How many triangles are not in exactly one leaf, plus how many places in leaves name no
    /// triangle.
    pub misplaced: usize,
    /// How many branches are on the way from the root to the deepest leaf.
    pub depth: usize,
    /// How many triangles the largest leaf has.
    pub largest_leaf: usize,
    /// How many tests a ray that meets the root's box needs, as expected from the surface areas of
    /// the boxes; 0 if a triangle is misplaced.
    pub cost: f64,
}

#[cfg(test)]
mod tests;
