use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, (0, entry), min_t, None)
}

/// The nearest of the best hit so far and those in a node, which is entered at some t.
fn search(
    tree: &dyn RayTree,
    (node, entry): (usize, f64),
    min_t: f64,
    mut best: Option<Hit>,
) -> Option<Hit> {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return best;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let hits = members
                .iter()
                .filter_map(|&it| Some((it, tree.intersect_triangle(it, min_t)?)));
            for (object, intersection) in hits {
                if best.is_none_or(|hit| intersection.t < hit.intersection.t) {
                    best = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
            best
        }
        Node::Branch([a, b]) => {
            let first = tree.enter_box(a, min_t, bound).map(|t| (a, t));
            let second = tree.enter_box(b, min_t, bound).map(|t| (b, t));
            let (near, far) = match (first, second) {
                (Some(x), Some(y)) if x.1 > y.1 => (first, second),
                _ => (second, first),
            };
            for child in [near, far].into_iter().flatten() {
                best = search(tree, child, min_t, best);
            }
            best
        }
    }
}
