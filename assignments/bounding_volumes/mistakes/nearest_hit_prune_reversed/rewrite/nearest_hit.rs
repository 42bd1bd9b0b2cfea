use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut best = None;
    visit(tree, (0, entry), min_t, &mut best);
    best
}

fn visit(tree: &dyn RayTree, (node, entry): (usize, f64), min_t: f64, best: &mut Option<Hit>) {
    let is_hidden = match best {
        Some(hit) => entry < hit.intersection.t,
        None => false,
    };
    if is_hidden {
        return;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let hits = members.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            let all = (*best).into_iter().chain(hits);
            *best = all.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
        }
        Node::Branch([a, b]) => {
            let enter = |child| {
                let t = tree.enter_box(child, min_t, f64::INFINITY);
                t.map(|t| (child, t))
            };
            let (first, second) = (enter(a), enter(b));
            let order = match (first, second) {
                (Some(x), Some(y)) if x.1 < y.1 => [first, second],
                _ => [second, first],
            };
            for child in order.into_iter().flatten() {
                visit(tree, child, min_t, best);
            }
        }
    }
}
