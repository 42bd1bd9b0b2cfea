use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, 0.0, f64::INFINITY)?;
    let hit = search(tree, (0, entry), None)?;
    if hit.intersection.t < min_t {
        None
    } else {
        Some(hit)
    }
}

/// The nearest of a hit and those in a node.
fn search(tree: &dyn RayTree, (node, entry): (usize, f64), best: Option<Hit>) -> Option<Hit> {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return best;
    }
    match tree.node(node) {
        Node::Branch([a, b]) => {
            let first = tree.enter_box(a, 0.0, bound).map(|t| (a, t));
            let second = tree.enter_box(b, 0.0, bound).map(|t| (b, t));
            let order = match (first, second) {
                (Some(x), Some(y)) if x.1 < y.1 => [first, second],
                _ => [second, first],
            };
            let entered = order.into_iter().flatten();
            entered.fold(best, |best, child| search(tree, child, best))
        }
        Node::Leaf(members) => {
            let hits = members.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, 0.0)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            let all = best.into_iter().chain(hits);
            all.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
        }
    }
}
