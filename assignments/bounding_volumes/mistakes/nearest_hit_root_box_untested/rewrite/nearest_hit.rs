use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    let mut bound = f64::INFINITY;
    let mut stack = vec![(0, min_t)];
    while let Some((node, entry)) = stack.pop() {
        if entry > bound {
            continue;
        }
        match tree.node(node) {
            Node::Leaf(members) => {
                for &object in members {
                    match tree.intersect_triangle(object, min_t) {
                        Some(intersection) if intersection.t < bound => {
                            bound = intersection.t;
                            best = Some(Hit {
                                object,
                                intersection,
                            });
                        }
                        _ => {}
                    }
                }
            }
            Node::Branch([a, b]) => {
                let first = tree.enter_box(a, min_t, bound).map(|t| (a, t));
                let second = tree.enter_box(b, min_t, bound).map(|t| (b, t));
                match (first, second) {
                    (Some(x), Some(y)) if y.1 < x.1 => stack.extend([x, y]),
                    (x, y) => stack.extend(y.into_iter().chain(x)),
                }
            }
        }
    }
    best
}
