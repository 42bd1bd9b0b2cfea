use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut nearest = None;
    visit(tree, 0, min_t, &mut nearest);
    nearest
}

fn visit(tree: &dyn RayTree, node: usize, min_t: f64, nearest: &mut Option<Hit>) {
    let max_t = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if tree.enter_box(node, min_t, max_t).is_none() {
        return;
    }
    match tree.node(node) {
        Node::Leaf(triangles) => {
            for &object in triangles {
                if let Some(intersection) = tree.intersect_triangle(object, min_t)
                    && nearest.is_none_or(|hit| intersection.t < hit.intersection.t)
                {
                    *nearest = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
        Node::Branch([left, right]) => {
            let entry = |child| tree.enter_box(child, min_t, max_t).unwrap_or(f64::INFINITY);
            let (near, far) = if entry(left) < entry(right) {
                (left, right)
            } else {
                (right, left)
            };
            visit(tree, near, min_t, nearest);
            visit(tree, far, min_t, nearest);
        }
    }
}
