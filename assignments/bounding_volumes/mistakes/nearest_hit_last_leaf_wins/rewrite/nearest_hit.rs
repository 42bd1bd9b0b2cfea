use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut best = None;
    visit(tree, 0, entry, min_t, &mut best);
    best
}

fn visit(tree: &dyn RayTree, node: usize, entry: f64, min_t: f64, best: &mut Option<Hit>) {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            if let Some(hit) = nearest_of(tree, members, min_t) {
                *best = Some(hit);
            }
        }
        Node::Branch([a, b]) => {
            let enter = |child| tree.enter_box(child, min_t, bound).map(|t| (t, child));
            let (first, second) = (enter(a), enter(b));
            let is_first = matches!((first, second), (Some(x), Some(y)) if x.0 < y.0);
            let order = match is_first {
                true => [first, second],
                false => [second, first],
            };
            for (t, child) in order.into_iter().flatten() {
                visit(tree, child, t, min_t, best);
            }
        }
    }
}

/// The nearest hit with the triangles of a leaf.
fn nearest_of(tree: &dyn RayTree, members: &[usize], min_t: f64) -> Option<Hit> {
    let hits = members.iter().filter_map(|&object| {
        let intersection = tree.intersect_triangle(object, min_t)?;
        Some(Hit {
            object,
            intersection,
        })
    });
    hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}
