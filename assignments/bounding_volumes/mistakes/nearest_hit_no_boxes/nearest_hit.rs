use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    search(tree, 0, min_t)
}

fn search(tree: &dyn RayTree, node: usize, min_t: f64) -> Option<Hit> {
    match tree.node(node) {
        Node::Leaf(triangles) => {
            let mut nearest: Option<Hit> = None;
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
            nearest
        }
        Node::Branch([left, right]) => {
            let a = search(tree, left, min_t);
            let b = search(tree, right, min_t);
            match (a, b) {
                (Some(x), Some(y)) if y.intersection.t < x.intersection.t => Some(y),
                (None, _) => b,
                _ => a,
            }
        }
    }
}
