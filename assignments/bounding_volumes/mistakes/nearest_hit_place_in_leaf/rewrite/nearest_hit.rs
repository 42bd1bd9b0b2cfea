use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, 0, entry, min_t, None)
}

fn search(
    tree: &dyn RayTree,
    node: usize,
    entry: f64,
    min_t: f64,
    mut best: Option<Hit>,
) -> Option<Hit> {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return best;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let mut k = 0;
            while k < members.len() {
                let hit = tree.intersect_triangle(members[k], min_t);
                let limit = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
                if let Some(intersection) = hit.filter(|hit| hit.t < limit) {
                    best = Some(Hit {
                        object: k,
                        intersection,
                    });
                }
                k += 1;
            }
        }
        Node::Branch([a, b]) => {
            let mut children = [a, b].map(|it| (it, tree.enter_box(it, min_t, bound)));
            if let [(_, Some(x)), (_, Some(y))] = children
                && y <= x
            {
                children.reverse();
            }
            for (child, t) in children {
                if let Some(t) = t {
                    best = search(tree, child, t, min_t, best);
                }
            }
        }
    }
    best
}
