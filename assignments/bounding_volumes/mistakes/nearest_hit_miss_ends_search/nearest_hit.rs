use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    tree.enter_box(0, min_t, f64::INFINITY)?;
    search(tree, 0, min_t, f64::INFINITY)
}

fn search(tree: &dyn RayTree, node: usize, min_t: f64, max_t: f64) -> Option<Hit> {
    match tree.node(node) {
        Node::Leaf(triangles) => {
            let hits = triangles.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
        }
        Node::Branch([left, right]) => {
            let mut entered = Vec::new();
            for child in [left, right] {
                if let Some(t) = tree.enter_box(child, min_t, max_t) {
                    entered.push((t, child));
                }
            }
            entered.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (_, near) = *entered.first()?;
            let nearest = search(tree, near, min_t, max_t)?;
            let Some(&(t, far)) = entered.get(1) else {
                return Some(nearest);
            };
            if t > nearest.intersection.t {
                return Some(nearest);
            }
            let other = search(tree, far, min_t, nearest.intersection.t);
            match other {
                Some(hit) if hit.intersection.t < nearest.intersection.t => Some(hit),
                _ => Some(nearest),
            }
        }
    }
}
