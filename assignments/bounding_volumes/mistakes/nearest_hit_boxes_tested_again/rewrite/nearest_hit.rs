use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    let mut bound = f64::INFINITY;
    let mut stack = vec![0];
    while let Some(node) = stack.pop() {
        let Some(_) = tree.enter_box(node, min_t, bound) else {
            continue;
        };
        match tree.node(node) {
            Node::Branch(mut children) => {
                children.sort_by_cached_key(|&child| {
                    let entry = tree.enter_box(child, min_t, bound);
                    // The missed one, or else the farther one, goes first, to be taken last.
                    entry.map_or(i64::MIN, |t| -((t * 1e12) as i64))
                });
                stack.extend(children);
            }
            Node::Leaf(members) => {
                for &object in members {
                    let hit = tree.intersect_triangle(object, min_t);
                    if let Some(intersection) = hit.filter(|hit| hit.t < bound) {
                        bound = intersection.t;
                        best = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
        }
    }
    best
}
