use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    search(tree, 0, min_t, f64::INFINITY)
}

fn search(tree: &dyn RayTree, node: usize, min_t: f64, max_t: f64) -> Option<Hit> {
    tree.enter_box(node, min_t, max_t)?;
    let mut nearest: Option<Hit> = None;
    let mut keep = |hit: Hit| {
        if nearest.is_none_or(|best| hit.intersection.t < best.intersection.t) {
            nearest = Some(hit);
        }
    };
    match tree.node(node) {
        Node::Leaf(triangles) => {
            for &object in triangles {
                if let Some(intersection) = tree.intersect_triangle(object, min_t) {
                    keep(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
        Node::Branch([left, right]) => {
            if let Some(hit) = search(tree, left, min_t, max_t) {
                keep(hit);
            }
            if let Some(hit) = search(tree, right, min_t, max_t) {
                keep(hit);
            }
        }
    }
    nearest
}
