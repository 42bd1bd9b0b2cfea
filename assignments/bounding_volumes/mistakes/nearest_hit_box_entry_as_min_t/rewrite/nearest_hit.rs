use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut best = None;
    visit(tree, 0, entry, &mut best);
    best
}

fn visit(tree: &dyn RayTree, node: usize, entry: f64, best: &mut Option<Hit>) {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let hits = members.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, entry)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            let hit = hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
            *best = hit.filter(|hit| hit.intersection.t < bound).or(*best);
        }
        Node::Branch([a, b]) => {
            let first = tree.enter_box(a, entry, bound).map(|t| (a, t));
            let second = tree.enter_box(b, entry, bound).map(|t| (b, t));
            let order = match (first, second) {
                (Some(x), Some(y)) if x.1 < y.1 => [first, second],
                _ => [second, first],
            };
            for (child, t) in order.into_iter().flatten() {
                visit(tree, child, t, best);
            }
        }
    }
}
