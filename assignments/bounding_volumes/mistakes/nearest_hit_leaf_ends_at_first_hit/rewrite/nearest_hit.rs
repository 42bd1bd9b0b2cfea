use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, (0, entry), min_t, None)
}

fn search(
    tree: &dyn RayTree,
    (node, entry): (usize, f64),
    min_t: f64,
    best: Option<Hit>,
) -> Option<Hit> {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return best;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let found = members.iter().find_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            found.filter(|hit| hit.intersection.t < bound).or(best)
        }
        Node::Branch([a, b]) => {
            let first = tree.enter_box(a, min_t, bound).map(|t| (a, t));
            let second = tree.enter_box(b, min_t, bound).map(|t| (b, t));
            let mut order = [second, first];
            if let (Some(x), Some(y)) = (first, second)
                && x.1 < y.1
            {
                order = [first, second];
            }
            let order = order.into_iter().flatten();
            order.fold(best, |best, child| search(tree, child, min_t, best))
        }
    }
}
