use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    tree.enter_box(0, min_t, f64::INFINITY)?;
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
            let to_left = tree.enter_box(left, min_t, f64::INFINITY);
            let to_right = tree.enter_box(right, min_t, f64::INFINITY);
            match (to_left, to_right) {
                (Some(a), Some(b)) => {
                    let (near, far) = if b < a { (right, left) } else { (left, right) };
                    search(tree, near, min_t).or_else(|| search(tree, far, min_t))
                }
                (Some(_), None) => search(tree, left, min_t),
                (None, Some(_)) => search(tree, right, min_t),
                (None, None) => None,
            }
        }
    }
}
