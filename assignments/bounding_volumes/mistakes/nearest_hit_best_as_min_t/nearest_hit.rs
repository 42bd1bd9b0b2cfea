use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut min_t = min_t;
    let mut nearest = None;
    visit(tree, 0, &mut min_t, &mut nearest);
    nearest
}

fn visit(tree: &dyn RayTree, node: usize, min_t: &mut f64, nearest: &mut Option<Hit>) {
    if tree.enter_box(node, *min_t, f64::INFINITY).is_none() {
        return;
    }
    match tree.node(node) {
        Node::Leaf(triangles) => {
            for &object in triangles {
                if let Some(intersection) = tree.intersect_triangle(object, *min_t) {
                    *min_t = intersection.t;
                    *nearest = Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
        Node::Branch([left, right]) => {
            visit(tree, left, min_t, nearest);
            visit(tree, right, min_t, nearest);
        }
    }
}
