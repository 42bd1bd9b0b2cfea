use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut stack = vec![0];
    while let Some(node) = stack.pop() {
        let max_t = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
        match tree.node(node) {
            Node::Branch([left, right]) => {
                let to_left = tree.enter_box(left, min_t, max_t);
                let to_right = tree.enter_box(right, min_t, max_t);
                match (to_left, to_right) {
                    (Some(a), Some(b)) if a < b => stack.extend([right, left]),
                    (Some(_), Some(_)) => stack.extend([left, right]),
                    (Some(_), None) => stack.push(left),
                    (None, Some(_)) => stack.push(right),
                    (None, None) => {}
                }
            }
            Node::Leaf(triangles) => {
                for &object in triangles {
                    if let Some(intersection) = tree.intersect_triangle(object, min_t)
                        && nearest.is_none_or(|hit| intersection.t < hit.intersection.t)
                    {
                        nearest = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
        }
    }
    nearest
}
