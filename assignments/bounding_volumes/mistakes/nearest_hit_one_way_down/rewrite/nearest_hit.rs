use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let start = tree.enter_box(0, min_t, f64::MAX);
    start.and_then(|_| descend(tree, 0, min_t))
}

fn descend(tree: &dyn RayTree, node: usize, min_t: f64) -> Option<Hit> {
    match tree.node(node) {
        Node::Branch(children) => {
            let entered = children
                .into_iter()
                .filter_map(|child| Some((tree.enter_box(child, min_t, f64::MAX)?, child)));
            let nearer = entered.reduce(|a, b| if b.0 < a.0 { b } else { a })?;
            descend(tree, nearer.1, min_t)
        }
        Node::Leaf(members) => {
            let mut nearest: Option<Hit> = None;
            for &object in members {
                if let Some(intersection) = tree.intersect_triangle(object, min_t)
                    && nearest.is_none_or(|hit| hit.intersection.t > intersection.t)
                {
                    nearest = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
            nearest
        }
    }
}
