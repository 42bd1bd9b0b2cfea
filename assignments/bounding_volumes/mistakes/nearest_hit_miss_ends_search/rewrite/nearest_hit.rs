use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    match tree.enter_box(0, min_t, f64::MAX) {
        None => None,
        Some(_) => best_of(tree, 0, min_t, f64::MAX),
    }
}

fn best_of(tree: &dyn RayTree, node: usize, min_t: f64, bound: f64) -> Option<Hit> {
    let children = match tree.node(node) {
        Node::Branch(children) => children,
        Node::Leaf(members) => {
            let mut best: Option<Hit> = None;
            for &object in members {
                if let Some(intersection) = tree.intersect_triangle(object, min_t)
                    && best.is_none_or(|hit| hit.intersection.t > intersection.t)
                {
                    best = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
            return best;
        }
    };
    let entry = children.map(|child| tree.enter_box(child, min_t, bound).unwrap_or(f64::INFINITY));
    let near = usize::from(entry[1] < entry[0]);
    let far = 1 - near;
    if entry[near] == f64::INFINITY {
        return None;
    }
    let first = best_of(tree, children[near], min_t, bound);
    first.map(|hit| {
        if entry[far] > hit.intersection.t {
            return hit;
        }
        let second = best_of(tree, children[far], min_t, hit.intersection.t);
        second
            .filter(|it| it.intersection.t < hit.intersection.t)
            .unwrap_or(hit)
    })
}
