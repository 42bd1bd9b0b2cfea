use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    let mut bound = f64::INFINITY;
    let mut stack = Vec::new();
    stack.extend(tree.enter_box(0, min_t, bound).map(|t| (0, t)));
    while let Some((node, entry)) = stack.pop() {
        if entry > bound {
            continue;
        }
        match tree.node(node) {
            Node::Branch([a, b]) => {
                let Some(t_a) = tree.enter_box(a, min_t, bound) else {
                    continue;
                };
                let Some(t_b) = tree.enter_box(b, min_t, bound) else {
                    continue;
                };
                if t_a < t_b {
                    stack.extend([(b, t_b), (a, t_a)]);
                } else {
                    stack.extend([(a, t_a), (b, t_b)]);
                }
            }
            Node::Leaf(members) => {
                for &object in members {
                    let hit = tree.intersect_triangle(object, min_t);
                    if let Some(intersection) = hit.filter(|hit| hit.t < bound) {
                        bound = intersection.t;
                        best = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
        }
    }
    best
}
