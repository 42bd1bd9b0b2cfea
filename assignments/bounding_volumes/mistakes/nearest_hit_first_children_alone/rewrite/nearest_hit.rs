use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    let mut far = f64::MAX;
    let mut waiting = vec![0];
    while let Some(node) = waiting.pop() {
        if tree.enter_box(node, min_t, far).is_none() {
            continue;
        }
        match tree.node(node) {
            Node::Branch(children) => waiting.push(children[0]),
            Node::Leaf(members) => {
                for &object in members {
                    let Some(intersection) = tree.intersect_triangle(object, min_t) else {
                        continue;
                    };
                    if intersection.t < far {
                        far = intersection.t;
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
