use std::cmp::Ordering;
use std::collections::BinaryHeap;

use pinhole::{Hit, Node, RayTree};

/// A node that waits, with the t at which the ray enters its box.
struct Waiting {
    t: f64,
    node: usize,
}

impl Ord for Waiting {
    /// The greatest is the one that is entered first.
    fn cmp(&self, other: &Waiting) -> Ordering {
        other.t.total_cmp(&self.t)
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Waiting) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Waiting) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    let mut max_t = f64::INFINITY;
    let mut heap = BinaryHeap::new();
    if let Some(t) = tree.enter_box(0, min_t, max_t) {
        heap.push(Waiting { t, node: 0 });
    }
    while let Some(Waiting { t, node }) = heap.pop() {
        if t > max_t {
            break;
        }
        match tree.node(node) {
            Node::Branch(children) => {
                for child in children {
                    if let Some(t) = tree.enter_box(child, min_t, max_t) {
                        heap.push(Waiting { t, node: child });
                    }
                }
            }
            Node::Leaf(triangles) => {
                for &object in triangles {
                    if let Some(intersection) = tree.intersect_triangle(object, min_t)
                        && intersection.t < max_t
                    {
                        max_t = intersection.t;
                        nearest = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
        }
    }
    nearest
}
